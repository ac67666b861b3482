"""Prefiltered environments, spherical harmonics and the split sum."""

import numpy as np
import pytest

import gonio

UP = (0.0, 0.0, 1.0)


@pytest.fixture(scope="module")
def sky():
    return gonio.Sky("cie:12,sun=180/40,horizontal=20klx").environment("cube-strip", (192, 32))


def directions(count, seed=1):
    some = np.random.default_rng(seed).normal(size=(count, 3))
    return some / np.linalg.norm(some, axis=1, keepdims=True)


def test_prefiltered_levels(sky):
    filtered = sky.prefiltered("filament", side=16, levels=4)
    assert [level.pixels.shape for level in filtered.levels] == [(16 >> i, 6 * (16 >> i), 3) for i in range(4)]
    assert filtered.mapping == "filament" and filtered.roughness[0] == 0.0 and filtered.roughness[-1] == 1.0
    errors = filtered.errors(sky, 8)
    assert errors[0].texels == 0 and all(error.rms < 1e-2 and error.texels > 0 for error in errors[1:])
    assert gonio.roughness_of_level([1, 3], 3, mapping="filament") == pytest.approx(filtered.roughness[[1, 3]])
    assert gonio.level_of_roughness(filtered.roughness, 3, mapping="filament") == pytest.approx([0, 1, 2, 3])
    many = filtered.radiance(directions(20), np.linspace(0, 1, 20))
    assert many.shape == (20, 3) and np.all(many >= 0.0)
    # Roughness 1 is Lambert's cosine: the illuminance over π, within the interpolation of few texels.
    assert filtered.radiance(UP, 1.0)[1] == pytest.approx(sky.illuminance(UP) / np.pi, rel=0.1)
    white = sky.irradiance_map("octahedral", 16)
    at = white.directions()[8, 8]
    assert white.luminance(at) == pytest.approx(sky.illuminance(at) / np.pi, rel=1e-3)
    with pytest.raises(gonio.Error):
        sky.prefiltered(side=24, levels=6)
    with pytest.raises(gonio.Error, match="unknown"):
        sky.prefiltered("filamnt")


def test_lobes_by_several_methods(sky):
    ways = directions(12, 2)
    exact = sky.lobe_radiance(ways, 0.5, method="quadrature")
    mean = exact.mean()
    assert np.abs(sky.lobe_radiance(ways, 0.5) - exact).max() < 1e-3 * mean
    assert np.abs(sky.lobe_radiance(ways, 0.5, method="samples", samples=4096) - exact).max() < 0.05 * mean
    assert np.abs(sky.lobe_radiance(ways, 0.5, method="filtered-samples") - exact).max() < 0.1 * mean
    with pytest.raises(gonio.Error, match="quadrature"):
        sky.lobe_radiance(ways, 0.5, method="guess")
    with pytest.raises(gonio.Error):
        sky.lobe_radiance(ways, 0.0)


def test_spherical_harmonics(sky):
    ways = directions(200)
    assert gonio.spherical_harmonics(UP)[:4] == pytest.approx([0.282095, 0.0, 0.488603, 0.0], abs=1e-6)
    assert gonio.spherical_harmonics(ways).shape == (200, 16)
    harmonics = sky.spherical_harmonics(3)
    assert harmonics.order == 3 and harmonics.radiance.shape == (16, 3)
    # The coefficients are integrals of the light with the functions, by the texels as points.
    weights = sky.solid_angles()[..., None]
    texels = gonio.spherical_harmonics(sky.directions())
    summed = np.einsum("ijk,ijc->kc", texels * weights, sky.pixels * sky.nits_per_unit)
    assert harmonics.radiance == pytest.approx(summed, abs=2e-3 * np.abs(summed).max())
    factors = np.repeat([gonio.cosine_factor(band) for band in range(4)], [1, 3, 5, 7])
    assert harmonics.irradiance_coefficients == pytest.approx(factors[:, None] * harmonics.radiance)
    lux = gonio.spherical_harmonics(ways) @ harmonics.irradiance_coefficients[:, 1]
    again = gonio.SphericalHarmonics(harmonics.radiance)
    assert again.illuminance(ways) == pytest.approx(lux, rel=1e-6)  # a grey sky
    assert again.illuminance(UP) == pytest.approx(sky.illuminance(UP), rel=0.1)
    assert harmonics.least.shape == (3,)
    with pytest.raises(gonio.Error):
        gonio.SphericalHarmonics(np.ones((5, 3)))


def test_the_split_sum_and_its_table():
    scale, bias, diffuse = gonio.split_sum(0.5, 1.0)
    assert (scale, bias, diffuse) == (pytest.approx(0.447705, abs=1e-6), pytest.approx(0.002989, abs=1e-6), 0.0)
    table = gonio.SplitSumTable(32)
    assert table.image.shape == (32, 32, 3) and table.image.base is table
    middles = (np.arange(32) + 0.5) / 32
    assert table.image[7, :, :2] == pytest.approx(gonio.split_sum(middles, middles[7])[:, :2], abs=1e-6)
    assert table.lookup(middles, middles[7])[:, :2] == pytest.approx(table.image[7, :, :2], abs=1e-6)
    assert 0.0 < table.lookup_error(8) < 0.05
    assert table.mean_albedo(0.5) == pytest.approx(gonio.mean_albedo(0.5), abs=2e-3)
    for scheme, _ in gonio.multiple_scattering_schemes():
        kept = gonio.specular_albedo(1.0, n_dot_v=0.5, roughness=0.8, multiple_scattering=scheme)
        assert kept == pytest.approx(scale_and_bias(0.8) if scheme == "none" else 1.0, abs=1e-6)
    assert gonio.SplitSumTable(8, "frostbite").image[..., 2].min() > 0.3
    assert table._repr_png_().startswith(b"\x89PNG")
    with pytest.raises(gonio.Error):
        gonio.split_sum(2.0, 0.5)
    with pytest.raises(gonio.Error):
        gonio.SplitSumTable(1)


def scale_and_bias(roughness):
    return gonio.split_sum(0.5, roughness)[:2].sum()


def test_parallax():
    ways = directions(50)
    seen = gonio.parallax_corrected(ways, position=(0.2, 0, 0), captured_at=(0, 0, 0), low=(-1, -1, -1), high=(1, 1, 1))
    assert np.abs(seen).max(axis=1) == pytest.approx(1.0)
    ball = gonio.parallax_corrected(ways, position=(0.2, 0, 0), captured_at=(0, 0, 0), center=(0, 0, 0), radius_m=2.0)
    assert np.linalg.norm(ball, axis=1) == pytest.approx(2.0)
    same = gonio.parallax_corrected(ways, position=(0, 0, 0), captured_at=(0, 0, 0), center=(0, 0, 0), radius_m=2.0)
    assert same == pytest.approx(2.0 * ways)
    with pytest.raises(gonio.Error, match="box"):
        gonio.parallax_corrected(ways, position=(0, 0, 0), captured_at=(0, 0, 0), low=(0, 0, 0))
