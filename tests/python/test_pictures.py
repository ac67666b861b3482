"""Textures, previews and rigs."""

import json

import numpy as np
import pytest

import gonio


def test_a_texture_keeps_the_flux():
    web = gonio.make_web("downlight:beam=30deg", 1200.0)
    texture = gonio.bake(web, "latlong", size=(64, 32))
    image = texture.image
    assert image.shape == (32, 64) and image.dtype == np.float32 and image.base is texture
    assert np.asarray(texture).shape == (32, 64)
    edges = np.cos(np.linspace(0.0, np.pi, 33))
    flux = (image.sum(axis=1) * (edges[:-1] - edges[1:])).sum() * 2.0 * np.pi / 64 * texture.cd_per_unit
    assert flux == pytest.approx(1200.0, rel=1e-6)
    assert gonio.bake(web, "octahedral", max_error_cd=0.05 * web.peak.candela).max_error_cd <= 0.05 * web.peak.candela
    assert texture._repr_png_().startswith(b"\x89PNG")
    with pytest.raises(gonio.Error):
        gonio.bake(web, "octahedral", size=(64, 32))


def test_a_preview_is_an_array():
    light = gonio.hang("sphere:r=10cm", "800lm")
    picture = gonio.preview(light, "floor", size=(48, 32))
    assert picture.luminance.shape == (32, 48, 3) and picture.luminance.base is picture
    assert np.asarray(picture).dtype == np.float32
    assert picture.illuminance.max() > 1.0
    assert picture.exposed().max() <= picture.exposed(0.0).max()
    assert picture._repr_png_().startswith(b"\x89PNG")
    same = gonio.preview(light, "floor", size=(48, 32), threads=1)
    assert np.array_equal(same.luminance, picture.luminance)
    with pytest.raises(gonio.Error, match="did you mean"):
        gonio.preview(light, "flor")


def test_a_dict_is_not_yet_a_rig():
    with pytest.raises(TypeError, match="make_rig"):
        gonio.preview({"lights": []}, size=(8, 8))


def test_rigs_are_dicts(tmp_path):
    content = {
        "lights": [{"name": "key", "shape": "sphere:r=10cm", "intensity": "800lm", "position": [0, 0, 2]}],
        "stage": "floor",
        "materials": {"floor": "lambert:albedo=0.2"},
    }
    rig = gonio.make_rig(content)
    assert [light.name for light in rig.lights] == ["key"] and rig.stage == "floor"
    assert gonio.illuminance(rig, [0, 0, 0], [0, 0, 1]) > 0.0
    assert gonio.preview(rig, size=(16, 12)).luminance.shape == (12, 16, 3)
    path = tmp_path / "rig.json"
    path.write_text(json.dumps({"schema": "gonio.rig/1", **content}))
    assert len(gonio.read_rig(path).lights) == 1
    with pytest.raises(gonio.Error, match=r"lights\[0\]"):
        gonio.make_rig({"lights": [{"shape": "spere:r=1cm"}]})


def test_rigs_are_single_lights():
    luminaire = {"shape": "point", "intensity": "100cd", "maintenance": 0.8}
    aimed = {"luminaire": "A", "position": [0, 0, 3], "target": [1, 0, 3]}
    rig = gonio.make_rig(
        {
            "luminaires": {"A": luminaire},
            "lights": [
                {"name": "desk", "luminaire": "A", "array": {"count": [2, 1], "spacing": [2, 1]}},
                {"name": "row", "dimming": "50%", "lights": [aimed]},
            ],
        }
    )
    assert [light.name for light in rig.lights] == ["desk[1,1]", "desk[2,1]", "row/A 1"]
    assert [light.position[0] for light in rig.lights] == [-1, 1, 0]
    assert rig.lights[2].direction == pytest.approx([1, 0, 0])
    assert gonio.illuminance(rig.lights[0], [-1, 0, -1], [0, 0, 1]) == pytest.approx(80)
    with pytest.raises(gonio.Error, match=r"lights\[0\]\.array\.count\[0\]"):
        gonio.make_rig({"lights": [{**luminaire, "array": {"count": [0, 1]}}]})
