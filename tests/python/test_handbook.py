"""The Python of the handbook's page: what it prints is what the page shows."""

import doctest
import os
import pathlib
import re

SOURCE = pathlib.Path(os.environ["GONIO_SOURCE"])


def test_examples_print_what_the_page_shows(monkeypatch):
    monkeypatch.chdir(SOURCE)
    text = (SOURCE / ".handbook/pages/python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```pycon\n(.*?)^```$", text, re.M | re.S)
    assert len(blocks) >= 5
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "python.md", "python.md", 0)
    runner = doctest.DocTestRunner(verbose=False)
    report = []
    runner.run(test, out=report.append)
    assert runner.summarize(verbose=False).failed == 0, "".join(report)
