"""Reads the tables that `gonio bake --table` writes with nothing of gonio: the bytes of each format by its
specification, and the lookups that it prints, compiled (those of shading languages as C++; GLSL and HLSL also by glslang if that is installed). Each is compared with the description in
the sidecar.

    reread.py GONIO C-COMPILER C++-COMPILER SOURCE-FOLDER
"""

import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile

try:
    import OpenImageIO as oiio
except ImportError:
    oiio = None  # EXR files are then not read

gonio, cc, cxx, here = sys.argv[1:5]
here = os.path.abspath(here)
gonio = os.path.abspath(gonio)
POSES = [(i + 0.5) / 211 for i in range(211)]
POSES = [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0), (1.0, 0.0)] + [(x, (0.5 + i * 0.6180339887) % 1) for i, x in enumerate(POSES)]
STEPS = {"uint16": 65535, "uint8": 255}
SIZES = {"float": 4, "half": 2, "rgb9e5": 4, "uint16": 2, "uint8": 1}
CODES = {"float": "f", "half": "e", "rgb9e5": "I", "uint16": "H", "uint8": "B"}
DXGI = {
    "R32G32_FLOAT": 16, "R32G32B32A32_FLOAT": 2, "R16G16_FLOAT": 34, "R16G16B16A16_FLOAT": 10,
    "R9G9B9E5_SHAREDEXP": 67, "R16G16_UNORM": 35, "R16G16B16A16_UNORM": 11, "R8G8_UNORM": 49, "R8G8B8A8_UNORM": 28,
}


def bake(options, output):
    subprocess.run([gonio, "bake", "--table", *options, "-o", output], check=True)


def components(data, pixel, channels):
    """Numbers of a texel's components: floats, and of integers 0 to 1."""
    numbers = struct.unpack(f"<{len(data) // SIZES[pixel]}{CODES[pixel]}", data)
    if pixel == "rgb9e5":
        return [((n >> 9 * c) & 511) * 2.0 ** ((n >> 27) - 24) for n in numbers for c in range(channels)]
    return [n / STEPS[pixel] for n in numbers] if pixel in STEPS else list(numbers)


def read_raw(path, side):
    """A list for each layer: its components."""
    with open(path, "rb") as file:
        data = file.read()
    texels = side["width"] * side["height"]
    layers, at = [], 0
    for channels in side["layers"]:
        size = texels * SIZES[side["pixel"]] * (1 if side["pixel"] == "rgb9e5" else channels)
        layers.append(components(data[at : at + size], side["pixel"], channels))
        at += size
    assert at == len(data) == side["data_bytes"], (at, len(data))
    return layers


def read_dds(path, side):
    with open(path, "rb") as file:
        data = file.read()
    assert data[:4] == b"DDS " and data[84:88] == b"DX10"
    assert struct.unpack("<II", data[12:20]) == (side["height"], side["width"])
    dxgi, _, _, count, _ = struct.unpack("<5I", data[128:148])
    assert dxgi == DXGI[side["dxgi_format"]] and count == len(side["layers"])
    wide = 4 if side["dxgi_format"].count("A") and "B" in side["dxgi_format"] else 2
    if side["pixel"] == "rgb9e5":
        wide = 1
    texels = side["width"] * side["height"]
    size = texels * wide * SIZES[side["pixel"]]
    assert len(data) == 148 + count * size
    layers = []
    for i, channels in enumerate(side["layers"]):
        block = data[148 + i * size : 148 + (i + 1) * size]
        every = channels if wide == 1 else wide
        read = components(block, side["pixel"], every)
        layers.append([read[t * every + c] for t in range(texels) for c in range(channels)])
    return layers


def bilinear(layer, channels, side, x, y, channel):
    width, height = side["width"], side["height"]
    x, y = min(max(x, 0), width - 1), min(max(y, 0), height - 1)
    left, top = int(x), int(y)
    right, bottom = min(left + 1, width - 1), min(top + 1, height - 1)

    def at(column, row):
        return layer[(row * width + column) * channels + channel]

    s, t = x - left, y - top
    return (1 - t) * ((1 - s) * at(left, top) + s * at(right, top)) + t * (
        (1 - s) * at(left, bottom) + s * at(right, bottom)
    )


def series(layer, channels, side, x, y, channel):
    def term(k, at):
        return math.cos(k * math.acos(min(max(2 * at - 1, -1), 1)))

    return sum(
        layer[(j * side["width"] + i) * channels + channel] * term(i, x) * term(j, y)
        for j in range(side["height"])
        for i in range(side["width"])
    )


def expected(layers, side, mu, roughness):
    x = mu if side["axes"]["name"] == "linear" else math.sqrt(mu)
    y = roughness
    if side["axes"]["name"] == "heitz":
        x, y = roughness, math.sqrt(1 - mu)
    values = {}
    for channel in side["channels"]:
        layer, count = layers[channel["layer"]], side["layers"][channel["layer"]]
        if side["form"] == "chebyshev":
            value = series(layer, count, side, x, y, channel["component"])
        elif side["axes"]["name"] == "linear":
            value = bilinear(layer, count, side, x * side["width"] - 0.5, y * side["height"] - 0.5, channel["component"])
        else:
            value = bilinear(layer, count, side, x * (side["width"] - 1), y * (side["height"] - 1), channel["component"])
        values[channel["name"]] = (channel["offset"] + channel["scale"] * value) ** channel["power"]
    if side["table"] == "ltc-heitz":
        return list(values.values())[:6]  # two are not of a pose
    if len(values) == 2:
        return list(values.values())
    s = math.sqrt((1 - mu) * (1 + mu))
    width = max(roughness * roughness, 1e-4) if side["table"] == "ltc-ggx" else 1.0
    m00 = max(values["along"] * mu + values["raised"] * s * s, 1e-18)
    m02 = (values["raised"] * mu - values["along"]) * s
    m20 = width * values["slant"] * s
    lobe = [m00, m02, values["across"], m20, width, m00 / math.hypot(m00, m20), values["albedo"]]
    return lobe + ([values["grazing"]] if "grazing" in values else [])


def run(command, poses):
    text = "".join(f"{mu:.9g} {roughness:.9g}\n" for mu, roughness in poses)
    lines = subprocess.run(command, input=text, check=True, capture_output=True, text=True).stdout.splitlines()
    return [[float(word) for word in line.split()] for line in lines]


def compare(what, found, wanted):
    assert len(found) == len(wanted), what
    worst = 0.0
    for a, b in zip(found, wanted):
        assert len(a) == len(b), what
        worst = max([worst] + [abs(x - y) / (1 + abs(y)) for x, y in zip(a, b)])
    assert worst < 1e-5, f"{what}: {worst:.1e} apart"  # a float of x lies 6e-8 · 255 steps beside a texel's middle
    print(f"{what}: {len(found)} lookups within {worst:.0e}")


def last_member(side):
    return "fresnel" if side["table"] == "ltc-heitz" else side["channels"][-1]["name"]


def compile_shader(folder, side, language):
    """By glslang, if it is there: GLSL ES, GLSL 4.50 and HLSL."""
    if not shutil.which("glslangValidator"):
        print("glslangValidator is not installed: shaders are not compiled")
        return
    member = last_member(side)
    call = side["table"].replace("-", "_") + "_lookup"
    kind = "2DArray" if len(side["layers"]) > 1 else "2D"
    texture = side["form"] == "bilinear"
    source = side["lookup"][language]
    if language == "hlsl":
        given = "t, s, " if texture else ""
        texts = [
            f"{source}\nTexture{kind}<float4> t : register(t0);\nSamplerState s : register(s0);\n"
            f"float4 main(float2 p : TEXCOORD0) : SV_Target {{ return {call}({given}p.x, p.y).{member}; }}\n"
        ]
        options = ["-D", "-V", "-e", "main", "-o", os.path.join(folder, "out.spv")]
    else:
        given = "t, " if texture else ""
        main = f"void main() {{ c = vec4({call}({given}p.x, p.y).{member}); }}\n"
        es = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
        texts = [
            f"{es}{source}\nuniform highp sampler{kind} t;\nin vec2 p;\nout vec4 c;\n{main}",
            f"#version 450\n{source}\nlayout(binding = 0) uniform sampler{kind} t;\nlayout(location = 0) in vec2 p;\n"
            f"layout(location = 0) out vec4 c;\n{main}",
        ]
        options = []
    for text in texts:
        path = os.path.join(folder, "shader.frag")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        done = subprocess.run(["glslangValidator", *options, "-S", "frag", path], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout


def as_cpp(wgsl):
    """The few words of WGSL that lookups have, in C++. tests/shader/run.sh has WGSL's own compiler check it."""
    types = {"f32": "float", "i32": "int"}
    text = re.sub(r"const (\w+) = array<f32, (\d+)>\(([^)]*)\);", r"static const float \1[\2] = {\3};", wgsl)
    text = re.sub(r"fn (\w+)\(([^{]*)\) -> (\w+) \{", lambda m: f"{types.get(m[3], m[3])} {m[1]}({m[2]}) {{", text)
    text = text.replace("texture_2d_array<f32>", "texture_2d_array").replace("texture_2d<f32>", "texture_2d").replace("vec2<f32>", "vec2")
    text = re.sub(r"^    (\w+): f32,$", r"    float \1;", text, flags=re.M)  # of a structure
    text = text.replace("\n}\n", "\n};\n", 1)
    text = re.sub(r"(\w+): (f32|i32|sampler|texture_2d_array|texture_2d)\b", lambda m: f"{types.get(m[2], m[2])} {m[1]}", text)
    text = re.sub(r"var (\w+): (\w+);", r"\2 \1;", text)
    text = re.sub(r"let (layer\d) =", r"vec4 \1 =", text)
    text = text.replace("let first =", "int first =").replace("var k =", "int k =")
    return re.sub(r"\b(let|var) (\w+) =", r"float \2 =", text)


def check(folder, options):
    name = os.path.join(folder, "table")
    bake([*options], name + ".json")
    with open(name + ".json", encoding="utf-8") as file:
        side = json.load(file)
    bake([*options], name + ".raw")
    with open(name + ".raw.json", encoding="utf-8") as file:
        beside = json.load(file)
    for key in ("table", "form", "width", "height", "pixel", "layers", "data_bytes", "axes", "channels", "lookup", "error"):
        assert side[key] == beside[key], key
    layers = read_raw(name + ".raw", side)
    # JSON: the same numbers
    flat = [n for layer in layers for n in layer]
    if side["pixel"] in STEPS:
        assert [n / STEPS[side["pixel"]] for n in side["values"]] == flat
    elif side["pixel"] != "rgb9e5":
        assert side["values"] == flat
    if side["form"] == "bilinear":
        bake([*options], name + ".dds")
        with open(name + ".dds.json", encoding="utf-8") as file:
            assert read_dds(name + ".dds", json.load(file)) == layers
    if side["form"] == "bilinear" and side["pixel"] in ("float", "half") and oiio:
        bake([*options], name + ".exr")
        picture = oiio.ImageInput.open(name + ".exr")
        names = list(picture.spec().channelnames)
        pixels = picture.read_image(oiio.FLOAT)
        for channel in side["channels"]:
            layer, count = layers[channel["layer"]], side["layers"][channel["layer"]]
            read = pixels[:, :, names.index(channel["name"])].flatten().tolist()
            assert read == layer[channel["component"] :: count], channel["name"]
    wanted = [expected(layers, side, mu, roughness) for mu, roughness in POSES]
    title = " ".join(options)

    bake([*options, "--no-sidecar"], name + ".h")
    lookup = side["table"].replace("-", "_") + "_lookup"
    program = name + ".out"
    with open(name + ".c", "w", encoding="utf-8") as file:
        file.write(f'#include "table.h"\nfloat first(void);\nfloat first(void) {{ return {lookup}(0.5f, 0.5f).{last_member(side)}; }}\n')
    subprocess.run([cc, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", "-c", name + ".c", "-o", name + ".o"], check=True)
    common = ["-std=c++20", "-O1", "-Wall", "-Wextra", "-Werror", os.path.join(here, "lookup.cpp"), "-o", program]
    subprocess.run([cxx, *common, f'-DHEADER="{name}.h"', f"-DLOOKUP={lookup}(n_dot_v, roughness)"], check=True)
    compare(f"{title}: C header", run([program], POSES), wanted)

    with open(name + ".texels", "wb") as file:
        for layer, channels in zip(layers, side["layers"]):
            for texel in range(side["width"] * side["height"]):
                four = layer[texel * channels : (texel + 1) * channels] + [0.0] * (4 - channels)
                file.write(struct.pack("<4f", *four))
    array = "Array" if len(side["layers"]) > 1 else ""
    textures = {
        "glsl": f"sampler2D{array}(), ",
        "hlsl": f"Texture2D{array}<float4>(), SamplerState(), ",
        "msl": f"texture2d{array and '_array'}<float>(), sampler(), ",
        "wgsl": f"texture_2d{array and '_array'}(), sampler(), ",
    }
    for language in ("glsl", "hlsl", "msl", "wgsl"):
        source = side["lookup"][language]
        first = textures[language]
        if side["form"] == "chebyshev":
            count = len(side["values"])
            source = source.replace(f"= float[{count}](", "= {").replace(");\nfloat", "};\nfloat")
            first = ""
        if language == "msl":
            source = source.replace("#include <metal_stdlib>\nusing namespace metal;\n", "")
        if language == "wgsl":
            source = as_cpp(source)
        with open(name + "." + language, "w", encoding="utf-8") as file:
            file.write(source)
        subprocess.run(
            [cxx, *common, "-Wno-unused-function", f'-DSOURCE="{name}.{language}"', f"-DWIDTH={side['width']}",
             f"-DHEIGHT={side['height']}", f"-DLOOKUP={lookup}({first}n_dot_v, roughness)"],
            check=True,
        )
        if language in ("glsl", "hlsl"):
            compile_shader(folder, side, language)
        compare(f"{title}: {language.upper()}", run([program, name + ".texels"], POSES), wanted)


with tempfile.TemporaryDirectory() as folder:
    for options in (
        ["dfg", "-s", "8", "--pixel", "float"],
        ["dfg", "-s", "16x8", "--pixel", "half", "--axes", "root"],
        ["dfg", "-s", "7", "--pixel", "rgb9e5"],
        ["dfg", "-s", "6x5", "--form", "chebyshev"],
        ["kulla-conty", "-s", "8", "--pixel", "uint8", "--axes", "root"],
        ["kulla-conty", "-s", "5", "--pixel", "uint16"],
        ["ltc-ggx", "-s", "8", "--pixel", "half"],
        ["ltc-ggx", "-s", "9x16", "--pixel", "uint16"],
        ["ltc-ggx", "-s", "8", "--pixel", "uint8"],
        ["ltc-disney", "-s", "8", "--pixel", "uint8"],
        ["ltc-heitz", "-s", "9x8", "--pixel", "half"],
        ["ltc-disney", "-s", "6", "--form", "chebyshev"],
    ):
        check(folder, options)
