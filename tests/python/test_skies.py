"""Skies, the sun, and environments as arrays."""

import datetime
import json
import subprocess

import numpy as np
import pytest

import gonio

UP = (0.0, 0.0, 1.0)
CIE = "cie:12,sun=180/40,horizontal=20klx"
DAYLIGHT = "daylight:place=52.52/13.405,time=2026-06-21T12:00+02:00"


def sphere(count, seed=1):
    directions = np.random.default_rng(seed).normal(size=(count, 3))
    return directions / np.linalg.norm(directions, axis=1, keepdims=True)


@pytest.mark.parametrize("text", ["500lx", CIE, DAYLIGHT])
def test_measures_are_those_of_the_tool(tool, text):
    said = json.loads(subprocess.check_output([tool, "sky", "info", text, "--json"]))
    sky = gonio.Sky(text)
    measures = sky.measures()
    assert measures.horizontal_lx == pytest.approx(said["horizontal_lx"])
    assert measures.vertical_lx == pytest.approx(said["vertical_lx"])
    assert (measures.mean_nt, measures.zenith_nt) == pytest.approx((said["mean_nt"], said["zenith_nt"]))
    assert (measures.brightest is None) == (said["brightest"] is None)
    if said["brightest"]:
        assert measures.brightest.share == pytest.approx(said["brightest"]["share"])
    assert measures.temperature_k == pytest.approx(said["cct_K"])
    assert (sky.sun is None) == (said["sun"] is None)
    if said["sun"]:
        assert sky.sun.azimuth_deg == pytest.approx(said["sun"]["azimuth_deg"])
        assert sky.sun.illuminance_lx == pytest.approx(said["sun"]["illuminance_lx"])


def test_luminance_over_arrays():
    sky = gonio.Sky(CIE)
    # The integral of the luminance over a fine grid of the upper hemisphere is the illuminance.
    elevation = np.radians((np.arange(180) + 0.5) / 2.0)
    azimuth = np.radians(np.arange(0.5, 360.0))
    directions = gonio.sky_direction(np.degrees(azimuth)[:, None], np.degrees(elevation))
    assert directions.shape == (360, 180, 3)
    luminance = sky.luminance(directions)
    weights = np.cos(elevation) * np.sin(elevation) * np.radians(0.5) * np.radians(1.0)
    assert (luminance * weights).sum() == pytest.approx(20000.0, rel=1e-3)
    assert sky.illuminance(UP) == pytest.approx(20000.0)
    assert sky.illuminance(np.array([UP, (0, -2, 0)]))[1] == pytest.approx(sky.measures().vertical_lx["south"])
    assert sky.radiance([0, 0, 3.0]) == pytest.approx(sky.luminance(UP) * np.ones(3))
    assert sky.luminance([0.0, 0.5, -1.0]) == 0.0


def test_cie_skies():
    assert len(gonio.cie_skies()) == 16
    up, low = gonio.cie_sky_luminance("overcast", [UP, gonio.sky_direction(0.0, 30.0)])
    assert (up, low) == pytest.approx((1.0, (1.0 + 2.0 * 0.5) / 3.0))
    with pytest.raises(gonio.Error):
        gonio.cie_sky_luminance("17", UP)


def test_the_sun_by_place_and_time():
    azimuth, elevation = gonio.solar_position(52.52, 13.405, "2026-06-21T12:00+02:00")
    sun = gonio.Sky(DAYLIGHT).sun
    assert (azimuth, elevation) == pytest.approx((sun.azimuth_deg, sun.elevation_deg), abs=1e-9)
    zone = datetime.timezone(datetime.timedelta(hours=2))
    assert gonio.solar_position(52.52, 13.405, datetime.datetime(2026, 6, 21, 12, tzinfo=zone)) == (azimuth, elevation)
    times = np.datetime64("2026-06-21T10:00") + np.arange(0, 24 * 60, 10).astype("timedelta64[m]")
    azimuths, elevations = gonio.solar_position(52.52, 13.405, times)
    assert azimuths[0] == pytest.approx(azimuth, abs=1e-6) and elevations[0] == pytest.approx(elevation, abs=1e-6)
    assert elevations.max() == pytest.approx(90.0 - 52.52 + 23.436, abs=0.01)
    assert gonio.solar_position(52.52, 13.405, ["2026-06-21T12:00+02:00"] * 2)[0].shape == (2,)
    lifted = gonio.solar_position(52.52, 13.405, "2026-06-21T21:00+02:00", refraction=True)[1]
    assert lifted > gonio.solar_position(52.52, 13.405, "2026-06-21T21:00+02:00")[1]
    with pytest.raises(gonio.Error, match="zone"):
        gonio.solar_position(52.52, 13.405, "2026-06-21T12:00")
    with pytest.raises(gonio.Error, match="1950 to 2100"):
        gonio.solar_position(52.52, 13.405, np.array(["1900-01-01"], "datetime64[D]"))
    sun_lx, sky_lx = gonio.daylight([60.0, 0.0], 172)
    assert sun_lx[0] > sky_lx[0] > 0.0 and sun_lx[1] == sky_lx[1] == 0.0


def test_angles_and_directions_are_inverse():
    directions = sphere(100)
    assert gonio.sky_direction(*gonio.sky_angles(directions)) == pytest.approx(directions, abs=1e-12)
    assert gonio.sky_direction(90.0, 0.0) == pytest.approx([1.0, 0.0, 0.0], abs=1e-12)


def test_a_sun_is_a_light():
    sun = gonio.Sun(180.0, 30.0, 80e3)
    assert gonio.illuminance(sun.light(), [0, 0, 0], UP) == pytest.approx(80e3 * np.sin(np.radians(30.0)), rel=1e-4)
    with pytest.raises(gonio.Error):
        gonio.Sun(0.0, 30.0, -1.0)


def test_environments_are_arrays():
    pixels = np.ones((32, 64, 3), np.float32)
    pixels[:16] *= (0.5, 1.0, 2.0)
    environment = gonio.Environment(pixels, nits_per_unit=100.0)
    assert environment.layout == "latlong"
    assert np.array_equal(environment.pixels, pixels) and not environment.pixels.flags.writeable
    assert environment.pixels.base is environment and np.asarray(environment).dtype == np.float32
    assert environment.radiance(UP) == pytest.approx([50.0, 100.0, 200.0])
    assert environment.solid_angles().sum() == pytest.approx(4.0 * np.pi)
    assert environment.directions()[0, :, 2].min() > 0.99
    upper = float(pixels[0, 0] @ np.array([0.21263900587151027, 0.71516867876775592, 0.072192315360733714]))
    assert environment.illuminance(UP) == pytest.approx(np.pi * 100.0 * upper, rel=1e-6)
    assert environment.calibrated(illuminance_lx=500.0).illuminance(UP) == pytest.approx(500.0)
    sky = gonio.Sky(environment, horizontal_lx=300.0)
    assert sky.illuminance(UP) == pytest.approx(300.0)
    grey = gonio.Environment(np.ones((8, 48)))
    assert grey.layout == "cube-strip" and grey.pixels.shape == (8, 48, 3)
    assert environment._repr_png_().startswith(b"\x89PNG")


def test_layouts_keep_the_light():
    environment = gonio.Sky(CIE).environment("latlong", (128, 64))
    light = environment.scalar_illuminance_lx()
    for layout, size in [("cube-strip", (192, 32)), ("octahedral", (64, 64)), ("cube-cross", (128, 96))]:
        other = environment.resampled(layout, size)
        assert other.pixels.shape == (size[1], size[0], 3)
        assert other.scalar_illuminance_lx() == pytest.approx(light, rel=1e-5)
    turned = environment.resampled("latlong", (128, 64), rotate_deg=90.0)
    assert turned.illuminance([0, 1, 0]) == pytest.approx(environment.illuminance([-1, 0, 0]), rel=1e-3)
    crossed = environment.resampled("cube-cross", (64, 48))
    assert np.isnan(crossed.directions()).any() and not np.isnan(crossed.directions()[16:32]).any()


def test_the_sun_goes_into_pixels_and_out():
    sky = gonio.Sky("daylight:place=52.52/13.405,time=2026-06-21T12:00+02:00")
    # Texels of 0.35°, finer than the sun's disc.
    with_sun = sky.environment("latlong", (1024, 512), sun=True)
    found = with_sun.extract_sun()
    assert found.sun.azimuth_deg == pytest.approx(sky.sun.azimuth_deg, abs=0.2)
    assert found.sun.illuminance_lx == pytest.approx(sky.sun.illuminance_lx, rel=0.02)
    assert found.texels >= 1 and found.sky.illuminance(UP) == pytest.approx(sky.illuminance(UP), rel=0.02)
    assert with_sun.brightest().share > 0.25


def test_bad_skies_say_what_the_tool_says(tool):
    for text in ["cie:12,sun=180/40", "cie:17,horizontal=1klx", "500cd", "daylight:place=52/13"]:
        with pytest.raises(gonio.Error) as raised:
            gonio.Sky(text)
        said = subprocess.run([tool, "sky", "info", text], capture_output=True, text=True)
        assert raised.value.message in said.stderr
    with pytest.raises(gonio.Error, match="in the text"):
        gonio.Sky("500lx", horizontal_lx=3.0)
    with pytest.raises(gonio.Error):
        gonio.Environment(np.full((4, 8), np.nan))
    assert gonio.Environment(np.full((4, 8), np.nan), bad_pixels="black").diagnostics
    with pytest.raises(gonio.Error):
        gonio.Environment(np.ones((5, 7)))
    with pytest.raises(TypeError, match="gonio.Sky"):
        gonio.preview([], sky=500)


def test_files_of_environments(modules, tmp_path):
    environment = gonio.Sky(CIE).environment("octahedral", (32, 32))
    environment.save(tmp_path / "sky.exr")
    again = gonio.read_environment(tmp_path / "sky.exr", layout="octahedral")
    assert np.array_equal(again.pixels, environment.pixels)
    sky = gonio.Sky(f"image:{tmp_path / 'sky.exr'},layout=octahedral,horizontal=100lx")
    assert sky.illuminance(UP) == pytest.approx(100.0)
    with pytest.raises(OSError):
        gonio.Sky(f"image:{tmp_path / 'none.exr'},horizontal=100lx")
    with pytest.raises(gonio.Error, match="for light"):
        environment.save(tmp_path / "sky.png")
