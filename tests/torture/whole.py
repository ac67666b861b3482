"""Whether a file that the tool wrote is whole: nothing cut off its end, nothing left empty."""

import json
import struct
import xml.etree.ElementTree
import zlib

BLOCK_LINES = {0: 1, 1: 1, 2: 1, 3: 16, 4: 32, 5: 16, 6: 32, 7: 32, 8: 32, 9: 256}  # OpenEXR, by compression


def png(data):
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        return "no PNG signature"
    at, kind = 8, b""
    while at < len(data):
        if at + 12 > len(data):
            return "a PNG chunk is cut off"
        size, kind = struct.unpack(">I4s", data[at: at + 8])
        body = data[at + 4: at + 8 + size]
        crc = data[at + 8 + size: at + 12 + size]
        if len(crc) < 4 or struct.unpack(">I", crc)[0] != zlib.crc32(body):
            return "a PNG chunk is damaged"
        at += 12 + size
    return None if kind == b"IEND" else "no IEND at the end of a PNG"


def exr(data):
    if data[:4] != b"\x76\x2f\x31\x01":
        return "no OpenEXR signature"
    if data[5] & 0x1A:  # tiled, deep or of several parts
        return None
    at, compression, low, high = 8, 0, 0, 0
    try:
        while data[at]:
            name_end = data.index(b"\0", at)
            type_end = data.index(b"\0", name_end + 1)
            size = struct.unpack("<i", data[type_end + 1: type_end + 5])[0]
            value = data[type_end + 5: type_end + 5 + size]
            if data[at:name_end] == b"compression":
                compression = value[0]
            if data[at:name_end] == b"dataWindow":
                _, low, _, high = struct.unpack("<4i", value)
            at = type_end + 5 + size
        per_block = BLOCK_LINES[compression]
        blocks = (high - low) // per_block + 1
        offsets = struct.unpack(f"<{blocks}Q", data[at + 1: at + 1 + 8 * blocks])
        last = max(offsets)
        size = struct.unpack("<i", data[last + 4: last + 8])[0]
    except (struct.error, ValueError, IndexError, KeyError):
        return "the header of an OpenEXR file is cut off"
    return None if last + 8 + size == len(data) and min(offsets) > at else "an OpenEXR file is cut off"


def json_text(data):
    try:
        json.loads(data)
    except ValueError as error:
        return f"broken JSON: {error}"
    return None


def xml_text(data):
    try:
        xml.etree.ElementTree.fromstring(data)
    except xml.etree.ElementTree.ParseError as error:
        return f"broken XML: {error}"
    return None


def glb(data):
    if data[:4] != b"glTF" or struct.unpack("<I", data[8:12])[0] != len(data):
        return "a GLB file is cut off"
    return None


READERS = {".png": png, ".exr": exr, ".json": json_text, ".gltf": json_text, ".svg": xml_text, ".xml": xml_text,
           ".glb": glb}
PROFILES = (".ies", ".ldt")


def fault_of(name, data, read_profile):
    """None, or what is wrong. `read_profile(name)` asks the tool about a profile."""
    if not data:
        return "empty"
    for end, reader in READERS.items():
        if name.endswith(end):
            return reader(data)
    if name.endswith(PROFILES):
        return read_profile(name)
    return None
