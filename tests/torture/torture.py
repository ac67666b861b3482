"""Cases of tests/torture.sh, which says how it is called."""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

import mutate
import whole

ROOT = pathlib.Path(__file__).resolve().parents[2]
GOOD = {0, 1, 2, 3, 4, 5}
LEFT_OVER = re.compile(r"(\.tmp|\.trial|\.part)$|^\.gonio-")
TIMEOUT = 60
NOBODY = 65534


class Ended:
    def __init__(self, status, out, err):
        self.status, self.out, self.err = status, out, err


def starved(pid, seconds):
    """Whether a process that takes long has had no more than that of processor time, and would go on."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return False
    used = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    return fields[0] in "RD" and used < seconds


class Case:
    """One folder, the commands that were run in it, and what was wrong."""

    def __init__(self, torture, kind, index):
        self.torture, self.kind, self.index = torture, kind, index
        self.rng = random.Random(f"{torture.seed}:{kind}:{index}")
        self.dir = pathlib.Path(tempfile.mkdtemp(prefix=f"{kind}-{index}-", dir=torture.work))
        self.commands, self.statuses, self.faults = [], [], []

    def write(self, name, data):
        path = self.dir / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        return name

    def run(self, *words, shell="", end="", stdin=b"", signals=None, user=False, timeout=TIMEOUT, quiet=False):
        """The tool with `words`; `shell` runs before it (ulimit), `end` behind it (redirections), in one sh -c.
        `signals`: (signal, seconds). `quiet` commands prepare, and are not looked at."""
        script = f'{shell}{"; " if shell else ""}exec "$@" {end}'
        command = ["sh", "-c", script, "sh", self.torture.gonio, *map(str, words)]
        if user:
            command = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", *command]
        shown = f"{shlex.join(['gonio', *map(str, words)])} {end}".rstrip()
        self.commands.append((f"({shell}; {shown})" if shell else shown) + (" # as nobody" if user else "") +
                             (f" # {signals[0].name} after {signals[1]:.4f} s" if signals else ""))
        environment = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "NO_COLOR": "1", "HOME": str(self.dir)}
        process = subprocess.Popen(command, cwd=self.dir, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, env=environment)
        if signals:
            timer = threading.Timer(signals[1], process.send_signal, [signals[0]])
            timer.start()
        out, err, ended = b"", b"", False
        for _ in range(10):  # a machine that is busy with others is waited for
            try:
                out, err = process.communicate(stdin, timeout=timeout)
                ended = True
                break
            except subprocess.TimeoutExpired:
                if not starved(process.pid, timeout / 2):
                    break
        if signals:
            timer.cancel()
        if not ended:
            process.kill()
            out, err = process.communicate()
            self.fault(f"takes more than {timeout} s")
            return Ended(None, out, err)
        ended = Ended(process.returncode, out, err)
        if not quiet:
            self.look_at(ended, signals[0] if signals else None, "2>&-" in end)
        return ended

    def look_at(self, ended, sent, deaf):
        self.statuses.append(ended.status)
        by_signal = sent is not None and ended.status in (-sent, 128 + sent)
        not_started = ended.status == 127 and b"error while loading shared libraries" in ended.err
        if by_signal or not_started:
            return
        if ended.status not in GOOD:
            self.fault(f"exit status {ended.status}" if ended.status >= 0 else signal.Signals(-ended.status).name)
        elif ended.status > 1 and not deaf and b"error" not in ended.err:
            self.fault(f"exit status {ended.status} without an error on stderr")

    def fault(self, what, more=""):
        self.faults.append((what, more))

    def bytes_of(self, folder="out"):
        top = self.dir / folder
        return {str(p.relative_to(top)): p.read_bytes() for p in sorted(top.rglob("*")) if p.is_file()}

    def profile_fault(self, path):
        ended = self.run("info", path, "-q", quiet=True)
        return None if ended.status == 0 else f"gonio info refuses it: {ended.err.decode(errors='replace').strip()}"

    def look_at_outputs(self, folder="out"):
        """Whole files, and no temporaries."""
        for name, data in self.bytes_of(folder).items():
            if LEFT_OVER.search(pathlib.PurePath(name).name):
                self.fault("a temporary is left", name)
                continue
            wrong = whole.fault_of(name, data, lambda n: self.profile_fault(f"{folder}/{n}"))
            if wrong:
                self.fault("an output is not whole", f"{name}: {wrong}")


class Job:
    """A command that writes several files. {v} is a or b: two inputs of the same names, so two sets of outputs."""

    def __init__(self, name, words, group):
        self.name, self.words, self.group = name, words, group

    def command(self, variant):
        return [word.replace("{v}", variant).replace("{lm}", {"a": "800lm", "b": "900lm"}[variant])
                for word in self.words]


def by_stem(name):
    base = pathlib.PurePath(name).name
    return None if base in ("README.md", "all.json") else base.split(".")[0]


def by_name(name):
    return name


def together(_):
    return "all"


JOBS = [
    Job("convert", ["convert", "{v}", "--to", "ldt", "-O", "out", "--overwrite", "-q"], by_name),
    Job("bake", ["bake", "{v}", "-s", "96x48", "-O", "out", "--overwrite", "--manifest", "out/all.json"], by_stem),
    Job("cube", ["bake", "{v}/street.ies", "--layout", "cube", "-s", "32x32", "--normalize", "peak", "-o", "out/cube.png"],
        together),
    Job("import", ["import", "{v}", "--to", "gltf,usd,pbrt,unity,raw", "-O", "out", "--overwrite", "-q"], by_stem),
    Job("sweep", ["preview", "--shape", "sphere:r=10cm", "--intensity", "{lm}", "--exposure", "5ev", "-s", "64x48",
                  "--sweep", "cct=2000K:8000K:4", "-O", "out", "--overwrite"], by_name),
    Job("export", ["preview", "{v}/street.ies", "-s", "64x48", "-o", "out/p.png", "--export", "out/scene.gltf", "-q"],
        together),
    Job("plot", ["plot", "{v}/street.ies", "-o", "out/d.svg"], together),
    Job("make", ["make", "downlight", "--lumens", "{lm}", "-o", "out/made.ies"], together),
]


class Torture:
    def __init__(self, options):
        self.seed, self.keep = options.seed, pathlib.Path(options.keep)
        self.work = pathlib.Path(tempfile.mkdtemp(prefix="gonio-torture-"))
        self.work.chmod(0o777)
        self.gonio = os.path.realpath(options.gonio)
        self.root = os.geteuid() == 0 and shutil.which("setpriv") is not None
        if self.root:  # nobody may not reach the build folder: a copy, with the modules beside it
            (self.work / "bin").mkdir()
            for file in [self.gonio, *pathlib.Path(self.gonio).parent.glob("gonio-*.so")]:
                shutil.copy2(file, self.work / "bin")
            self.gonio = str(self.work / "bin" / pathlib.Path(self.gonio).name)
        profiles = sorted((ROOT / "profiles").glob("*.*s")) + sorted((ROOT / "profiles").glob("*.ldt"))
        profiles += sorted((ROOT / "profiles").glob("*.xml"))
        corpus = pathlib.Path(os.environ.get("GONIO_CORPUS") or ROOT.parent / "shared" / "corpus")
        self.corpus = corpus if corpus.is_dir() else None
        if self.corpus:
            profiles += sorted(p for p in corpus.rglob("*.*") if p.suffix in (".ies", ".ldt", ".xml"))
        self.profiles = [(p.suffix, p.read_bytes()) for p in profiles if p.stat().st_size < 300_000]
        self.made, self.lock = {}, threading.RLock()
        self.seconds, self.no_disk = {}, False
        self.runs, self.statuses, self.faults = collections.Counter(), {}, {}
        self.notes = []

    def inputs(self, case):
        """Folders a and b: the same names, other light."""
        for variant, factor in (("a", None), ("b", b"0.5")):
            for name in ("street", "downlight"):
                data = (ROOT / "profiles" / f"{name}.ies").read_bytes()
                if factor:  # the multiplier of the tenth line's third number
                    data = re.sub(rb"(?m)^(1 \S+) 1 ", rb"\1 " + factor + b" ", data, count=1)
                case.write(f"{variant}/{name}.ies", data)
        (case.dir / "out").mkdir(exist_ok=True)

    def reference(self, job, variant):
        """What a job writes when nothing goes wrong: name → bytes."""
        with self.lock:
            key = job.name, variant
            if key not in self.made:
                case = Case(self, "reference", f"{job.name}-{variant}")
                self.inputs(case)
                begin = time.monotonic()
                ended = case.run(*job.command(variant), quiet=True)
                self.seconds[job.name] = time.monotonic() - begin
                if ended.status != 0:
                    sys.exit(f"{case.commands[-1]} fails by itself, exit status {ended.status}:\n"
                             f"{ended.err.decode(errors='replace')}")
                self.made[key] = case.bytes_of(), ended.out
            return self.made[key]

    def job_seconds(self, job):
        self.reference(job, "b")
        return self.seconds[job.name]

    def no_disk_for(self, kind):
        return kind == "disk" and self.no_disk

    def kept(self, case):
        """Adds a case up; its files are kept where it shows a fault for the first time."""
        with self.lock:
            self.runs[case.kind] += 1
            self.statuses.setdefault(case.kind, collections.Counter()).update(case.statuses)
            for what, more in case.faults:
                places = self.faults.setdefault((case.kind, what), [])
                places.append(case.index)
                if len(places) > 1:
                    continue
                folder = self.keep / f"{case.kind}-{case.index}"
                if not folder.exists():
                    shutil.copytree(case.dir, folder, symlinks=True, ignore_dangling_symlinks=True,
                                    ignore=lambda d, names: [n for n in names if not os.path.isfile(os.path.join(d, n))
                                                             and not os.path.isdir(os.path.join(d, n))])
                    (folder / "commands.txt").write_text("\n".join(case.commands) + "\n", errors="replace")
                self.notes.append(f"{case.kind}: {what}{': ' + more[:300] if more else ''}\n"
                                  f"  (cd {shlex.quote(str(folder))} && {case.commands[-1][:1500]})\n"
                                  f"  again: --seed {self.seed} --only {case.kind}:{case.index}")
        shutil.rmtree(case.dir, ignore_errors=True)


def start_with(case, job, old):
    """The job's inputs, and in out/ what an earlier run wrote: of variant a, or nothing. The bytes that were there."""
    case.torture.inputs(case)
    before = case.torture.reference(job, "a")[0] if old else {}
    for name, data in before.items():
        case.write(f"out/{name}", data)
    bystander = case.rng.choice(["x.tmp", "p.png.trial", "cube.png.1-0.tmp", "street.exr.trial", "notes"])
    case.write(f"out/{bystander}", b"not gonio's\n")
    return before, bystander


def compare_outputs(case, job, before, bystander, finished, sets=True):
    """Every file is the old or the new one, every set of files one of both, and nothing else is there."""
    after, new = case.bytes_of(), case.torture.reference(job, "b")[0]
    if after.pop(bystander, None) != b"not gonio's\n":
        case.fault("a file of others is gone or changed", bystander)
    groups = {}
    for name in sorted(set(after) | set(new) | set(before)):
        data, group = after.get(name), job.group(name)
        if name not in new and name not in before:
            case.fault("a temporary is left" if LEFT_OVER.search(name) else "an unexpected output", name)
            continue
        if data is None:
            if name in before:
                case.fault("an earlier output is deleted", name)
                continue
            state = "old"
        elif data == new.get(name):
            state = "both" if data == before.get(name) else "new"
        elif data == before.get(name):
            state = "old"
        elif group is None:  # a manifest says what failed, too
            state = "both"
            wrong = whole.fault_of(name, data, lambda _: None)
            if wrong:
                case.fault("an output is not whole", f"{name}: {wrong}")
        else:
            case.fault("an output is not whole", f"{name}: {len(data)} bytes, not {len(new.get(name, b''))}")
            continue
        if finished and state == "old" and data != new.get(name):
            case.fault("exit status 0 without all outputs", name)
        if group is not None and state != "both":
            groups.setdefault(group, {}).setdefault(state, []).append(name)
    for states in groups.values():
        if sets and len(states) > 1:
            case.fault("a set is half old, half new", f"old {states['old']}, new {states['new']}")


# ---- the kinds -------------------------------------------------------------------------------------------------------

def profiles(case):
    rng, torture = case.rng, case.torture
    suffix, data = rng.choice(torture.profiles)
    others = [d for s, d in rng.sample(torture.profiles, 3) if s == suffix]
    lamp = case.write("lamp" + suffix, mutate.mutated(rng, data, others))
    case.write("other" + suffix, data)
    (case.dir / "out").mkdir()
    new = rng.choice(["ies", "ldt", "xml"])
    words = rng.choice([
        ["info", lamp, "--json"], ["info", lamp], ["check", lamp, "--json"], ["check", lamp, "--strict"],
        ["info", "-"], ["info", lamp, "--from", rng.choice(["ies", "ldt", "tm33"])],
        ["convert", lamp, "-o", f"out/new.{new}"], ["convert", lamp, "-o", f"out/new.{new}"],
        ["convert", lamp, "-o", "out/new.ies", "--dialect", rng.choice(["portable", "lm-63-1995", "lm-63-2019"])],
        ["edit", lamp, "--" + rng.choice(["rotate=90deg", "symmetrize=axial", "dim=0.5", "lumens=1000lm",
                                          "resample=15deg,5deg", "mirror=c0-180"]), "-o", f"out/new.{new}"],
        ["sample", lamp, "--at", f"{rng.uniform(-400, 400):.3f},{rng.uniform(0, 180):.3f}"],
        ["compare", lamp, "other" + suffix], ["plot", lamp, "-s", "200x200", "-o", "out/d.svg", "--diagram",
                                              rng.choice(["polar", "cartesian", "heat-map", "isolux", "cone"])],
        ["bake", lamp, "-s", "24x12", "-o", "out/t.exr"], ["bake", lamp, "-s", "16x16", "--layout",
                                                          "octahedral", "-o", "out/t.png", "--normalize", "peak"],
        ["import", lamp, "--to", "gltf,raw,usd", "-O", "out"], ["import", lamp, "--to", "unity,pbrt,blender", "-O", "out"],
        ["probe", lamp, "--position", "0,0,3", "--at", "1,0,0", "--json"],
        ["preview", lamp, "-s", "24x16", "-o", "out/p.png"],
        ["preview", "--shape", f"spot:outer=40deg,mask={lamp}", "--intensity", "800lm", "-s", "24x16", "-o", "out/p.exr"],
    ])
    case.run(*words, stdin=(case.dir / lamp).read_bytes() if "-" in words else b"")
    case.look_at_outputs()


def rigs(case):
    rng = case.rng
    seeds = [json.loads(p.read_bytes()) for p in sorted((ROOT / "tests/fuzz/seeds/rig").glob("*.json"))
             if not p.name.startswith("found-")]
    seeds.append({"schema": "gonio.rig/1", "lights": [
        {"name": "a", "shape": "ies:lamp.ies", "position": [0, 0, 2]},
        {"shape": "disk:r=10cm,mask=lamp.ies", "intensity": "800lm", "color": "spectrum:s.csv"}], "stage": "wall"})
    case.write("lamp.ies", (ROOT / "profiles/street.ies").read_bytes())
    case.write("s.csv", "".join(f"{nm},{nm % 7 + 1}\n" for nm in range(380, 785, 5)).encode())
    rig = case.write("rig.json", mutate.mutated_json(rng, rng.choice(seeds)))
    (case.dir / "out").mkdir()
    words = rng.choice([
        ["probe", "--rig", rig, "--at", "0.3,0.2,0", "--json"],
        ["probe", "--rig", rig, "--grid", "-1,-1,0:2,0,0:0,2,0:3x3"],
        ["preview", "--rig", rig, "-s", "24x16", "-o", "out/p.png", "-q"],
        ["preview", "--rig", rig, "-n", "-o", "out/p.png"],
        ["preview", "--rig", rig, "-q", "--export", "out/scene." + rng.choice(["gltf", "usda", "pbrt", "xml", "py"])],
        ["import", rig, "--to", "gltf,usd,mitsuba", "-O", "out", "-q"],
        ["probe", "--rig", "-", "--at", "0,0,0"],
    ])
    case.run(*words, stdin=(case.dir / rig).read_bytes() if "-" in words else b"")
    case.look_at_outputs()


def tables(case):
    rng = case.rng
    web = "C,0,30,60,90\n0,100,80,40,0\n45,100,85,50,0\n90,100,90,60,0\n"
    points = "x,y,z,nx,ny,nz\n0,0,0,0,0,1\n1,2,0.5,0,0,1\n-1,0,0,0,1,0\n"
    spectrum = "nm,power\n" + "".join(f"{nm},{1 + nm % 50}\n" for nm in range(380, 785, 5))
    pairs = "0,0\n10,20\n355.5,89\n"
    text, words = rng.choice([
        (web, ["make", "csv:table.csv", "-o", "out/new." + rng.choice(["ies", "ldt", "xml"])]),
        (points, ["probe", "--shape", "point", "--intensity", "100cd", "--position", "0,0,2", "--points", "table.csv"]),
        (spectrum, ["cct", "--spectrum", "table.csv"]),
        (spectrum, ["units", "60W@spectrum:table.csv", "--to", "lm"]),
        (pairs, ["sample", str(ROOT / "profiles/street.ies"), "-"]),
    ])
    data = mutate.mutated(rng, text.encode(), [web.encode(), points.encode()])
    case.write("table.csv", data)
    (case.dir / "out").mkdir()
    case.run(*words, stdin=data if "-" in words else b"")
    case.look_at_outputs()


def records(case):
    """What gonio wrote beside its outputs, spoiled, and then asked for what is up to date."""
    rng = case.rng
    job = rng.choice(JOBS[1:2] + JOBS[3:4])
    case.torture.inputs(case)
    for name, data in case.torture.reference(job, "a")[0].items():
        case.write(f"out/{name}", data)
    names = [n for n in case.torture.reference(job, "a")[0] if n.endswith(".json")]
    name = rng.choice(names)
    tree = json.loads((case.dir / "out" / name).read_bytes())
    case.write(f"out/{name}", mutate.mutated_json(rng, tree))
    bystander = case.write("out/notes", b"not gonio's\n")
    words = [w for w in job.command("a") if w != "--overwrite"] + ["-u"]
    if name == "all.json" and rng.random() < 0.5:
        words = ["bake", "--merge", "out/all.json", "-o", "out/merged.json"]
    case.run(*words)
    if (case.dir / bystander).read_bytes() != b"not gonio's\n":
        case.fault("a file of others is gone or changed", bystander)
    spoiled = (case.dir / "out" / name).read_bytes()
    if words[1] != "--merge" and case.statuses == [0] and rng.random() < 0.5:
        for other, data in case.torture.reference(job, "a")[0].items():
            found = case.dir / "out" / other
            if other != name and job.group(other) and (not found.is_file() or found.read_bytes() != data) and spoiled:
                case.fault("exit status 0, but an output is not the one to be", other)


def closed(case):
    """Descriptors that whoever started the tool has closed, or a full device behind them."""
    rng = case.rng
    job = rng.choice(JOBS)
    before, bystander = start_with(case, job, rng.random() < 0.7)
    end = " ".join(sorted(set(rng.choice([["2>&-"], [">&-"], ["<&-"], ["<&-", ">&-", "2>&-"], [">&-", "2>&-"],
                                         ["<&-", "2>&-"], ["<&-", ">&-"], ["2>/dev/full"], [">/dev/full"]]))))
    words = job.command("b") + rng.choice([[], ["-v"], ["--json"]] if job.name not in ("plot", "make") else [[]])
    ended = case.run(*words, end=end)
    if ended.status is None:
        return
    silent = "--json" not in words
    if ended.status != 0 and silent:
        case.fault("fails though nothing was to be said there", ended.err.decode(errors="replace").strip())
    if ended.status == 0 and not silent and (">&-" in end.replace("2>&-", "") or ">/dev/full" in end.replace("2>", "")):
        case.fault("exit status 0 though the report was lost")
    compare_outputs(case, job, before, bystander, True)


def inputs_as_outputs(case):
    """An output that is an input, by its name, a link or another way to write it."""
    rng, torture = case.rng, case.torture
    torture.inputs(case)
    case.write("rig.json", b'{"schema":"gonio.rig/1","lights":[{"shape":"ies:a/street.ies","position":[0,0,3]}]}')
    case.write("rig2.gltf", b'{"schema":"gonio.rig/1","lights":[{"shape":"ies:a/street.ies","position":[0,0,3]}]}')
    case.write("t.csv", b"C,0,30,60,90\n0,100,80,40,0\n")
    case.write("p.csv", b"0,0,0\n1,0,0\n")
    case.write("raw/street.ies", (case.dir / "a/street.ies").read_bytes())
    os.symlink("a/street.ies", case.dir / "link.ies")
    os.link(case.dir / "a/downlight.ies", case.dir / "hard.ies")
    target = rng.choice(["a/street.ies", "./a/../a/street.ies", "link.ies", "a//street.ies"])
    source, words = rng.choice([
        ("a/street.ies", ["convert", "a/street.ies", "-o", target]),
        ("a/street.ies", ["convert", "a/street.ies", "--dialect", "portable", "-o", target]),
        ("a/street.ies", ["convert", "a", "--to", "ies", "-O", "a", "--overwrite", "-q"]),
        ("a/street.ies", ["edit", "a/street.ies", "--dim", "0.5", "-o", target]),
        ("a/downlight.ies", ["edit", "--sum", "a/street.ies", "a/downlight.ies", "-o", "hard.ies"]),
        ("a/street.ies", ["plot", "a/street.ies", "-o", target]),
        ("a/street.ies", ["preview", "a/street.ies", "-s", "24x16", "-o", target, "--to", "png"]),
        ("a/street.ies", ["bake", "a/street.ies", "-s", "24x12", "-o", target, "--to", "exr"]),
        ("a/street.ies", ["bake", "a/street.ies", "-s", "24x12", "-o", "out/t.exr", "--manifest", target]),
        ("rig2.gltf", ["preview", "--rig", "rig2.gltf", "--export", "rig2.gltf", "-q"]),
        ("rig.json", ["preview", "--rig", "rig.json", "-s", "24x16", "-o", "rig.json", "--to", "png", "-q"]),
        ("a/street.ies", ["preview", "--rig", "rig.json", "-s", "24x16", "-o", target, "--to", "png", "-q"]),
        ("t.csv", ["make", "csv:t.csv", "--to", "ies", "-o", "t.csv"]),
        ("raw/street.ies", ["import", "raw/street.ies", "--to", "raw", "-O", ".", "--overwrite", "-q"]),
        ("a/street.ies", ["preview", "a/street.ies", "b/street.ies", "--sheet", "-o", target, "--to", "png"]),
        ("a/street.ies", ["preview", "--shape", f"point:mask=a/street.ies", "--intensity", "9cd", "-s", "24x16", "-o",
                          target, "--to", "png"]),
    ])
    old = (case.dir / source).read_bytes()
    ended = case.run(*words)
    new = (case.dir / source).read_bytes() if (case.dir / source).exists() else None
    if new is None:
        case.fault("an input is deleted", source)
    elif ended.status != 0 and new != old:
        case.fault("an input is changed by a command that failed", source)
    elif new != old and not (words[0] in ("convert", "edit") and case.profile_fault(source) is None):
        case.fault("an input is overwritten with something else", f"{source} by {words[0]}")
    case.look_at_outputs()


SIGNALS = [signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP]


def signals(case):
    rng = case.rng
    job = rng.choice(JOBS)
    case.torture.reference(job, "b")
    before, bystander = start_with(case, job, rng.random() < 0.7)
    sent = rng.choice(SIGNALS)
    ended = case.run(*job.command("b"), "-j2" if job.name in ("bake", "import", "sweep") else "-v",
                     signals=(sent, rng.random() ** 2 * case.torture.job_seconds(job)))
    if sent == signal.SIGKILL:  # temporaries may stay, a set may be torn: files are whole all the same
        for path in list((case.dir / "out").rglob("*")):
            if path.is_file() and LEFT_OVER.search(path.name) and path.name != bystander:
                path.unlink()
    compare_outputs(case, job, before, bystander, ended.status == 0, sets=sent != signal.SIGKILL)


def side_by_side(case):
    """Several writers of the same outputs: whoever comes last wins, file by file."""
    rng = case.rng
    job = rng.choice(JOBS)
    before, bystander = start_with(case, job, False)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        for ended in [pool.submit(case.run, *job.command(rng.choice("ab"))) for _ in range(rng.choice([2, 3, 4]))]:
            if ended.result().status != 0:
                case.fault("fails beside another writer", ended.result().err.decode(errors="replace").strip())
    before = case.torture.reference(job, "a")[0]
    compare_outputs(case, job, before, bystander, False, sets=False)


def limits(case):
    rng = case.rng
    job = rng.choice(JOBS)
    before, bystander = start_with(case, job, rng.random() < 0.7)
    what = rng.choice("fvn" + ("u" if case.torture.root else ""))
    # Below its own size a program is killed by the kernel before it runs.
    least_kb = os.path.getsize(case.torture.gonio) // 1024 + 1024
    value = {"f": lambda: rng.choice([0, 1, 2, 4, 8, 16, 64]), "n": lambda: rng.randrange(3, 24),
             "v": lambda: least_kb + int(2 ** rng.uniform(10, 20)), "u": lambda: rng.randrange(1, 9)}[what]()
    if what == "u":
        for path in [case.dir, *case.dir.rglob("*")]:
            os.chown(path, NOBODY, NOBODY)
    ended = case.run(*job.command("b"), shell=f"ulimit -{what} {value}", user=what == "u")
    compare_outputs(case, job, before, bystander, ended.status == 0)


def disk(case):
    """Sets of outputs over earlier ones on a disk that has no room for them."""
    rng, torture = case.rng, case.torture
    job = rng.choice(JOBS)
    old, new = torture.reference(job, "a")[0], torture.reference(job, "b")[0]
    out = case.dir / "out"
    torture.inputs(case)
    page = 4096
    need = sum((len(d) + page - 1) // page + 1 for d in old.values()) + 12
    room = rng.randrange(0, sum((len(d) + page - 1) // page + 1 for d in new.values()) + 2)
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={(need + room) * page}", "gonio-torture", out],
                             capture_output=True, check=False).returncode == 0
    if not mounted:
        case.torture.no_disk = True
        return
    try:
        before, bystander = start_with(case, job, rng.random() < 0.8)
        with open(out / "filler", "wb") as filler:
            free = os.statvfs(out).f_bavail
            filler.write(b"\0" * page * max(0, free - room))
        ended = case.run(*job.command("b"))
        os.unlink(out / "filler")
        compare_outputs(case, job, before, bystander, ended.status == 0)
    finally:
        kept = case.bytes_of()
        subprocess.run(["umount", out], check=False)
        for name, data in kept.items():
            case.write(f"out/{name}", data)


def bench(case):
    """What is tried before minutes of measuring leaves nothing behind."""
    rng = case.rng
    case.torture.inputs(case)
    output = rng.choice(["out/b.csv", "out/b.svg", "out/b.json"])
    bystander = case.write(output + rng.choice([".trial", ".tmp"]), b"not gonio's\n")
    old = case.write(output, b"earlier\n") if rng.random() < 0.5 else None
    ended = case.run("bench", "--suite", rng.choice(["no such suite", "parse", "sphere"]), "--quick", "-o", output,
                     signals=(rng.choice(SIGNALS[1:]), rng.random() * 0.5))
    if not (case.dir / bystander).exists() or (case.dir / bystander).read_bytes() != b"not gonio's\n":
        case.fault("a file of others is gone or changed", bystander)
    if old and ended.status != 0 and (case.dir / old).read_bytes() != b"earlier\n":
        case.fault("an earlier output is changed by a command that did not finish", old)
    for path in (case.dir / "out").iterdir():
        if LEFT_OVER.search(path.name) and f"out/{path.name}" != bystander:
            case.fault("a temporary is left", path.name)


# Kind → share of the time.
KINDS = {"profiles": (profiles, 3), "rigs": (rigs, 2), "tables": (tables, 1), "records": (records, 1.5),
         "closed": (closed, 1), "inputs_as_outputs": (inputs_as_outputs, 1), "signals": (signals, 3),
         "side_by_side": (side_by_side, 1), "limits": (limits, 2), "disk": (disk, 1.5), "bench": (bench, 0.5)}


def one(torture, kind, index):
    case = Case(torture, kind, index)
    KINDS[kind][0](case)
    torture.kept(case)


def main():
    parser = argparse.ArgumentParser(prog="tests/torture.sh")
    parser.add_argument("gonio")
    parser.add_argument("seconds", nargs="?", type=float, default=600)
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--only", default="", metavar="KIND[:CASE]")
    parser.add_argument("--keep", default=str(ROOT / "build" / "torture"))
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended by a signal"))  # the folder of work goes all the same
    if options.seed is None:
        options.seed = int(time.time()) % 1_000_000
    only, _, index = options.only.partition(":")
    if only and only not in KINDS:
        sys.exit(f"there is no kind '{only}'; there are: {', '.join(KINDS)}")
    shutil.rmtree(options.keep, ignore_errors=True)
    os.makedirs(options.keep)
    torture = Torture(options)
    print(f"seed {options.seed}, {options.seconds:.0f} s, corpus: {torture.corpus or 'none'}", flush=True)
    kinds = {only: KINDS[only]} if only else KINDS
    shares = sum(share for _, share in kinds.values())
    try:
        for kind, (_, share) in kinds.items():
            begin = time.monotonic()
            if index:
                one(torture, kind, int(index))
            else:
                # Signals are timed: one at a time. The others side by side.
                workers = 1 if kind in ("signals", "disk", "bench") else os.cpu_count() or 1
                end = begin + options.seconds * share / shares
                counter = iter(range(1 << 40))

                def work(kind=kind, counter=counter, end=end):
                    while time.monotonic() < end and not torture.no_disk_for(kind):
                        with torture.lock:
                            number = next(counter)
                        one(torture, kind, number)

                with concurrent.futures.ThreadPoolExecutor(workers) as pool:
                    for done in [pool.submit(work) for _ in range(workers)]:
                        done.result()
            said = ", ".join(f"{count} × {status}" for status, count in
                             sorted(torture.statuses.get(kind, {}).items(), key=lambda item: str(item[0])))
            wrong = sum(len(set(places)) for (of, _), places in torture.faults.items() if of == kind)
            skipped = " (skipped: no tmpfs can be mounted here)" if torture.no_disk_for(kind) else ""
            print(f"{kind:18} {torture.runs[kind]:6} cases {wrong:5} faults   exit status {said}{skipped}", flush=True)
    finally:
        shutil.rmtree(torture.work, ignore_errors=True)
    for (kind, what), places in sorted(torture.faults.items()):
        print(f"\n{len(places):5} × {kind}: {what}; cases {', '.join(map(str, places[:8]))}")
    print("\nthe first of each:\n" if torture.notes else "\nnothing was wrong")
    print("\n".join(torture.notes))
    sys.exit(1 if torture.notes else 0)


if __name__ == "__main__":
    main()
