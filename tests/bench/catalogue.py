#!/usr/bin/env python3
"""What a catalogue costs: processor time a file, peak memory, and the ratio to reading and writing the same bytes.

    python3 tests/bench/catalogue.py GONIO [GONIO_BEFORE] [--files 1000,10000] [--runs 3] [--only info,bake]

Builds nothing. Makes a catalogue of copies of profiles/*.ies and *.ldt in a temporary folder (--folder: where; memory,
for example /dev/shm, leaves the disk out), or of the files of --from, and runs each command on all of it. With two
programs the runs alternate, and what they write is compared byte by byte. The least processor time of all runs counts,
user and system together, since other work may share the machine. "the bytes": cat of the inputs and cp of what the
command wrote. Profiles of types A and B, which take far longer, are one in 50, as among real files (1 to 2 %). Peak
memory needs GNU time (/usr/bin/time).
"""

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
import time

TREE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GNU_TIME = "/usr/bin/time" if os.access("/usr/bin/time", os.X_OK) else None

COMMANDS = {
    "info --csv": ["info", "--csv"],
    "info": ["info"],
    "info --jsonl": ["info", "--jsonl"],
    "check": ["check"],
    "convert --to ies": ["convert", "--to", "ies", "-O", "OUT"],
    "convert --to ldt": ["convert", "--to", "ldt", "-O", "OUT"],
    "bake -s 64x32, EXR": ["bake", "-s", "64x32", "--to", "exr", "-O", "OUT"],
    "bake -s 64x64, PNG": ["bake", "-s", "64x64", "--normalize", "peak", "--to", "png", "-O", "OUT"],
    "import --to gltf": ["import", "--to", "gltf", "-O", "OUT"],
    "import --to blender": ["import", "--to", "blender", "-O", "OUT"],
}


def sources(folder):
    names = sorted(os.listdir(folder))
    files = [os.path.join(folder, name) for name in names if name.lower().endswith((".ies", ".ldt"))]
    if not files:
        sys.exit(f"error: no .ies or .ldt file in {folder}")
    return files


def is_native(content):
    """Whether an IES file is of type A or B: the sixth number after TILT=NONE is not 1."""
    _, _, numbers = content.partition(b"TILT=NONE")
    words = numbers.split()
    return len(words) > 5 and words[5] != b"1"


def make_catalogue(files, count, folder):
    """Copies with names of their own, a thousand in each folder; returns the list of them and their bytes."""
    contents = {False: [], True: []}
    for file in files:
        with open(file, "rb") as opened:
            content = opened.read()
        contents[is_native(content)].append((os.path.splitext(file)[1].lower(), content))
    names = []
    total = 0
    for i in range(count):
        native = not contents[False] or (i % 50 == 49 and bool(contents[True]))
        ending, content = contents[native][(i // 50 if native else i) % len(contents[native])]
        below = os.path.join(folder, f"{i // 1000:03}")
        os.makedirs(below, exist_ok=True)
        name = os.path.join(below, f"{i:06}{ending}")
        with open(name, "wb") as opened:
            opened.write(content)
        names.append(name)
        total += len(content)
    listed = os.path.join(folder, "list")
    with open(listed, "w", encoding="utf-8") as opened:
        opened.write("\n".join(names) + "\n")
    return listed, total


class Spent:
    def __init__(self, processor_s, elapsed_s, peak_kb, status):
        self.processor_s = processor_s
        self.elapsed_s = elapsed_s
        self.peak_kb = peak_kb
        self.status = status


def run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, peak_file=None):
    # The kernel counts the memory of this program too for what it starts itself, so a small one starts it.
    if peak_file:
        command = [GNU_TIME, "-f", "%M", "-o", peak_file] + command
    begin = time.monotonic()
    child = subprocess.Popen(command, stdin=stdin, stdout=stdout, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    elapsed = time.monotonic() - begin
    peak_kb = None
    if peak_file:
        with open(peak_file, encoding="ascii") as opened:
            peak_kb = int(opened.read().split()[-1])
    return Spent(usage.ru_utime + usage.ru_stime, elapsed, peak_kb, child.returncode)


def digest(folder, printed):
    """Of every byte that a command wrote, with the names of the files."""
    found = hashlib.sha256()
    for below, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            path = os.path.join(below, name)
            found.update(os.path.relpath(path, folder).encode())
            with open(path, "rb") as opened:
                found.update(opened.read())
    with open(printed, "rb") as opened:
        found.update(opened.read())
    return found.hexdigest()


def bytes_alone(listed, out, printed, copy):
    """Reading the inputs and writing what a command wrote."""
    with open(listed, "rb") as names:
        read = run(["xargs", "-d", "\\n", "cat"], stdin=names)
    os.makedirs(copy)
    wrote = run(["cp", "-r", out, printed, copy])
    shutil.rmtree(copy)
    return read.processor_s + wrote.processor_s


def measure(programs, listed, name, work, runs):
    best = [None] * len(programs)
    digests = set()
    least_bytes_s = float("inf")
    failed = False
    out = os.path.join(work, "out")
    printed = os.path.join(work, "printed")
    for attempt in range(runs):
        for which, program in enumerate(programs):
            shutil.rmtree(out, ignore_errors=True)
            os.makedirs(out)
            first, *options = COMMANDS[name]
            command = [program, first, "@" + listed, "-q"] + [out if option == "OUT" else option for option in options]
            with open(printed, "wb") as opened:
                spent = run(command, stdout=opened, peak_file=os.path.join(work, "peak") if GNU_TIME else None)
            failed = failed or spent.status not in (0, 1)
            if attempt == 0:
                digests.add(digest(out, printed))
            before = best[which]
            if before is None or spent.processor_s < before.processor_s:
                best[which] = spent
        least_bytes_s = min(least_bytes_s, bytes_alone(listed, out, printed, os.path.join(work, "copy")))
    shutil.rmtree(out, ignore_errors=True)
    return best, least_bytes_s, len(digests) == 1, failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gonio")
    parser.add_argument("before", nargs="?", help="another gonio, to compare with")
    parser.add_argument("--files", default="1000", help="how many; several numbers show whether memory is flat (1000)")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--only", default="", help="beginnings of the commands to run: info,bake")
    parser.add_argument("--from", dest="source", default=os.path.join(TREE, "profiles"), help="folder of the profiles")
    parser.add_argument("--folder", help="where the catalogue and what is written go (the system's temporary folder)")
    arguments = parser.parse_args()
    beginnings = tuple(arguments.only.split(","))
    names = [name for name in COMMANDS if name.startswith(beginnings)]
    if not names:
        sys.exit(f"error: no command begins with {arguments.only}; there are {', '.join(COMMANDS)}")
    programs = [program for program in (arguments.before, arguments.gonio) if program]
    columns = ["ms a file before", "ms a file"] if arguments.before else ["ms a file"]
    ok = True
    with tempfile.TemporaryDirectory(dir=arguments.folder) as work:
        for count in (int(text) for text in arguments.files.split(",")):
            listed, total = make_catalogue(sources(arguments.source), count, os.path.join(work, f"of-{count}"))
            print(f"{count} files of {total / count:.0f} bytes, least of {arguments.runs} runs\n")
            print(f"| command | {' | '.join(columns)} | the bytes, ms | times the bytes | MB | busy |"
                  + (" output |" if arguments.before else ""))
            print("|---" * (8 if arguments.before else 6) + "|")
            for name in names:
                best, least_bytes_s, same, failed = measure(programs, listed, name, work, arguments.runs)
                last = best[-1]
                cells = [f"{spent.processor_s / count * 1e3:.3f}" for spent in best]
                cells.append(f"{least_bytes_s / count * 1e3:.3f}")
                cells.append(f"{last.processor_s / least_bytes_s:.1f}")
                cells.append(f"{last.peak_kb / 1024:.1f}" if last.peak_kb else "–")
                cells.append(f"{100 * last.processor_s / last.elapsed_s / len(os.sched_getaffinity(0)):.0f} %")
                if arguments.before:
                    cells.append("the same" if same else "DIFFERS")
                if failed:
                    cells[-1] += ", FAILED"
                ok = ok and same and not failed
                print(f"| {name} | {' | '.join(cells)} |", flush=True)
            print()
            shutil.rmtree(os.path.join(work, f"of-{count}"))
    return 0 if ok else 1


if __name__ == "__main__":
    sys.exit(main())
