"""The installed module for Python, beside the profiles of the source tree: numbers, a picture, files with the modules."""

import gonio
import numpy as np

light = gonio.Light("ies:profiles/downlight.ies", position=(0, 0, 2.5))
lux = gonio.illuminance(light, [0, 0, 0], [0, 0, 1])
assert 100.0 < lux < 1000.0
picture = gonio.preview(light, "floor", size=(64, 48))
assert picture.luminance.shape == (48, 64, 3) and np.all(np.isfinite(picture.luminance))
assert picture._repr_png_().startswith(b"\x89PNG")
try:
    gonio.convert("800lm", "nt", shape="spere:r=3cm")
except gonio.Error as error:
    assert error.code == "USE0103"
else:
    raise AssertionError("a shape that does not exist")
# gonio-media is installed too: the module finds it beside the tool.
sky = gonio.Sky("cie:overcast,horizontal=10klx").environment("latlong", (64, 32))
sky.save("/tmp/sky.exr")
assert np.array_equal(gonio.read_environment("/tmp/sky.exr").pixels, sky.pixels)
print(f"gonio {gonio.__version__} in Python: {lux:.6g} lx on the floor, a picture and a file of a sky")
