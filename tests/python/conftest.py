"""What the tests of the Python module share. The build puts the package's folder on the path."""

import os
import pathlib

import pytest


@pytest.fixture
def source() -> pathlib.Path:
    return pathlib.Path(os.environ["GONIO_SOURCE"])


@pytest.fixture
def profiles(source: pathlib.Path) -> pathlib.Path:
    return source / "profiles"
