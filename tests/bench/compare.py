#!/usr/bin/env python3
"""Ratios of the Google Benchmark programs to their named baselines, and of one build to another.

    tests/bench/compare.py BUILD [OTHER] [--program NAME] [--filter REGEX] [--rounds N]

BUILD and OTHER are build folders of the preset `bench` (build/bench). Each program runs N times (5), the two builds in
turn, so that a machine that grows slower does so for both; what counts is the least processor time of a row. Printed
are its time, the ratio to its baseline in the same run (above 1: slower than the baseline), and OTHER's time over
BUILD's (above 1: BUILD is the faster one). No program may be missing in one build only.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

# What a row is divided by: the first rule whose pattern matches its name. The program's header says why.
BASELINES = {
    "sphere": [(r"^method/.*$", "method/exact/float"), (r"^(.*)/[^/]+$", r"\1/scalar")],
    "area": [(r"^([^/]+/[^/]+)/.*$", r"\1/exact/scalar")],
    "parse": [(r"^files/.*$", "files/bytes/real_time"), (r"^([^/]+)/.*$", r"\1/strtod")],
    "color": [(r"^inverse/.*$", "inverse/newton-on-sum"), (r"^[^/]+/(?!1nm)(.*)$", r"krystek/\1")],
    "units": [(r"^.*$", "baseline: 800 / 4 pi")],
    "bake": [(r"^(latlong-[^/]+)/.*$", r"\1/lookup"), (r"^.*$", "latlong-1024x512/lookup")],
    "material": [(r"^([^/]+)/.*$", r"\1/frostbite")],
}


def rows_of(program, pattern):
    command = [str(program), "--benchmark_format=json", "--benchmark_min_time=0.1"]
    if pattern:
        command.append("--benchmark_filter=" + pattern)
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    # The table of ratios that some programs print stands around the JSON.
    text = done.stdout
    if "{" not in text:
        return {}
    report, _ = json.JSONDecoder().raw_decode(text[text.index("{"):])
    unit = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    return {row["name"]: row["cpu_time"] * unit[row["time_unit"]] for row in report["benchmarks"]
            if row.get("run_type", "iteration") == "iteration"}


def least(into, rows):
    for name, time in rows.items():
        into[name] = min(time, into.get(name, time))


def baseline_of(kind, name):
    for pattern, target in BASELINES.get(kind, []):
        if re.match(pattern, name):
            return re.sub(pattern, target, name)
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("other", type=pathlib.Path, nargs="?")
    parser.add_argument("--program", help="only this one: sphere, area, parse, …")
    parser.add_argument("--filter", help="only rows whose name matches")
    parser.add_argument("--rounds", type=int, default=5)
    arguments = parser.parse_args()
    builds = [arguments.build] + ([arguments.other] if arguments.other else [])

    programs = sorted((arguments.build / "tests/bench").glob("gonio-bench-*"))
    kinds = [p.name.removeprefix("gonio-bench-") for p in programs if p.is_file()]
    if arguments.program:
        kinds = [kind for kind in kinds if kind == arguments.program]
    if not kinds:
        sys.exit(f"no benchmark program below {arguments.build}/tests/bench: build the preset `bench` first")

    for kind in kinds:
        times = [{} for _ in builds]
        for _ in range(max(arguments.rounds, 1)):
            for build, into in zip(builds, times):
                least(into, rows_of(build / "tests/bench" / f"gonio-bench-{kind}", arguments.filter))
        print(f"\n{kind}")
        print(f"  {'row':<56} {'ns':>12} {'to baseline':>12}" + (f" {'other/this':>12}" if arguments.other else ""))
        for name, time in times[0].items():
            base = times[0].get(baseline_of(kind, name) or "")
            ratio = f"{time / base:.3g}" if base else "-"
            line = f"  {name:<56} {time:>12.4g} {ratio:>12}"
            if arguments.other:
                other = times[1].get(name)
                line += f" {other / time:>12.3g}" if other else f" {'-':>12}"
            print(line)


if __name__ == "__main__":
    main()
