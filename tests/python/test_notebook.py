"""The README's programs, and the notebook: cell by cell, the last expression shown as a notebook does, and by nbconvert."""

import ast
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest


def shown(value):
    for name in ("_repr_svg_", "_repr_png_"):
        if hasattr(value, name):
            return getattr(value, name)()
    return repr(value)


def test_every_cell_runs(source, monkeypatch):
    monkeypatch.chdir(source)
    notebook = json.loads((source / "lib/python/first-light.ipynb").read_text())
    scope = {}
    pictures = []
    for cell in notebook["cells"]:
        if cell["cell_type"] != "code":
            continue
        body = ast.parse("".join(cell["source"])).body
        last = body.pop() if isinstance(body[-1], ast.Expr) else None
        exec(compile(ast.Module(body, []), "cell", "exec"), scope)
        if last is not None:
            pictures.append(shown(eval(compile(ast.Expression(last.value), "cell", "eval"), scope)))
    # README.md shows these numbers of `gonio probe`.
    assert [f"{value:.6g}" for value in (scope["lux"].min(), scope["lux"].mean(), scope["lux"].max())] == [
        "2.03023",
        "71.5171",
        "565.724",
    ]
    assert "<svg" in pictures[0]
    assert all(picture.startswith(b"\x89PNG") for picture in pictures[-2:])


def programs_of_the_readme():
    page = pathlib.Path(os.environ["GONIO_SOURCE"]) / "lib/python/README.md"
    return re.findall(r"```python\n(.*?)```", page.read_text(), re.S)


@pytest.mark.parametrize("number", range(len(programs_of_the_readme())))
def test_the_programs_of_the_readme_run(source, monkeypatch, number):
    monkeypatch.chdir(source)
    exec(compile(programs_of_the_readme()[number], "README.md", "exec"), {})


def test_nbconvert_executes_the_notebook(source, tmp_path):
    """As Jupyter runs it: with a kernel of its own, and the pictures in the file that it writes."""
    ready = subprocess.run([sys.executable, "-c", "import ipykernel, nbconvert"], capture_output=True)
    if ready.returncode != 0:
        pytest.skip("jupyter-nbconvert and python3-ipykernel are not installed")
    shutil.copytree(source / "profiles", tmp_path / "profiles")
    shutil.copy(source / "lib/python/first-light.ipynb", tmp_path)
    subprocess.run(
        [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output", "executed.ipynb"]
        + [str(tmp_path / "first-light.ipynb")],
        check=True,
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "HOME": str(tmp_path), "JUPYTER_PLATFORM_DIRS": "1"},
    )
    executed = json.loads((tmp_path / "executed.ipynb").read_text())
    shown = [output.get("data", {}) for cell in executed["cells"] for output in cell.get("outputs", [])]
    assert any("image/svg+xml" in data for data in shown)
    assert sum("image/png" in data for data in shown) >= 2
