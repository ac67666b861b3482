"""Units, colours, lights and materials."""

import numpy as np
import pytest

import gonio


def test_units():
    assert gonio.convert("800lm", "nt", shape="sphere:r=3cm") == pytest.approx(22515.8, rel=1e-5)
    assert gonio.convert("300lx@2m", "lm") == pytest.approx(15079.6, rel=1e-5)
    assert gonio.convert("1fL", "nt") == pytest.approx(3.42626, rel=1e-5)
    numbers = np.array([[100.0, 200.0], [400.0, 800.0]])
    assert gonio.convert_numbers(numbers, "lm", "cd") == pytest.approx(numbers / (4.0 * np.pi))
    assert gonio.convert_steps("800lm", "cd")[-1][1:] == (pytest.approx(63.662, rel=1e-5), "cd")
    assert gonio.convert("800lm", "cd", shape="spot:outer=20deg", policy="physical") != gonio.convert(
        "800lm", "cd", shape="spot:outer=20deg", policy="unity-hdrp"
    )
    assert gonio.light_distance_m("800lm", 0.1) == pytest.approx(np.sqrt(800.0 / (4.0 * np.pi) / 0.1))
    with pytest.raises(gonio.Error, match="did you mean 'sphere'"):
        gonio.convert("800lm", "nt", shape="spere:r=3cm")
    with pytest.raises(gonio.Error):
        gonio.convert("800lm", "nt")


def test_colour_temperatures():
    xy = gonio.chromaticity([2700.0, 6500.0])
    assert xy.shape == (2, 2)
    assert xy[0] == pytest.approx([0.459859, 0.410599], abs=1e-6)
    kelvin, duv = gonio.temperature(xy[:, 0], xy[:, 1])
    assert kelvin == pytest.approx([2700.0, 6500.0], abs=1e-3) and duv == pytest.approx(0.0, abs=1e-9)
    exact = gonio.rgb(2700.0, space="acescg")
    assert exact == pytest.approx([1.468317, 0.874751, 0.294766], abs=1e-6)
    fast = gonio.rgb(np.full((2, 3), 2700.0, np.float32), space="acescg")
    assert fast.dtype == np.float32 and fast.shape == (2, 3, 3)
    assert np.allclose(fast, exact, atol=1e-5)
    with pytest.raises(gonio.Error):
        gonio.rgb(100.0)


def test_spectra():
    white = gonio.read_spectrum("d65").color()
    assert white.xy == pytest.approx((0.3127, 0.3290), abs=1e-4)
    wavelengths = np.arange(380.0, 781.0, 5.0)
    flat = gonio.Spectrum(wavelengths, np.ones_like(wavelengths)).color()
    assert flat.xy == pytest.approx((1.0 / 3.0, 1.0 / 3.0), abs=2e-4)
    with pytest.raises(gonio.Error):
        gonio.Spectrum([500.0, 400.0], [1.0, 1.0])


def test_light_quality():
    lamp = gonio.light_quality(gonio.read_spectrum("FL2"))
    assert lamp.temperature_k == pytest.approx(4225, abs=1) and lamp.duv == pytest.approx(0.0018, abs=1e-4)
    assert lamp.ra == pytest.approx(64.2, abs=0.1) and lamp.r.shape == (15,) and lamp.r[8] == pytest.approx(-83.9, abs=0.1)
    assert lamp.rf == pytest.approx(70.12, abs=0.01) and lamp.rg == pytest.approx(86.42, abs=0.01)
    assert lamp.rf_hues.shape == lamp.chroma_shifts.shape == lamp.hue_shifts.shape == (16,)
    assert lamp.rf_samples.shape == (99,) and lamp.rf_samples.max() <= 100.0
    assert 0 < lamp.reference_duv < 0.0054 and lamp.diagnostics == []
    assert lamp.melanopic_der == lamp.alpha_opic_der["melanopic"] == pytest.approx(0.5694, abs=1e-3)
    assert list(sorted(lamp.alpha_opic_mw_per_lm)) == ["l_cone", "m_cone", "melanopic", "rhodopic", "s_cone"]
    assert lamp.svg(title="<lamp>").count("&lt;lamp&gt;") > 0
    nm = np.arange(380.0, 781.0, 5.0)
    blue = gonio.light_quality(gonio.Spectrum(nm, np.exp2(-(((nm - 450.0) / 10.0) ** 2))))
    assert blue.ra is None and blue.r is None and blue.rf is None and blue.temperature_k is None
    assert blue.melanopic_der > 1.0 and [d.code for d in blue.diagnostics] == ["RES0111"]
    with pytest.raises(gonio.Error):
        blue.svg()


def test_warnings_are_pythons():
    with pytest.warns(gonio.DiagnosticWarning):
        gonio.light_color("1000K")


LIGHTS = [
    gonio.Light("sphere:r=10cm", "800lm", position=(0, 0, 2)),
    gonio.Light("rect:w=60cm,h=30cm", "800lm", position=(1, 0, 2)),
    gonio.Light("disk:r=20cm", "500cd", position=(0, 1, 3), direction=(0.2, 0, -1)),
    gonio.Light("tube:r=2cm,l=1.2m", "3000lm", position=(-1, 0, 2.5)),
    gonio.Light("spot:outer=30deg,inner=20deg", "1000lm", position=(0, 0, 4), color="2700K"),
    gonio.Light("sun:angle=0.53deg", "100lx", direction=(1, 0, -1)),
]


def test_illuminance_of_a_point():
    light = gonio.Light("point", "100cd", position=(0, 0, 2))
    assert gonio.illuminance(light, [0, 0, 0], [0, 0, 1]) == pytest.approx(25.0)
    assert gonio.illuminance([light, light], [[0, 0, 0], [0, 0, 1]], [0, 0, 5]) == pytest.approx([50.0, 200.0])


def test_packs_agree_with_double():
    random = np.random.default_rng(1)
    positions = random.uniform(-3.0, 3.0, (5000, 3)) * (1.0, 1.0, 0.1)
    normals = random.normal(size=(5000, 3))
    exact = gonio.illuminance(LIGHTS, positions, normals)
    assert gonio.illuminance_of_each(LIGHTS, positions, normals).sum(axis=-1) == pytest.approx(exact)
    rows = gonio.illuminance(LIGHTS, positions.astype(np.float32), normals.astype(np.float32))
    assert rows.dtype == np.float32
    assert np.abs(rows - exact).max() < 2e-4 * exact.max()
    units = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    columns = gonio.illuminance(LIGHTS, np.asfortranarray(positions, np.float32), np.asfortranarray(units))
    assert np.abs(columns - exact).max() < 2e-4 * exact.max()
    assert np.array_equal(gonio.illuminance(LIGHTS, positions.astype(np.float32), units, threads=1), columns)


def test_a_profile_in_packs(profiles):
    light = gonio.Light(f"ies:{profiles / 'downlight.ies'}", position=(0, 0, 2.5))
    positions = np.random.default_rng(2).uniform(-2.0, 2.0, (1000, 3)) * (1, 1, 0)
    up = np.array([0, 0, 1])
    exact = gonio.illuminance(light, positions, up)
    packs = gonio.illuminance(light, positions.astype(np.float32), up.astype(np.float32))
    assert packs.dtype == np.float32
    assert np.abs(packs - exact).max() < 1e-5 * exact.max()


def test_luminance_of_lambert():
    lux = gonio.illuminance(LIGHTS[0], [0.5, 0, 0], [0, 0, 1])
    nits = gonio.luminance(LIGHTS[0], [0.5, 0, 0], [0, 0, 1], eye=(0, -3, 1.5), material="lambert:albedo=0.5")
    assert nits == pytest.approx(0.5 * lux / np.pi)


def test_bad_points():
    with pytest.raises(gonio.Error):
        gonio.illuminance(LIGHTS[0], [0, 0, 0], [0, 0, 0])
    with pytest.raises(gonio.Error, match="longer than 0"):
        gonio.illuminance(LIGHTS[0], np.zeros((2, 3), np.float32), np.zeros((2, 3), np.float32))
    with pytest.raises(gonio.Error, match="last axis has 3"):
        gonio.illuminance(LIGHTS[0], [0, 0], [0, 0, 1])


def test_materials():
    lambert = gonio.Material("lambert:albedo=0.5")
    assert lambert.brdf([0, 0, 2], [1, 0, 1]) == pytest.approx([0.5 / np.pi] * 3)
    glossy = gonio.Material("ue4:roughness=0.3,coat=1")
    rays = np.random.default_rng(3).normal(size=(100, 3))
    ways = glossy.brdf(rays, [0.3, 0, 1])
    assert ways.shape == (100, 3) and np.all(ways >= 0.0)
    assert np.all(ways[rays[:, 2] < 0.0] == 0.0)
    assert glossy.brdf([0.3, 0, 1], rays) == pytest.approx(ways)
    assert lambert.albedo([0.1, 1.0]) == pytest.approx(0.5)
    with pytest.raises(gonio.Error):
        gonio.Material("ue4:shine=1")
