"""Every public function of the library that makes sense in Python is there.

The public functions are those that the shared library exports. What the module uses of them are the symbols that its
object files leave open. `lib/python/not_in_python.txt` names the others, each with the reason: a line is a function
(gonio::exposure::name), or a header, for all of its functions that are not used.

Inline functions and templates have no symbol of their own: they count by their header, which must be one that the
module's sources include, directly or through other headers, or be in the list.
"""

import os
import pathlib
import re
import subprocess

import pytest


def without_parameters(symbol):
    """gonio::Web::create of gonio::Web::create(gonio::Photometry, …) and of its other forms."""
    depth = 0
    name = ""
    for character in symbol.replace("(anonymous namespace)", "anonymous").replace("[abi:cxx11]", ""):
        if character == "(" and depth == 0:
            break
        depth += (character in "<(") - (character in ">)")
        if depth == 0 and character != ">":
            name += character
    return name


def is_function_of_gonio(name):
    last = name.rsplit("::", 1)[-1]
    return name.startswith("gonio::") and not last.startswith(("~", "operator")) and "anonymous" not in name


def symbols(arguments, files, kind):
    lines = subprocess.check_output(["nm", "-C", *arguments, *files], text=True).splitlines()
    found = [re.match(r"[0-9a-f ]*([A-Za-z]) (.*)", line) for line in lines]
    return {without_parameters(m.group(2)) for m in found if m and m.group(1) == kind and "(" in m.group(2)}


@pytest.fixture(scope="module")
def public():
    library = pathlib.Path(os.environ["GONIO_LIBRARY"])
    if not library.exists():
        pytest.skip("the shared library is not built (-DGONIO_SHARED=ON)")
    return {name for name in symbols(["-D", "--defined-only"], [library], "T") if is_function_of_gonio(name)}


@pytest.fixture(scope="module")
def used():
    objects = sorted(pathlib.Path(os.environ["GONIO_PYTHON_OBJECTS"]).glob("*.o"))
    assert objects
    return {name for name in symbols(["-u"], objects, "U") if is_function_of_gonio(name)}


def read_list(source):
    left_out = {}
    for line in (source / "lib/python/not_in_python.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, reason = line.split(None, 1)
            assert name not in left_out, f"{name} is there twice"
            left_out[name] = reason
    return left_out


def declares(header_text, function):
    """Whether the text declares a function, or the class that it is a member of."""
    parts = function.split("::")[1:]
    parent = parts[-2] if len(parts) > 1 else ""
    if re.search(rf"(class|struct) {parent}\b[^;]*\{{", header_text) if parent and parent[0].isupper() else False:
        return True
    return (not parent or not parent[0].isupper()) and re.search(rf"\b{parts[-1]}\(", header_text) is not None


def test_every_public_function_is_used_or_left_out_for_a_reason(source, public, used):
    headers = (source / "lib/cmake/public-headers.txt").read_text().split()
    texts = {header: (source / "lib" / header).read_text() for header in headers}
    left_out = read_list(source)
    unused = public - used
    named = {name for name in left_out if name.startswith("gonio::")}
    assert named - public == set(), "not a public function"
    assert named & used == set(), "used after all"
    missing = set()
    needed = set()
    for function in unused - named:
        at = [header for header in left_out if header in texts and declares(texts[header], function)]
        needed.update(at)
        if not at:
            missing.add(function)
    assert sorted(missing) == [], "neither used nor left out"
    assert {name for name in left_out if "/" in name} - set(texts) == set(), "not a public header"


def includes_of(path):
    return set(re.findall(r"#include <(gonio/[^>]+)>", path.read_text()))


def test_every_public_header_is_reached_or_left_out_for_a_reason(source):
    headers = set((source / "lib/cmake/public-headers.txt").read_text().split())
    to_read = set().union(*(includes_of(path) for path in (source / "lib/python/src").iterdir()))
    reached = set()
    while to_read:
        header = to_read.pop()
        reached.add(header)
        to_read |= includes_of(source / "lib" / header) - reached
    missing = headers - reached - set(read_list(source))
    assert sorted(missing) == [], "neither included nor left out"


def test_reasons_are_reasons(source):
    for name, reason in read_list(source).items():
        assert len(reason.split()) > 3 and "not yet" not in reason, name
