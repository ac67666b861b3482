"""What the tests of the Python module share. The build puts the package's folder on the path."""

import os
import pathlib

import pytest

import gonio


@pytest.fixture
def source() -> pathlib.Path:
    return pathlib.Path(os.environ["GONIO_SOURCE"])


@pytest.fixture
def profiles(source: pathlib.Path) -> pathlib.Path:
    return source / "profiles"


@pytest.fixture
def tool() -> pathlib.Path:
    """The command-line tool of the same build, which says the same."""
    path = pathlib.Path(os.environ["GONIO_TOOL"])
    if not path.exists():
        pytest.skip("the tool is not built")
    return path


@pytest.fixture
def modules(tool: pathlib.Path) -> None:
    """The modules for pictures, which are beside the tool in a build."""
    if not (tool.parent / "gonio-image.so").exists():
        pytest.skip("the modules for pictures are not built")
    gonio.set_module_folders([tool.parent])
