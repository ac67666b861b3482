"""The module against a C++ program at a million points, in turns: the least times of several runs on one thread."""

import pathlib
import subprocess
import sys
import tempfile
import time

import gonio
import numpy as np

COUNT = 1_000_000
LIGHTS = {
    "point": gonio.Light("point", "800lm", position=(0, 0, 2)),
    "sphere": gonio.Light("sphere:r=10cm", "800lm", position=(0, 0, 2)),
    "rect": gonio.Light("rect:w=60cm,h=30cm", "800lm", position=(0, 0, 2)),
    "profile": gonio.Light("ies:profiles/downlight.ies", position=(0, 0, 2)),
}
MATERIALS = ["lambert:albedo=0.5", "ue4:roughness=0.4", "frostbite:smoothness=0.6,coat=1"]


def least(work):
    times = []
    for _ in range(5):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


def main():
    random = np.random.default_rng(1)
    positions = (random.uniform(-3.0, 3.0, (COUNT, 3)) * (1.0, 1.0, 0.1)).astype(np.float32)
    normals = random.normal(size=(COUNT, 3)) * (0.5, 0.5, 0.5) + (0.0, 0.0, 1.0)
    normals = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    eye = np.array([0.0, -0.6, 0.8], np.float32)
    by_columns = [np.asfortranarray(positions), np.asfortranarray(normals)]
    works = {
        name: (
            lambda light=light: gonio.illuminance(light, *by_columns, threads=1),
            lambda light=light: gonio.illuminance(light, positions, normals, threads=1),
        )
        for name, light in LIGHTS.items()
    }
    for text in MATERIALS:
        material = gonio.Material(text)
        works[text] = (
            lambda material=material: material.brdf(by_columns[1], eye, threads=1),
            lambda material=material: material.brdf(normals, eye, threads=1),
        )
    best = {name: [np.inf, np.inf, np.inf, np.inf] for name in works}
    with tempfile.TemporaryDirectory() as folder:
        points = pathlib.Path(folder) / "points"
        points.write_bytes(np.concatenate([positions.T, normals.T]).tobytes())
        for _ in range(6):
            for line in subprocess.check_output([sys.argv[1], points], text=True).splitlines():
                name, *seconds = line.rsplit(" ", 2)
                best[name][:2] = np.minimum(best[name][:2], [float(text) for text in seconds])
            for name, ways in works.items():
                best[name][2:] = np.minimum(best[name][2:], [least(work) for work in ways])
    print("| | C++, columns | Python | C++, rows | Python |\n|---|---|---|---|---|")
    for name, (cpp, cpp_rows, columns, rows) in best.items():
        print(f"| {name} | {cpp * 1e3:.2f} ms | {columns / cpp:.2f} | {cpp_rows * 1e3:.2f} ms | {rows / cpp_rows:.2f} |")


main()
