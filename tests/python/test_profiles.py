import zipfile

import numpy as np
import pytest

import gonio


def test_facts_are_those_of_the_tool(profiles):
    profile = gonio.read(profiles / "wall-washer.ies")
    assert profile.format == "IES"
    assert profile.declared_flux_lm == 2500.0
    assert profile.input_watts == 24.0
    assert profile.check() == []
    web = profile.web()
    assert web.symmetry == "bilateral-0-180"
    assert web.flux_lm == pytest.approx(2500.0, rel=1e-6)
    assert (web.peak.candela, web.peak.c_deg, web.peak.gamma_deg) == (3543.2, 0.0, 32.5)
    assert web.spread_angle_deg() == pytest.approx(35.0, abs=0.05)
    assert web.spread_angle_deg(90.0) is None
    facts = profile.facts()
    assert facts["schema"] == "gonio.info/1"
    assert (facts["flux_lm"], facts["peak_cd"]) == (web.flux_lm, 3543.2)
    assert facts["lamps"][0]["flux_lm"] == 2500.0
    assert facts["beam_angle_c90_deg"] is None
    assert sum(facts["ten_degree_zones_lm"]) == pytest.approx(web.flux_lm, rel=1e-12)
    assert profile.facts(azimuth="eulumdat")["peak_c_deg"] == 90.0


def test_figures_are_those_of_the_tool(profiles):
    figures = gonio.read(profiles / "bare-tube.ldt").figures()
    assert np.shape(figures["ugr_table"]) == (19, 10)
    assert figures["light_output_ratios"]["ulor"] == pytest.approx(0.5, abs=1e-4)
    assert figures["figure_rules"]["bug"] == "IES TM-15-11"
    point = gonio.read(profiles / "portable" / "downlight.ies")
    assert set(point.figures()["missing_figures"]) <= set(figures["figure_rules"])


def test_samples_over_arrays(profiles):
    web = gonio.read(profiles / "wall-washer.ies").web()
    assert isinstance(web.sample(0, 32.5), float)
    table = web.sample(web.horizontal_deg[:, None], web.vertical_deg)
    assert np.array_equal(table, web.candela)
    c, gamma = np.radians(30.0), np.radians(20.0)
    direction = [np.sin(gamma) * np.cos(c), np.sin(gamma) * np.sin(c), -np.cos(gamma)]
    assert web.sample_directions(direction) == pytest.approx(web.sample(30.0, 20.0), rel=1e-12)
    assert web.sample_directions(np.ones((4, 5, 3))).shape == (4, 5)
    with pytest.raises(gonio.Error, match="last axis has 3"):
        web.sample_directions([1.0, 2.0])


def test_tables_are_views(profiles):
    web = gonio.read(profiles / "wall-washer.ies").web()
    table = web.candela
    assert table.base is web and not table.flags.writeable
    assert web.candela.ctypes.data == table.ctypes.data
    del web
    assert table.max() == 3543.2


def test_conversion_reports_losses_and_keeps_the_light(profiles, tmp_path):
    profile = gonio.read(profiles / "wall-washer.ies")
    converted = profile.convert("ldt")
    assert [d.code for d in converted.diagnostics] == ["WEB0201", "WEB0220"]
    converted.save(tmp_path / "washer.ldt")
    again = gonio.read(tmp_path / "washer.ldt")
    assert again.format == "LDT"
    assert again.web().difference(profile.web()).relative < 1e-12
    assert gonio.parse(profile.to_bytes(), "copy.ies").to_bytes() == profile.to_bytes()


def test_reads_the_photometry_of_a_gldf(profiles, tmp_path):
    product = (
        '<Root><GeneralDefinitions><Files><File id="f" contentType="ldc/eulumdat" type="localFileName">a.ldt</File></Files>'
        '<Photometries><Photometry id="p"><PhotometryFileReference fileId="f"/></Photometry></Photometries>'
        "</GeneralDefinitions></Root>"
    )
    with zipfile.ZipFile(tmp_path / "lamp.gldf", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("product.xml", product)
        archive.write(profiles / "downlight.ldt", "ldc/a.ldt")
    web = gonio.read(tmp_path / "lamp.gldf").web()
    assert web.flux_lm == gonio.read(profiles / "downlight.ldt").web().flux_lm


def test_edits():
    web = gonio.make_web("downlight:beam=30deg", 1000.0)
    assert web.scaled_to(500.0).flux_lm == pytest.approx(500.0)
    assert web.scaled_by(2.0).peak.candela == pytest.approx(2.0 * web.peak.candela)
    assert web.cropped(0.0, 10.0).sample(0.0, 20.0) == 0.0
    tilted = web.tilted(20.0, 90.0)
    assert tilted.web.peak.gamma_deg == pytest.approx(20.0, abs=2.5)
    assert tilted.max_error_cd < 0.01 * web.peak.candela
    assert web.mirrored("c0-180").difference(web).relative < 1e-12
    assert web.rotated(90.0).web.difference(web).relative < 1e-12
    profile = gonio.to_profile(web, "ldt", keywords={"LUMINAIRE": "Spot"}, input_watts=12.0)
    assert ("LUMINAIRE", "Spot") in profile.keywords and profile.input_watts == 12.0


def test_a_web_of_arrays():
    gamma = np.linspace(0.0, 90.0, 91)
    web = gonio.Web([0.0], gamma, 100.0 * np.cos(np.radians(gamma))[None, :], symmetry="axial")
    assert web.flux_lm == pytest.approx(100.0 * np.pi, rel=1e-4)
    assert web.sample(123.0, 60.0) == pytest.approx(50.0)


def test_errors_say_where(profiles):
    cut = (profiles / "downlight.ies").read_bytes()[:800]
    with pytest.raises(gonio.Error) as caught:
        gonio.parse(cut, "cut.ies")
    error = caught.value
    assert (error.code, error.file, error.line, error.column) == ("IES0206", "cut.ies", 18, 208)
    # README.md shows the tool's words.
    assert error.message == "91 candela values announced (91 vertical times 1 horizontal angles), 21 found"
    assert isinstance(error, ValueError)
    with pytest.raises(OSError) as missing:
        gonio.read("no such file.ies")
    assert missing.value.code == "FIL0102"
    with pytest.raises(gonio.Error, match="did you mean 'ldt'"):
        gonio.read(profiles / "downlight.ies").convert("ldd")
    assert gonio.explain("WEB0301").startswith("more light than the lamps give")


def test_checks_the_physics(profiles):
    text = (profiles / "wall-washer.ies").read_bytes().replace(b"\r\n1 2500", b"\r\n1 2000")
    (warning,) = gonio.parse(text, "washer.ies").check()
    assert (warning.code, warning.severity, warning.line, warning.column) == ("WEB0301", "warning", 13, 3)


def test_notebooks_show_diagrams(profiles):
    profile = gonio.read(profiles / "street.ldt")
    assert profile._repr_svg_().startswith("<")
    assert "<svg" in profile.web().svg("heat-map", title="Street")
