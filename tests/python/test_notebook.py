"""The README's program, and the notebook, cell by cell; the last expression of a cell is shown as a notebook does."""

import ast
import json
import re


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


def test_the_program_of_the_readme_runs(source, monkeypatch, capsys):
    monkeypatch.chdir(source)
    (program,) = re.findall(r"```python\n(.*?)```", (source / "lib/python/README.md").read_text(), re.S)
    exec(compile(program, "README.md", "exec"), {})
    assert "22515.8" in capsys.readouterr().out
