"""Light on stages: shadows, bounced light, skies, captures; and exports of all of it."""

import json
import subprocess

import numpy as np
import pytest

import gonio

UP = (0.0, 0.0, 1.0)
RIG = {
    "lights": [{"name": "key", "shape": "sphere:r=10cm", "intensity": "800lm", "position": [0, 0, 2]}],
    "stage": "room",
    "sky": "cie:12,sun=180/40,horizontal=2klx",
}


def test_bounced_light_is_that_of_the_tool(tool, tmp_path):
    path = tmp_path / "rig.json"
    path.write_text(json.dumps({"schema": "gonio.rig/1", **RIG}))
    said = json.loads(
        subprocess.check_output(
            [tool, "probe", "--rig", path, "--indirect", "--at", "0.8,0.6,0.75", "--at", "0,0,0", "--json"]
        )
    )
    found = gonio.illuminance_on_stage(gonio.read_rig(path), [[0.8, 0.6, 0.75], [0, 0, 0]], UP)
    points = said["points"]
    assert found.total == pytest.approx([point["illuminance_lx"] for point in points])
    assert found.indirect == pytest.approx([point["indirect_lx"] for point in points])
    assert found.sky == pytest.approx([point["sky_lx"] for point in points])
    assert found.total == pytest.approx(found.direct + found.sky + found.indirect)
    assert found.each.shape == (2, 1) and found.each[:, 0] == pytest.approx(found.direct)


def test_parts_of_the_light_on_a_stage():
    light = gonio.Light("sphere:r=10cm", "800lm", position=(0, 0, 2))
    alone = gonio.illuminance(light, [0.9, 0.9, 0], UP)
    direct = gonio.illuminance_on_stage(light, [0.9, 0.9, 0], UP, "floor", bounces=0)
    assert isinstance(direct.total, float) and direct.indirect == 0.0
    assert direct.direct == pytest.approx(alone, rel=1e-6)
    room = gonio.illuminance_on_stage(light, [-0.9, -0.9, 0], UP, "room")
    # What is black reflects nothing; gonio remarks that nothing is so black.
    black = {surface: "lambert:albedo=0" for surface in gonio.make_rig({**RIG, "stage": "room"}).surfaces}
    assert room.indirect > 1.0
    with pytest.warns(gonio.DiagnosticWarning, match="albedo"):
        dark = gonio.illuminance_on_stage(light, [-0.9, -0.9, 0], UP, "room", materials=black)
    assert dark.indirect == 0.0
    open_sky = gonio.illuminance_on_stage([], np.zeros((2, 3)), UP, "floor", sky="500lx", bounces=0)
    assert open_sky.total.shape == (2,) and np.all(open_sky.sky <= 500.0) and np.all(open_sky.sky > 100.0)
    with pytest.raises(gonio.Error, match="did you mean"):
        gonio.illuminance_on_stage(light, [0, 0, 0], UP, "rom")


def test_rigs_have_skies():
    rig = gonio.make_rig({**RIG, "stage": "floor"})
    assert rig.sky is not None and rig.sky.illuminance(UP) == pytest.approx(2000.0)
    lamp = gonio.illuminance(rig.lights, [5, 0, 0], UP)
    assert gonio.illuminance(rig, [5, 0, 0], UP) == pytest.approx(lamp + 2000.0)
    sunny = gonio.make_rig({"lights": [], "sky": "daylight:place=52.5/13.4,time=2026-06-21T12:00+02:00"})
    assert [light.name for light in sunny.lights] == ["sun"]
    with pytest.raises(gonio.Error, match="sky"):
        gonio.make_rig({"lights": [], "sky": "daylight:place=52.5/13.4,time=2026-06-21T00:00+02:00"})
    assert "sky" in gonio.rig_keys()["rig"]


def test_previews_under_skies():
    sky = gonio.Sky("cie:overcast,horizontal=5klx")
    picture = gonio.preview([], "floor", size=(48, 36), sky=sky)
    assert picture.luminance.max() > 100.0
    dark = gonio.preview([], "floor", size=(48, 36), sky=sky, shows_sky=False)
    assert dark.luminance[0].sum() <= picture.luminance[0].sum()
    glossy = {"sphere": "ue4:roughness=0.2,metallic=1"}
    light = gonio.hang("sphere:r=10cm", "800lm", "spheres")
    exact = gonio.preview(light, "spheres", size=(24, 18), sky=sky, materials=glossy)
    other = gonio.preview(light, "spheres", size=(24, 18), sky=sky, materials=glossy, surroundings="split-sum")
    assert not np.array_equal(exact.luminance, other.luminance)
    # What surfaces mirror of the lit stage, as it looks from one point.
    floor = {"floor": "ue4:roughness=0.3"}
    mirrored = gonio.preview(light, "floor", size=(24, 18), materials=floor, bounces=1)
    boxed = gonio.preview(
        light,
        "floor",
        size=(24, 18),
        materials=floor,
        bounces=1,
        surroundings="parallax-box",
        probe_at=(0, -1, 1),
    )
    assert not np.array_equal(mirrored.luminance, boxed.luminance)
    assert exact.shows_subject.dtype == bool and exact.shows_subject.any() and not exact.shows_subject.all()
    with pytest.raises(gonio.Error, match="probe"):
        gonio.preview(light, "spheres", surroundings="parallax-box")


def test_captures_see_all_around():
    light = gonio.Light("sphere:r=10cm", "800lm", position=(0, 0, 2))
    around = gonio.capture(light, (0, 0, 1), "floor", side=64)
    assert around.layout == "cube-strip" and around.pixels.shape == (64, 384, 3)
    below = around.luminance([0, 0, -1])
    lux = gonio.illuminance(light, [0, 0, 0], UP)
    assert below == pytest.approx(lux * 0.5 / np.pi, rel=0.3)
    assert around.luminance([0, 0, 1]) == pytest.approx(light.luminance_nt, rel=1e-4)
    hidden = gonio.capture(light, (0, 0, 1), "floor", side=64, shows_lights=False)
    # Beside the zenith is the far end of the wall.
    assert hidden.luminance([0, 0, 1]) < 1e-3


def test_rays_meet_stages():
    distance, normal, name = gonio.first_hit("floor", [[0, 0, 2.0], [0, 0, 2.0]], [[0, 0, -1], [0, 0, 1]])
    assert distance[0] == 2.0 and name[0] == "floor" and normal[0] == pytest.approx(UP)
    assert distance[1] == np.inf and name[1] is None and np.isnan(normal[1]).all()


def test_exposure():
    assert gonio.white_luminance_nt([0.0, 1.0]) == pytest.approx([1.2, 2.4])
    assert gonio.card_illuminance_lx(gonio.ev100_of_card(300.0)) == pytest.approx(300.0)
    grey = np.full((8, 8, 3), 100.0, np.float32)
    # Nothing is brighter than the rest, so all of it is white.
    assert gonio.white_luminance_nt(gonio.auto_ev100(grey)) == pytest.approx(100.0, rel=1e-3)


def test_images_before_lights():
    image = np.zeros((64, 64), np.float32)
    image[:, :32] = 1.0
    spot = gonio.Light("spot:cone=60deg", "1000cd", position=(0, 0, 2), image=image)
    left, right = gonio.illuminance(spot, [[-0.3, 0, 0], [0.3, 0, 0]], UP)
    assert min(left, right) == 0.0 and max(left, right) > 100.0
    floats = np.array([[-0.3, 0, 0], [0.3, 0, 0]], np.float32)
    assert gonio.illuminance(spot, floats, np.float32(UP)) == pytest.approx([left, right], rel=1e-4)
    colored = np.zeros((8, 8, 3))
    colored[..., 0] = 1.0
    panel = gonio.Light("rect:w=1m,h=1m", "1000lm", position=(0, 0, 2), image=colored)
    assert gonio.illuminance(panel, [0, 0, 0], UP) > 10.0
    picture = gonio.preview(panel, "floor", size=(24, 18)).luminance
    assert picture[..., 0].sum() > 10.0 * picture[..., 1].sum()
    for bad in (np.zeros((4, 4)), np.full((4, 4), -1.0), np.ones(4)):
        with pytest.raises(gonio.Error):
            gonio.Light("spot:cone=60deg", "1000cd", image=bad)
    with pytest.raises(gonio.Error, match="takes no image"):
        gonio.Light("sphere:r=3cm", "800lm", image=np.ones((4, 4)))


def test_openings(profiles):
    profile = gonio.read(profiles / "wall-washer.ies")
    web = profile.web()
    opening = profile.opening
    assert opening.kind == "rectangle" and sorted(opening.size_m) == pytest.approx([0.0, 0.1, 0.3])
    # `gonio info` prints it: a point is within 1 % from 2.6 m on.
    assert opening.point_distance_m(web) == pytest.approx(2.6, abs=0.05)
    assert opening.projected_area_m2(web, [0, 0, -1]) == pytest.approx(0.03)
    down = opening.luminance(web, [0, 0, -1])
    assert down == pytest.approx(web.sample(0, 0) / 0.03)
    assert gonio.Opening("rect:w=30cm,h=10cm").mean_luminance_nt(web) == pytest.approx(opening.mean_luminance_nt(web))
    near = gonio.Light(f"ies:{profiles / 'wall-washer.ies'},opening", position=(0, 0, 0.3))
    assert gonio.illuminance(near, [0, 0, 0], UP) < web.sample(0, 0) / 0.3**2
    with pytest.raises(gonio.Error, match="point"):
        gonio.Opening("point").mean_luminance_nt(web)


def test_textures_of_engines(tool, profiles):
    web = gonio.read(profiles / "downlight.ies").web()
    texture = gonio.bake(web, engine="unreal")
    assert texture.image.shape == (1, 256) and texture.file_pixels().shape == (1, 256, 4) and "half" not in texture.layout
    assert texture.rule
    listed = json.loads(subprocess.check_output([tool, "list", "engines", "--json"]))
    assert len(gonio.engines()) > 5 and listed
    with pytest.raises(gonio.Error, match="both"):
        gonio.bake(web, "latlong", engine="unreal")
    at = gonio.layout_directions("octahedral", (32, 32))
    assert np.linalg.norm(at, axis=-1) == pytest.approx(1.0)
    centers = web.sample_directions(at)
    assert centers.max() == pytest.approx(np.asarray(gonio.bake(web, "octahedral", size=(32, 32))).max(), rel=0.2)


@pytest.mark.parametrize("target", ["gltf", "blender", "threejs", "unreal", "usd"])
def test_exports_are_those_of_the_tool(tool, profiles, tmp_path, target):
    made = gonio.export_lights(gonio.read(profiles / "street.ldt"), target, intensity="800lm", color="2700K")
    subprocess.check_call(
        [tool, "import", profiles / "street.ldt", "--to", target, "--flux", "800lm", "--color", "2700K"]
        + ["-O", tmp_path, "-q"]
    )
    assert made.target == target and made.readme == (tmp_path / target / "README.md").read_text()
    for name, data in made.files.items():
        theirs = (tmp_path / target / name).read_bytes()
        # The tool names the file as the user did, and so does Python.
        assert data == theirs, name


def test_exports_of_lights(modules, tmp_path):
    lights = [
        gonio.Light("sphere:r=10cm", "800lm", position=(0, 0, 2), name="ball"),
        gonio.Light("spot:outer=20deg", "500cd", position=(1, 0, 2), name="spot"),
    ]
    made = gonio.export_lights(lights, "gltf", name="pair")
    assert "pair.gltf" in made.files and made.instead
    made.save(tmp_path / "out")
    assert {path.name for path in (tmp_path / "out").iterdir()} == set(made.files)
    sky = gonio.export_lights([], "blender", name="sky", sky="cie:overcast,horizontal=1klx")
    assert any(name.endswith(".exr") for name in sky.files)
    with pytest.raises(gonio.Error, match="did you mean 'gltf'"):
        gonio.export_lights(lights, "gltff")
    with pytest.raises(gonio.Error, match="letters"):
        gonio.export_lights(lights, "gltf", name="a/b")
    with pytest.raises(gonio.Error, match="nothing to export"):
        gonio.export_lights([], "gltf")
    scene = gonio.export_stage(lights, "gltf", "floor", name="scene", size=(64, 48))
    assert json.loads(scene.files["scene.gltf"])["cameras"]
    assert [ending for ending, _ in gonio.stage_formats()].count(".gltf") == 1
    assert gonio.color_temperature_in_text("830") == 3000.0 and gonio.color_temperature_in_text("lamp") is None
