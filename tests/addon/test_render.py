# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""`render`: pictures, wrong usage, interruption."""

from __future__ import annotations

import colorsys
import json
import os
import signal
import subprocess
import time

import numpy as np
import OpenImageIO as oiio
import pytest

from support.images import read_all, read_image
from support.paths import ADDON, DRIVER, FIXTURES, OTHER_KINDS

QUICK = ("--stage", "furnace", "--size", "16x16", "--samples", "2")


def assert_same_pixels(first, second):
    """Bit for bit; their metadata hold the time of rendering."""
    (a, _), (b, _) = read_all(first), read_all(second)
    assert (a == b).all()
    assert a.max() > a.min()


def test_same_pixels_every_time(blender, tmp_path):
    outputs = [tmp_path / "a.exr", tmp_path / "b.exr"]
    for path in outputs:
        done = blender.render("--material", "test_film", *QUICK, "-o", path)
        assert done.returncode == 0, done.stderr
    assert_same_pixels(*outputs)


def test_report_and_both_kinds_of_file(blender, tmp_path):
    """In a process of its own, whose output is nothing but the report."""
    exr, png = tmp_path / "a.exr", tmp_path / "a.png"
    done = blender.render_process(
        "--compiled", FIXTURES / "test_grating", *QUICK, "--set", "pitch_nm=800", "--json",
        "-o", exr, "-o", png,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["materials"] == {"test_grating": "osl"}
    assert report["output"] == [str(exr), str(png)]
    assert report["samples"] == 2
    assert report["size"] == [16, 16]
    assert exr.read_bytes()[:4] == b"\x76\x2f\x31\x01"
    assert png.read_bytes()[:4] == b"\x89PNG"
    assert "motion blur is on" in done.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.exr", "a.png", "user"]


def test_a_material_says_on_which_stage_it_is_shown(blender45, tmp_path):
    """Of a kind that nobody knows; the furnace's pictures have a size of their own."""
    done = blender45.render(
        "--compiled",
        OTHER_KINDS / "test_mist",
        "--samples",
        "1",
        "--json",
        "-o",
        tmp_path / "a.exr",
    )
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["materials"] == {"test_mist": "nodes"}
    assert report["size"] == [256, 256]


def test_blend_with_frames_and_assignment(blender, tmp_path):
    blender.script("materials/save", tmp_path, "nodes", "test_film")
    pattern = tmp_path / "f_###.exr"
    done = blender.render(
        "--blend", tmp_path / "saved.blend", "--assign", "Cube=test_film", "--frames", "2-3",
        "--size", "16x16", "--samples", "1", "-o", pattern,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert sorted(p.name for p in tmp_path.glob("f_*")) == ["f_002.exr", "f_003.exr"]


def test_a_stack_is_edited_by_name(blender45, tmp_path, thin_slick):
    blender45 = blender45.with_environment(NACRE_MATERIALS=thin_slick)
    water, gold = tmp_path / "water.exr", tmp_path / "gold.exr"
    for path, substrate in ((water, "water/Daimon-20C"), (gold, "Au/Johnson")):
        done = blender45.render(
            "--material", "oil_on_water", "--set", f"substrate={substrate}", "--set",
            "range_nm=100:200", "--set", "thickness_nm=150", *QUICK, "-o", path,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
    mean = [oiio.ImageBufAlgo.computePixelStats(oiio.ImageBuf(str(p))).avg for p in (water, gold)]
    assert mean[0][0] < 0.35
    assert mean[1][0] > 0.6
    done = blender45.render(
        "--material", "oil_on_water", "--set", "layers.4.medium=air", "--set", "substrate=",
        *QUICK, "-o", water,
    )  # fmt: skip
    assert done.returncode == 1
    assert "--set: layers.4.medium: no such layer; there are layers 0 to 0" in done.stderr
    assert "--set: substrate: must be named" in done.stderr


def test_a_technique_is_asked_for(blender45, tmp_path, thin_slick):
    blender45 = blender45.with_environment(NACRE_MATERIALS=thin_slick)
    rows = "output,technique\nfull,\nairy,airy\nbands,path_difference\nno,free_film\ncut,series\n"
    table = tmp_path / "techniques.csv"
    table.write_text(rows, "utf-8")
    done = blender45.render(
        "--material", "oil_on_water", "--set", "range_nm=100:200", *QUICK,
        "--batch", table, "-o", tmp_path / "out", "--json",
    )  # fmt: skip
    assert done.returncode == 1
    report = json.loads(done.stdout)
    assert sorted(report["rendered"]) == ["airy.png", "bands.png", "cut.png", "full.png"]
    assert "substrate.medium: must equal that of the ambient" in report["failed"]["no.png"]
    full, airy, bands = (
        oiio.ImageBuf(str(tmp_path / "out" / f"{name}.png")) for name in ("full", "airy", "bands")
    )
    assert oiio.ImageBufAlgo.compare(full, airy, 2 / 255, 0).maxerror <= 2 / 255
    assert oiio.ImageBufAlgo.compare(full, bands, 0.1, 0).maxerror > 0.1


BATCH = """output,material,thickness_nm,roughness,size
a,test_film,300,,
sub/b.exr,test_film,500,0.2,12x12
c,test_film,99999,,
"""


def test_batch_goes_on_and_resumes(blender45, tmp_path):
    table, folder = tmp_path / "Tafel é.csv", tmp_path / "out"
    table.write_text(BATCH, "utf-8")
    arguments = ("--batch", table, "--form", "nodes", *QUICK, "-o", folder)
    done = blender45.render(*arguments, "--json")
    assert done.returncode == 1
    report = json.loads(done.stdout)
    assert report["rendered"] == ["a.png", "sub/b.exr"]
    assert report["kept"] == []
    assert list(report["failed"]) == ["c.png"]
    assert f"{table}:4: thickness_nm: must be in [0, 1200] nm (got 99999)" in done.stderr
    spec = oiio.ImageInput.open(str(folder / "sub" / "b.exr")).spec()
    assert (spec.width, spec.height) == (12, 12)
    before = (folder / "a.png").stat().st_mtime_ns

    table.write_text(BATCH.replace("500", "600").replace("99999", "700"), "utf-8")
    done = blender45.render(*arguments, "--json")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["kept"] == ["a.png"]
    assert report["rendered"] == ["sub/b.exr", "c.png"]
    assert (folder / "a.png").stat().st_mtime_ns == before
    assert "2 rendered" not in done.stdout


@pytest.mark.parametrize(
    ("text", "messages"),
    [
        ("material\ntest_film\n", ["1: must have a column output (got material)"]),
        ("output,material\n", ["has no rows"]),
        (
            "output,material\na,test_film\na.png,test_film\n../b,test_film\nc,test_film,7\nd,\n",
            [
                "3: output: already in line 2",
                "4: output: must be a file in the folder",
                "5: has more cells than the first line has names",
                "6: give one of --material",
            ],
        ),
    ],
)
def test_every_fault_of_a_batch_at_once(blender45, tmp_path, text, messages):
    table = tmp_path / "b.csv"
    table.write_text(text, "utf-8")
    done = blender45.render("--batch", table, *QUICK, "-o", tmp_path / "out")
    assert done.returncode == 1
    for message in messages:
        assert message in done.stderr
    assert not (tmp_path / "out").exists()


def test_gallery_shows_every_material(blender45, tmp_path):
    blender45 = blender45.with_materials("tempered_steel", "water")
    folder = tmp_path / "gallery"
    arguments = ("--gallery", "--size", "16x16", "--samples", "1", "-o", folder)
    done = blender45.render(*arguments)
    assert done.returncode == 0, done.stderr
    assert "3 rendered, 0 kept" in done.stdout  # the steel also even
    page = (folder / "index.html").read_text("utf-8")
    for text in (
        "2 materials",
        "Tempered Steel",
        "tempered_steel_swatch.png",
        "5–70 nm",
        "Johnson",
    ):
        assert text in page
    assert "recipes.html" not in page  # no manual is at hand
    assert {path.name for path in folder.glob("*.png")} == {
        "tempered_steel.png", "tempered_steel.even.png", "tempered_steel_swatch.png", "water.png",
    }  # fmt: skip
    assert "0 rendered, 3 kept" in blender45.render(*arguments).stdout


def test_a_look_is_that_of_the_library(blender45, tmp_path):
    """On its own object, heated at one end: its colours run through several hues."""
    library = blender45.with_materials("tempered_steel")
    dressed, even = tmp_path / "dressed.exr", tmp_path / "even.exr"
    common = (
        "--material",
        "tempered_steel",
        "--size",
        "48x48",
        "--samples",
        "4",
        "--form",
        "nodes",
    )
    assert library.render(*common, "--look", "-o", dressed).returncode == 0
    assert library.render(*common, "--stage", "portrait", "-o", even).returncode == 0
    hues = [_saturated_hues(read_image(path)) for path in (dressed, even)]
    assert hues[0] >= 4, hues
    assert hues[0] > hues[1] + 1, hues
    done = library.render(*common, "--look", "--frames", "1-2", "-o", tmp_path / "f_#.png")
    assert "--frames: nothing in the look of tempered_steel moves" in done.stderr
    done = library.render(*common, "--look", "--vary", "swirl", "-o", dressed)
    assert "--look does not go with --vary" in done.stderr


def _saturated_hues(pixels) -> int:
    """How many of twelve hues a picture has where it is coloured."""
    rgb = np.clip(pixels[..., :3].reshape(-1, 3), 1e-6, None)
    largest, least = rgb.max(axis=1), rgb.min(axis=1)
    coloured = rgb[(largest - least) > 0.35 * largest]
    hues = [colorsys.rgb_to_hsv(*colour)[0] for colour in coloured]
    counts, _ = np.histogram(hues, bins=12, range=(0.0, 1.0))
    return int((counts >= 3).sum())


def test_a_value_runs_over_the_frames(blender45, tmp_path):
    arguments = (
        "--material", "test_film", "--animate", "thickness_nm=100:500", "--frames", "1-3",
        "--stage", "furnace", "--size", "16x16", "--samples", "2", "-o",
    )  # fmt: skip
    done = blender45.render(*arguments, tmp_path / "f_#.exr")
    assert done.returncode == 0, done.stderr
    still = tmp_path / "still.exr"
    blender45.render("--material", "test_film", "--set", "thickness_nm=300", *QUICK, "-o", still)
    assert_same_pixels(still, tmp_path / "f_2.exr")
    (tmp_path / "f_2.exr").unlink()
    before = (tmp_path / "f_1.exr").stat().st_mtime_ns
    done = blender45.render(*arguments, tmp_path / "f_#.exr", "--resume", "--json")
    assert json.loads(done.stdout)["output"] == [str(tmp_path / "f_2.exr")]
    assert (tmp_path / "f_1.exr").stat().st_mtime_ns == before


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--material", "soap"], "unknown material 'soap'; there are: test_film, test_grating"),
        (["--material", "test_film", "--technique", "fresnel"], "invalid choice: 'fresnel'"),
        (
            ["--material", "test_grating", "--technique", "airy"],
            "not the template of a film",
        ),
        (
            ["--material", "test_film", "--preset", "thin"],
            "there is no preset 'thin'; there are: none",
        ),
        (["--blend", "a.blend", "--technique", "airy"], "do not go with --blend"),
        (["--blend", "a.blend", "--preset", "thin"], "do not go with --blend"),
        (["--material", "test_film", "--set", "depth=1"], "there are: thickness_nm, roughness"),
        (
            ["--material", "test_film", "--set", "thickness_nm=-5"],
            "must be in [0, 1200] nm (got -5)",
        ),
        (
            ["--material", "test_film", "--stage", "cellar"],
            "unknown stage 'cellar'; there are: furnace",
        ),
        (["--material", "test_film", "--samples", "0"], "must be a whole number ≥ 1 (got '0')"),
        (["--material", "test_film", "--size", "16"], "must be WxH"),
        (["--material", "test_film", "--view", "Sepia"], "--view"),
        (["--material", "test_grating", "--form", "nodes"], "has no form as nodes"),
        (["--compiled", "nowhere"], "must be a folder with one manifest"),
        (["--template", "nowhere.toml"], "--template"),
        (["--blend", "nowhere.blend"], "no file nowhere.blend"),
        (["--material", "test_film", "--frames", "1-2"], "--frames needs --blend"),
        (["--material", "test_film", "--assign", "a=b"], "--assign needs --blend"),
        (["--material", "test_film", "--range", "1:2"], "--range needs --thickness-map"),
        (["--material", "test_film", "--range", "2:1"], "must be LOW:HIGH"),
        (["--material", "test_film", "--vary", "rain"], "--vary"),
        (["--material", "test_grating", "--vary", "drop"], "has no thickness"),
        (
            ["--material", "test_film", "--vary", "drop:depth=1"],
            "nacre render: --vary: drop: no value 'depth'; there are: base_nm, height_nm",
        ),
        (
            ["--material", "test_film", "--vary", "swirl:time_s=1", "--frames", "1-2"],
            "--vary: swirl: time_s does not go with --frames",
        ),
        (["--material", "test_film", "--thickness-map", "nowhere.png"], "--thickness-map"),
        (
            ["--material", "test_film", "--thickness-map", "x.png", "--range", "0:2000"],
            "must be within 0:1200",
        ),
        ([], "give one of --material"),
    ],
)
def test_wrong_usage_is_told_and_writes_nothing(blender45, tmp_path, arguments, message):
    output = tmp_path / "out.exr"
    output.write_bytes(b"kept")
    done = blender45.render(*arguments, "-o", output)
    assert done.returncode == 1
    assert message in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
    assert output.read_bytes() == b"kept"


def test_thickness_varies(blender, tmp_path):
    """Drainage from top to bottom; a swirl moves from frame to frame, the same each time."""
    picture = ("--size", "16x16", "--samples", "1")
    common = ("--material", "test_film", "--stage", "furnace", *picture)
    still, pattern = tmp_path / "still.exr", tmp_path / "f_##.exr"
    done = blender.render(*common, "--vary", "drainage", "-o", still)
    assert done.returncode == 0, done.stderr
    moved = ("--vary", "drainage", "--vary", "swirl", "--frames")
    done = blender.render(*common, *moved, "1-6", "-o", pattern)
    assert done.returncode == 0, done.stderr
    assert len(list(tmp_path.glob("f_*"))) == 6
    done = blender.render(*common, *moved, "6-6", "-o", tmp_path / "again_##.exr")
    assert done.returncode == 0, done.stderr
    first, last, again = (
        oiio.ImageBuf(str(tmp_path / name)).get_pixels(oiio.FLOAT)
        for name in ("f_01.exr", "f_06.exr", "again_06.exr")
    )
    assert (again == last).all()
    assert abs(first - last).max() > 0.01
    done = blender.render(
        *common, "--thickness-map", still, "--range", "100:800", "-o", tmp_path / "map.exr"
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", ["out.jpg", "nowhere/out.exr", "out", f"{'n' * 300}.exr"])
def test_wrong_output_is_told_before_the_work(blender45, tmp_path, name):
    done = blender45.render("--material", "test_film", "-o", tmp_path / name)
    assert done.returncode == 1
    assert "-o: " in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["user"]


def test_names_as_long_as_the_system_allows(blender, tmp_path):
    folder = tmp_path / "Öl 50%.d" / "薄膜"
    folder.mkdir(parents=True)
    most = os.pathconf(folder, "PC_NAME_MAX")
    stem = "薄膜 1.5 %d "
    output = folder / f"{stem}{'n' * (most - len(stem.encode()) - 4)}.exr"
    done = blender.render(
        "--material", "test_film", "--stage", "furnace", "--size", "8x8", "--samples", "1", "-o", output
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert [path.name for path in folder.iterdir()] == [output.name]


@pytest.mark.parametrize(
    "name", ['q"uote', "apo'strophe", "line\nend", "tab\tper%cent{x}", "back\\slash"]
)
def test_shaders_are_compiled_in_any_folder(blender, tmp_path, name):
    """The compiler writes its paths as they are into what it makes."""
    folder = tmp_path / name
    folder.mkdir()
    usual, odd = tmp_path / "usual.exr", tmp_path / "odd.exr"
    osl = ("--material", "test_film", "--form", "osl", *QUICK, "-o")
    assert blender.render(*osl, usual).returncode == 0
    done = blender.with_environment(TMPDIR=str(folder)).render_process(*osl, odd)
    assert done.returncode == 0, done.stderr
    assert_same_pixels(usual, odd)
    assert not any(folder.iterdir())


def test_without_the_package_a_pixel_is_refused(blender45, tmp_path):
    """The checkout's folder, unlike that of the tool, has no package beside it."""
    output = tmp_path / "out.exr"
    arguments = ("render", "--material", "test_film", *QUICK, "--pixel", "4", "4", "-o", output)
    done = blender45.process(ADDON / "background" / "driver.py", *arguments)
    assert done.returncode == 1
    assert done.stdout == ""
    assert "--pixel: Needs the Python package nacre" in done.stderr
    assert not output.exists()


def test_without_the_package_a_gallery_is_not_whole(blender45, tmp_path):
    arguments = ("render", "--gallery", "--form", "nodes", "--size", "8x8", "--samples", "1")
    few = blender45.with_materials("tempered_steel")
    done = few.process(ADDON / "background" / "driver.py", *arguments, "-o", tmp_path / "gallery")
    assert done.returncode == 1
    assert "nacre render: no swatches: Needs the Python package nacre" in done.stderr
    assert (tmp_path / "gallery" / "tempered_steel.png").is_file()


def test_a_film_that_cannot_be_computed_is_no_success(blender45):
    steel = blender45.with_materials("tempered_steel")
    arguments = ["--material", "tempered_steel", *QUICK, "--pixel", "8", "8"]
    status, stdout, stderr = steel.ask("unexpected.pixel", fresh=True, arguments=arguments)
    assert status == 1
    assert "Thickness: " in stdout
    assert "nacre render: --pixel 8 8: no such medium" in stderr


def test_file_that_cannot_be_finished_is_not_left(blender45, tmp_path):
    """The limit on file sizes stands in for a disc that fills up while the picture is written."""
    output = tmp_path / "out.exr"
    output.write_bytes(b"kept")
    command = blender45.command(
        DRIVER, "render", "--material", "test_film", "--stage", "furnace",
        "--size", "128x128", "--samples", "1", "-o", output,
    )  # fmt: skip
    limited = ["bash", "-c", 'trap "" XFSZ; ulimit -f 16; exec "$@"', "bash", *command]
    done = subprocess.run(
        limited,
        env=blender45.surroundings,
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert done.returncode == 1, done.stdout + done.stderr
    assert "could not be written to its end" in done.stderr
    assert output.read_bytes() == b"kept"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out.exr", "user"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupting_leaves_no_half_file(blender45, tmp_path, number):
    command = blender45.command(
        DRIVER, "render", "--material", "test_film", "--stage", "furnace",
        "--size", "1024x1024", "--samples", "100000", "-v", "-o", tmp_path / "out.exr",
    )  # fmt: skip
    process = subprocess.Popen(
        command,
        env=blender45.surroundings,
        stderr=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        text=True,
    )
    for line in process.stderr:  # Blender's own messages: the render is under way
        if "Sample" in line:
            break
    started = time.monotonic()
    process.send_signal(number)
    process.stderr.read()
    assert process.wait(timeout=60) == 128 + number
    assert time.monotonic() - started < 30
    assert [p.name for p in tmp_path.iterdir()] == ["user"]
