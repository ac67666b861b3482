"""Pictures for notebooks: PNG from arrays, without a picture library."""

from __future__ import annotations

import struct
import zlib
from typing import Any


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _png(pixels: Any, color_type: int) -> bytes:
    import numpy

    height, width = pixels.shape[:2]
    rows = numpy.zeros((height, 1 + pixels[0].size), numpy.uint8)
    rows[:, 1:] = pixels.reshape(height, -1)
    header = struct.pack(">IIBBBBB", width, height, 8, color_type, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + _chunk(b"IHDR", header)
        + _chunk(b"IDAT", zlib.compress(rows.tobytes()))
        + _chunk(b"IEND", b"")
    )


def _encoded(linear: Any) -> Any:
    """sRGB of IEC 61966-2-1, in 8 bits."""
    import numpy

    x = numpy.clip(linear, 0.0, 1.0)
    encoded = numpy.where(x <= 0.0031308, 12.92 * x, 1.055 * numpy.power(x, 1.0 / 2.4) - 0.055)
    return (encoded * 255.0 + 0.5).astype(numpy.uint8)


def srgb_png(linear: Any) -> bytes:
    """Linear Rec.709 (height, width, 3) in which 1 is white."""
    return _png(_encoded(linear), 2)


def grey_png(values: Any) -> bytes:
    """Values (height, width), the greatest of which is white."""
    greatest = float(values.max()) if values.size else 0.0
    return _png(_encoded(values / greatest if greatest > 0.0 else values), 0)
