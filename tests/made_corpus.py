#!/usr/bin/env python3
"""made_corpus.py PROFILES OUT: a stand-in for the folder of real profiles, for who has only this repository.

OUT/good holds the project's own profiles, OUT/bad what is broken in them, OUT/INDEX.tsv what their tables hold as this
program counts it. One file carries the lumens of the zonal rule, computed here.
"""
import math
import pathlib
import sys


def ies_numbers(text):
    begin = text.index("TILT=NONE") + len("TILT=NONE")
    return [float(word) for word in text[begin:].replace(",", " ").split()]


def index_row(name, text):
    if name.endswith(".ies"):
        numbers = ies_numbers(text)
        kind = {1: "C", 2: "B", 3: "A"}[int(numbers[5])]
        return [text.split("\n", 1)[0].strip(), kind, str(int(numbers[3])), str(int(numbers[4]))]
    lines = text.splitlines()
    symmetry, planes, gammas = (int(lines[i].strip()) for i in (2, 3, 5))
    stored = {0: planes, 1: 1, 2: planes // 2 + 1, 3: planes // 2 + 1, 4: planes // 4 + 1}[symmetry]
    return ["EULUMDAT", "C", str(gammas), str(stored)]


def zonal_lumens(text):
    """Of an axial profile of type C: the mean of a zone's two intensities times its solid angle."""
    numbers = ies_numbers(text)
    count = int(numbers[3])
    if numbers[4] != 1:
        raise SystemExit("the profile is not axial")
    angles = [math.radians(a) for a in numbers[13:13 + count]]
    candela = [numbers[2] * i for i in numbers[14 + count:14 + 2 * count]]
    return sum(0.5 * (candela[k] + candela[k + 1]) * 2.0 * math.pi * (math.cos(angles[k]) - math.cos(angles[k + 1]))
               for k in range(count - 1))


def broken(name, text):
    """What no reader can take, with a name for each."""
    stem, ending = name.rsplit(".", 1)
    yield f"{stem}-cut.{ending}", text[:int(0.6 * len(text))]
    yield f"{stem}-header.{ending}", text[:120]
    if ending == "ies":
        head, numbers = text.split("TILT=NONE", 1)
        words = numbers.split()
        for what, at, value in (("count", 3, "1000000000"), ("negative", 4, "-1"), ("type", 5, "7"), ("word", 20, "x")):
            yield f"{stem}-{what}.{ending}", head + "TILT=NONE\n" + "\n".join(words[:at] + [value] + words[at + 1:]) + "\n"
    else:
        lines = text.splitlines()
        for what, at, value in (("symmetry", 2, "9"), ("count", 5, "1000000000"), ("word", 5, "many")):
            yield f"{stem}-{what}.{ending}", "\r\n".join(lines[:at] + [value] + lines[at + 1:]) + "\r\n"


def main(profiles, out):
    good, bad = out / "good", out / "bad"
    for folder in (good, bad):
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.iterdir():
            old.unlink()
    rows = [["path", "", "", "", "", "version", "type", "n_vertical", "n_horizontal", "notes"]]
    for path in sorted(profiles.rglob("*")):
        if path.suffix not in (".ies", ".ldt"):
            continue
        folder = path.parent.relative_to(profiles)
        name = path.name if folder == pathlib.Path(".") else f"{folder.name}-{path.name}"
        text = path.read_bytes().decode("latin-1")
        if name == "downlight.ies":
            text = text.replace("TILT=NONE", f"[_ABSOLUTELUMENS] {round(zonal_lumens(text))}\r\nTILT=NONE", 1)
        (good / name).write_bytes(text.encode("latin-1"))
        rows.append([f"good/{name}", "", "", "", "", *index_row(name, text), "made"])
        if folder == pathlib.Path("."):
            for other, content in broken(name, text):
                (bad / other).write_bytes(content.encode("latin-1"))
    (out / "INDEX.tsv").write_text("".join("\t".join(row) + "\n" for row in rows), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
