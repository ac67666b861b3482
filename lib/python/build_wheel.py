"""The build backend of pyproject.toml: CMake builds the module, and this packs it into a wheel (PEP 517, PEP 427)."""

from __future__ import annotations

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile
from typing import Dict, List, Optional

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FILES = ["__init__.py", "_errors.py", "_gonio.pyi", "_png.py", "py.typed"]


def _version() -> str:
    text = (ROOT / "lib/gonio/base/version.hpp").read_text()
    found = re.search(r'GONIO_VERSION_STRING "([^"]+)"', text)
    assert found
    return found.group(1)


def _build(settings: Dict[str, str]) -> pathlib.Path:
    """The folder of the compiled package."""
    folder = pathlib.Path(settings.get("build-dir", ROOT / "build" / "python")).resolve()
    if not (folder / "CMakeCache.txt").exists():
        subprocess.check_call(
            ["cmake", "-S", str(ROOT), "-B", str(folder), "-DCMAKE_BUILD_TYPE=Release", "-DGONIO_PYTHON=ON"]
            + ["-DGONIO_TOOL=OFF", "-DGONIO_MODULES=OFF", "-DBUILD_TESTING=OFF", f"-DPython_EXECUTABLE={sys.executable}"]
        )
    subprocess.check_call(
        ["cmake", "--build", str(folder), "--target", "gonio-python", "--parallel", str(os.cpu_count() or 1)]
    )
    return folder / "python" / "gonio"


def get_requires_for_build_wheel(config_settings: Optional[Dict[str, str]] = None) -> List[str]:
    return []


def build_wheel(
    wheel_directory: str,
    config_settings: Optional[Dict[str, str]] = None,
    metadata_directory: Optional[str] = None,
) -> str:
    package = _build(config_settings or {})
    version = _version()
    interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    tag = f"{interpreter}-{interpreter}-{platform}"
    info = f"gonio-{version}.dist-info"
    module = "_gonio" + str(sysconfig.get_config_var("EXT_SUFFIX"))
    contents = {f"gonio/{name}": (package / name).read_bytes() for name in [*FILES, module]}
    contents[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: gonio\nVersion: {version}\nLicense: Apache-2.0\n"
        "Summary: Photometric lights: units, measured profiles, exact illuminance, colours, textures and previews\n"
        "Requires-Python: >=3.9\nRequires-Dist: numpy\n"
    ).encode()
    contents[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: gonio\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    )
    contents[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    contents[f"{info}/NOTICE.cie-tables"] = (ROOT / "lib/gonio/color/data/NOTICE").read_bytes()
    record = ""
    for name, data in contents.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    contents[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    wheel = f"gonio-{version}-{tag}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in contents.items():
            archive.writestr(name, data)
    return wheel
