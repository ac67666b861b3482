#!/usr/bin/env python3
"""Whole commands of two builds of the tool in alternation, as a table in Markdown.

    python3 tests/bench/against.py BEFORE AFTER [--rounds N] [--only WORD]

BEFORE and AFTER are programs (against.sh builds both). Of each command the least elapsed time and the least processor
time of N rounds (5) count, the start of the process included. The ratios are those of AFTER to BEFORE; the last column
says whether both wrote the same bytes. --only: the rows that contain the word.
"""

import argparse
import json
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time

TREE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROFILES = os.path.join(TREE, "profiles")


def preview(stage, *more, shape="disk:r=25cm", size="512x512", bounces="off"):
    return ["preview", "--stage", stage, "--shape", shape, "--intensity", "800lm", "--bounces", bounces, "-s", size,
            "-q", "-o", "OUT.exr", *more]


def instruction_sets(program):
    """The wide ones of this machine: those that the tool accepts."""
    with tempfile.TemporaryDirectory() as folder:
        return [name for name in ("avx2", "avx512", "neon")
                if run(program, preview("floor", "--simd", name, size="8x8"), folder, "out") is not None]


def rig_of_points(file, count):
    numbers = random.Random(1)
    lights = [{"shape": "point", "intensity": f"{numbers.uniform(10, 1000):.3f}cd",
               "position": [round(numbers.uniform(-500, 500), 3), round(numbers.uniform(-500, 500), 3), 8.0]}
              for _ in range(count)]
    with open(file, "w", encoding="utf-8") as out:
        json.dump({"schema": "gonio.rig/1", "lights": lights}, out)


def rows(program, folder):
    """(what, arguments), to be run in `folder`."""
    for simd in instruction_sets(program):
        end = ("--simd", simd)
        yield f"floor, no shadows, {simd}", preview("floor", "--shadows", "off", *end)
        yield f"floor 1920×1080, {simd}", preview("floor", *end, size="1920x1080")
        for stage in ("corridor", "room", "spheres", "street", "card"):
            for shape, word in (("disk:r=25cm", "disk"), ("tube:r=3cm,l=1.2m", "tube")):
                yield f"{stage}, {word}, {simd}", preview(stage, *end, shape=shape)
    yield "room, bounced light", preview("room", bounces="all")
    yield "spheres, bounced light", preview("spheres", bounces="all")
    yield "picture as PNG", [*preview("room")[:-1], "OUT.png"]
    street = os.path.join(PROFILES, "street.ies")
    yield "bake 512×256, EXR", ["bake", street, "-s", "512x256", "-q", "-o", "OUT.exr"]
    yield "bake 2048×1024, EXR", ["bake", street, "-s", "2048x1024", "-q", "-o", "OUT.exr"]
    yield "import, glTF", ["import", street, "--to", "gltf", "-q", "-O", "OUT.folder"]
    yield "info, JSON", ["info", street, "--json"]
    rig_of_points(os.path.join(folder, "points.json"), 100000)
    yield "probe, 100,000 points", ["probe", "--rig", "points.json", "--at", "0,0,0"]


def run(program, arguments, folder, name):
    """Elapsed and processor time [ms], and what was written and said."""
    outputs = [os.path.join(folder, name + suffix) for suffix in (".exr", ".png")]
    for output in outputs:
        if os.path.exists(output):
            os.remove(output)
    made = os.path.join(folder, name + ".folder")
    shutil.rmtree(made, ignore_errors=True)
    os.mkdir(made)
    arguments = [a.replace("OUT", name) if a.startswith("OUT") else a for a in arguments]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.monotonic()
    done = subprocess.run([program, *arguments], capture_output=True, cwd=folder, check=False)
    elapsed = time.monotonic() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        return None
    outputs += sorted(os.path.join(parent, file) for parent, _, files in os.walk(made) for file in files)
    written = [done.stdout]
    for output in outputs:
        if os.path.exists(output):
            with open(output, "rb") as file:
                written.append(file.read())
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return 1e3 * elapsed, 1e3 * processor, b"".join(written)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", default="")
    wanted = parser.parse_args()
    programs = [os.path.abspath(wanted.before), os.path.abspath(wanted.after)]
    for program in programs:
        if not os.access(program, os.X_OK):
            sys.exit(f"error: {program} is not a program")
    print("| command | elapsed before | after | processor before | after | elapsed | processor | bytes |")
    print("|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for what, arguments in rows(programs[1], folder):
            if wanted.only not in what:
                continue
            least = [[float("inf")] * 2, [float("inf")] * 2]
            written = [b"", b""]
            failed = [False, False]
            for _ in range(wanted.rounds):
                for i, program in enumerate(programs):
                    result = run(program, arguments, folder, "out")
                    if result is None:
                        failed[i] = True
                        continue
                    least[i] = [min(a, b) for a, b in zip(least[i], result[:2])]
                    written[i] = result[2]
            if any(failed):
                which = " and ".join(name for name, has in zip(("before", "after"), failed) if has)
                print(f"| {what} | fails {which} | | | | | | |")
                continue
            same = written[0] == written[1]
            print(f"| {what} | {least[0][0]:.0f} ms | {least[1][0]:.0f} ms | {least[0][1]:.0f} ms | {least[1][1]:.0f} ms "
                  f"| {least[1][0] / least[0][0]:.2f} | {least[1][1] / least[0][1]:.2f} | {'same' if same else 'differ'} |",
                  flush=True)


if __name__ == "__main__":
    main()
