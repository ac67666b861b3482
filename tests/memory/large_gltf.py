"""Writes a glTF of 100,000 nodes, ten to a parent, with 1000 lights: large_gltf.py FILE.

    /usr/bin/time -v gonio lights FILE

states the time and the memory that reading takes.
"""
import json
import random
import sys

NODES = 100_000
random.seed(1)
lights = [
    {"type": "spot", "intensity": 100.0 + i, "spot": {"innerConeAngle": 0.3, "outerConeAngle": 0.6}}
    if i % 2
    else {"type": "point", "intensity": 100.0 + i}
    for i in range(50)
]
nodes = []
for i in range(NODES):
    node = {
        "name": f"node_{i}",
        "translation": [random.uniform(-5, 5) for _ in range(3)],
        "rotation": [0, 0, 0, 1],
        "scale": [1, 1, 1],
    }
    if 10 * i + 1 < NODES:
        node["children"] = list(range(10 * i + 1, min(10 * i + 11, NODES)))
    if i % 100 == 50:
        node["extensions"] = {"KHR_lights_punctual": {"light": i // 100 % 50}}
    else:
        node["mesh"] = i % 10
    nodes.append(node)
document = {
    "asset": {"version": "2.0"},
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": lights}},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": nodes,
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]} for _ in range(10)],
}
with open(sys.argv[1], "w", encoding="ascii") as file:
    json.dump(document, file, separators=(",", ":"))
