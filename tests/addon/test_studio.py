# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Colour configs of studios, which have none of the names that Blender's own has."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from blender.harness import Blender, Server, server_command
from support.images import read_all
from support.paths import ROOT

CONFIG = ROOT / "tests" / "support" / "studio.ocio"
QUICK = ("--stage", "furnace", "--size", "16x16", "--samples", "2")


@pytest.fixture(scope="module")
def studio_servers():
    """Blender reads the variable when it starts."""
    started: dict[str, Server] = {}
    yield started
    for server in started.values():
        server.close()


@pytest.fixture
def studio(blender, studio_servers) -> Blender:
    if blender.version not in studio_servers:
        command = ["env", f"OCIO={CONFIG}", *server_command(blender.python)]
        studio_servers[blender.version] = Server(command)
    studio = replace(blender, server=studio_servers[blender.version])
    return studio.with_environment(OCIO=str(CONFIG))


@pytest.mark.parametrize("script", ["library/assign", "materials/unmade"])
def test_assigning(studio, script):
    studio.script(script)


@pytest.mark.parametrize("script", ["materials/copies", "extension/panels"])
def test_edited_materials(studio, tmp_path, script, thin_slick):
    studio.with_environment(NACRE_MATERIALS=thin_slick).script(script, tmp_path)


def test_the_probe(studio, tmp_path):
    studio.with_materials("soap_film", "jewel_beetle").script("viewer/probe", tmp_path, "nodes")


@pytest.mark.parametrize("script", ["thickness/each_source", "viewer/views"])
def test_operators(studio, tmp_path, script):
    studio.script(script, tmp_path)


def test_missing_tables(studio, tmp_path):
    studio.script("materials/missing", tmp_path, "nodes")


def test_the_asset_library(studio):
    studio.with_materials("tempered_steel", "water").script("library/assets")


def test_an_edited_stack(studio, tmp_path, thin_slick):
    edited = studio.with_environment(NACRE_MATERIALS=thin_slick)
    edited.script("films/stack", tmp_path, "nodes")


def test_a_file_of_another_config(blender, studio, tmp_path):
    blender.script("materials/save", tmp_path, "nodes", "test_film")
    saved = tmp_path / "saved.blend"
    studio.script("materials/studio", saved)
    output = tmp_path / "out.exr"
    done = studio.render("--blend", saved, "--size", "16x16", "--samples", "1", "-o", output)
    assert done.returncode == 0, done.stderr


def test_a_batch(studio, tmp_path):
    """Forms and views, those of Blender's own config among them."""
    table, folder = tmp_path / "looks.csv", tmp_path / "out"
    table.write_text(
        "output,material,form,view\n"
        "film,test_film,osl,\n"
        "nodes.exr,test_film,nodes,\n"
        "grating,test_grating,osl,Ungraded\n"
        "standard,test_film,nodes,Standard\n"
        "last,test_film,nodes,Graded\n",
        "utf-8",
    )
    done = studio.render("--batch", table, *QUICK, "-o", folder, "--json")
    assert done.returncode == 1
    assert "Traceback" not in done.stderr
    report = json.loads(done.stdout.splitlines()[-1])
    assert report["rendered"] == ["film.png", "nodes.exr", "grating.png", "last.png"]
    assert report["failed"] == {
        "standard.png": f"{table}:5: --view: no view 'Standard'; there are: 'Graded', 'Ungraded'"
    }
    assert "no view 'Khronos PBR Neutral'; seen by 'Graded'" in done.stderr
    pixels, _ = read_all(folder / "nodes.exr")
    assert pixels.max() > pixels.min()


def test_the_gallery_draws_the_same_swatches(studio, blender, tmp_path):
    """They are sRGB as they are, whatever the config makes of a picture."""
    drawn = []
    library = {"NACRE_MATERIALS": str(studio.with_materials("tempered_steel").folder / "library")}
    for name, made in (("studio", studio), ("usual", blender)):
        done = made.with_environment(**library).render(
            "--gallery", "--size", "16x16", "--samples", "1", "-o", tmp_path / name
        )
        assert done.returncode == 0, done.stderr
        drawn.append(read_all(tmp_path / name / "tempered_steel_swatch.png")[0])
    assert (drawn[0] == drawn[1]).all()


def test_what_blender_says_of_a_config_is_no_part_of_a_report(studio, tmp_path):
    done = studio.render_process(
        "--material", "test_film", *QUICK, "-o", tmp_path / "a.exr", "--json"
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["output"] == [str(tmp_path / "a.exr")]
    assert str(CONFIG) in done.stderr


def test_blenders_own_exceptions_end_one_row(blender, tmp_path):
    table, folder = tmp_path / "looks.csv", tmp_path / "out"
    table.write_text("output,stage\na,furnace\nb,plane\nc/d,furnace\ne/f,furnace\n", "utf-8")
    folder.mkdir()
    (folder / "c").write_text("no folder", "utf-8")
    arguments = ("--batch", table, "--material", "test_film", "--form", "nodes", "--json",
                 "--size", "16x16", "--samples", "1", "-o", folder)  # fmt: skip
    status, stdout, stderr = blender.ask(
        "unexpected.render", fresh=True, arguments=[str(a) for a in arguments], fails_at="plane"
    )
    assert status == 1
    assert "Traceback" not in stderr
    report = json.loads(stdout)
    assert report["rendered"] == ["a.png", "e/f.png"]
    assert list(report["failed"]) == ["b.png", "c/d.png"]
    assert report["failed"]["b.png"].startswith(f"{table}:3: Blender {blender.version}")
    assert 'TypeError: bpy_struct: item.attr = val: enum "Data" not found in ()' in stderr
    assert sorted(path.name for path in folder.rglob("*.png")) == ["a.png", "f.png"]


def test_blenders_own_exceptions_are_one_line(blender45, tmp_path):
    arguments = ["--material", "test_film", "--stage", "plane", "-o", str(tmp_path / "a.png")]
    asked = {"fresh": True, "fails_at": "plane"}
    status, stdout, stderr = blender45.ask("unexpected.render", arguments=arguments, **asked)
    assert (status, stdout) == (1, "")
    assert "Traceback" not in stderr
    assert "gave up: TypeError: bpy_struct" in stderr
    _, _, stderr = blender45.ask("unexpected.render", arguments=[*arguments, "-v"], **asked)
    assert "Traceback" in stderr
