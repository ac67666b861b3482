"""Inputs made worse: bytes, lines and numbers of any text, and the tree of a JSON text."""

import json

EXTREME = ["-1", "0", "-0", "1e308", "-1e308", "1e-320", "1e999", "nan", "inf", "4294967296", "99999999999999999999",
           "360.0001", "1e9", "", "x", "\u00e9", "'", "0x10", "1,5", "100000", "65536", "2147483648"]
PATHS = ["../../../../etc/passwd", "/dev/zero", "/dev/null", "/dev/stdin", "/proc/self/mem", ".", "..", "/", "a/../b",
         "no such file", "lamp.ies/", "\u0000", "-", "~", "con.ies", "lamp.ies\n", "x" * 5000]


def some_bytes(rng, count):
    return bytes(rng.choice(b"0123456789.-+eE ,;:\n\r\t\"'{}[]<>=/\x00\xff\xfe\xc3\x80AZaz%()#") for _ in range(count))


def cut(rng, data):
    return data[: rng.randrange(len(data) + 1)]


def change(rng, data):
    at = rng.randrange(len(data) + 1)
    return data[:at] + some_bytes(rng, rng.choice([1, 1, 2, 8])) + data[at + rng.choice([0, 1, 1, 4]):]


def flip(rng, data):
    if not data:
        return data
    at = rng.randrange(len(data))
    return data[:at] + bytes([data[at] ^ (1 << rng.randrange(8))]) + data[at + 1:]


def remove(rng, data):
    at = rng.randrange(len(data) + 1)
    return data[:at] + data[at + rng.choice([1, 5, 50, 500]):]


def repeat(rng, data):
    at = rng.randrange(len(data) + 1)
    piece = data[at: at + rng.choice([1, 10, 100, 1000])]
    return data[:at] + piece * rng.choice([2, 3, 100]) + data[at:]


def lines(rng, data):
    rows = data.split(b"\n")
    a, b = rng.randrange(len(rows)), rng.randrange(len(rows))
    rows[a], rows[b] = rows[b], rows[a]
    return rng.choice([b"\n", b"\n", b"\r\n", b"\r", b" "]).join(rows)


def number(rng, data):
    words = data.split(b" ")
    places = [i for i, word in enumerate(words) if any(c in b"0123456789" for c in word)]
    if places:
        words[rng.choice(places)] = rng.choice(EXTREME).encode()
    return b" ".join(words)


def long_run(rng, data):
    at = rng.randrange(len(data) + 1)
    return data[:at] + rng.choice([b"0", b" ", b"[", b"9", b"\n", b"(", b"<a>", b"x", b"1 "]) * rng.choice(
        [1000, 100000]) + data[at:]


def name_file(rng, data):
    return data.replace(b"TILT=NONE", b"TILT=" + rng.choice(PATHS).encode(), 1)


BYTES = [cut, change, change, change, flip, flip, remove, repeat, lines, number, number, number, long_run, name_file]


def mutated(rng, data, others=()):
    """The bytes with one to a few faults; sometimes the head of them and the tail of another."""
    if others and rng.random() < 0.1:
        other = rng.choice(others)
        data = data[: rng.randrange(len(data) + 1)] + other[rng.randrange(len(other) + 1):]
    for _ in range(rng.choice([1, 1, 1, 1, 2, 4])):
        data = rng.choice(BYTES)(rng, data)
    return data


def places_in(tree):
    """Every (container, key) below a JSON value."""
    found = []
    rest = [tree]
    while rest:
        node = rest.pop()
        items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
        for key, value in items:
            found.append((node, key))
            rest.append(value)
    return found


def odd_value(rng):
    depth = rng.choice([3, 70, 3000])
    nested = 0
    for _ in range(depth):
        nested = [nested] if rng.random() < 0.5 else {"a": nested}
    return rng.choice([None, True, -1, 0, 1e308, -1e308, 5e-324, "", "x", [], {}, [0, 0, 0], [1, 2], nested,
                       "x" * 10000, [1] * 5000, 2**63, 1e-9, rng.choice(EXTREME), "ies:" + rng.choice(PATHS),
                       rng.choice(PATHS), "sphere:r=" + rng.choice(EXTREME) + "m", "spectrum:" + rng.choice(PATHS)])


def mutated_json(rng, tree):
    """The text of a tree with one to a few nodes replaced, removed or doubled; broken as bytes now and then."""
    tree = json.loads(json.dumps(tree))
    for _ in range(rng.choice([1, 1, 2, 4])):
        places = places_in(tree)
        if not places:
            break
        node, key = rng.choice(places)
        action = rng.random()
        if action < 0.4 and isinstance(node[key], (int, float)):
            node[key] = rng.choice([-1, 0, 0.5, 1e-6, 1e9]) * node[key] + rng.choice([0, 0, 1e-12])
        elif action < 0.4 and isinstance(node[key], str):
            node[key] = number(rng, node[key].replace("=", " ").encode()).replace(b" ", b"=").decode(errors="replace")
        elif action < 0.6:
            node[key] = odd_value(rng)
        elif action < 0.8:
            del node[key]
        elif isinstance(node, list):
            node.extend([node[key]] * rng.choice([1, 300]))
        else:
            node[str(key) + rng.choice(["", "2", "\u0000"])] = node[key]
    data = dump(tree).encode("utf-8", "replace")
    return mutated(rng, data) if rng.random() < 0.15 else data


def dump(tree):
    """json.dumps without its recursion limit: text of depth 3000 too."""
    text, stack = [], [("value", tree)]
    while stack:
        what, item = stack.pop()
        if what == "text":
            text.append(item)
        elif isinstance(item, dict):
            text.append("{")
            stack.append(("text", "}"))
            for i, (key, value) in enumerate(reversed(list(item.items()))):
                stack.append(("value", value))
                stack.append(("text", ("" if i + 1 == len(item) else ",") + json.dumps(str(key)) + ":"))
        elif isinstance(item, list):
            text.append("[")
            stack.append(("text", "]"))
            for i, value in enumerate(reversed(item)):
                stack.append(("value", value))
                stack.append(("text", "" if i + 1 == len(item) else ","))
        else:
            text.append(json.dumps(item))
    return "".join(text)
