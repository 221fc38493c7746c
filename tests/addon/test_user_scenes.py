# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""Scenes of users: the picture is that of the plain scene, or is refused before anything is rendered."""

from __future__ import annotations

import json

import numpy as np
import pytest

from blender.harness import BlenderError
from support.images import read_image

PICTURE = ("--samples", "16", "--form", "nodes")


class Scenes:
    """Pictures of scenes of jobs/user_scenes.py."""

    def __init__(self, blender, folder):
        self.blender, self.folder = blender, folder

    def file(self, kind: str):
        path = self.folder / f"{kind}.blend"
        if not path.is_file():
            try:
                self.blender.call("user_scenes.make", kind=kind, file=str(path))
            except BlenderError as error:
                # Blender 5.2 was seen to crash where it makes a compositor after it has rendered another
                # scene's; what is tested comes after that.
                if "Blender ended by" not in str(error):
                    raise
                self.blender.call("user_scenes.make", kind=kind, file=str(path))
        return path

    def render(self, kind: str, *more: str, assign: str | None = "Cube=test_film"):
        output = self.folder / "out" / f"{kind}.exr"
        output.parent.mkdir(exist_ok=True)
        before = self.left()
        done = self.blender.render(
            "--blend", self.file(kind), *(("--assign", assign) if assign else ()), *PICTURE, *more, "--json",
            "-o", output, "-o", output.with_suffix(".png"),
        )  # fmt: skip
        made = {output, output.with_suffix(".png")} if done.returncode == 0 else set()
        assert self.left() - before == made - before, done.stderr
        assert "Traceback" not in done.stderr
        return done

    def left(self) -> set:
        """Everything but scenes and what is the Blender's own."""
        user = self.folder / "user"
        files = {path for path in self.folder.rglob("*") if path.is_file()}
        return {p for p in files if p.suffix != ".blend" and user not in p.parents}

    def picture(self, kind: str, *more: str) -> np.ndarray:
        done = self.render(kind, *more)
        assert done.returncode == 0, done.stderr
        found = read_image(self.folder / "out" / f"{kind}.exr")
        assert json.loads(done.stdout)["size"] == [found.shape[1], found.shape[0]]
        return found


@pytest.fixture
def scenes(blender, tmp_path):
    return Scenes(blender, tmp_path)


@pytest.mark.parametrize(
    ("kind", "note"),
    [
        ("strip", "Scene: the sequencer's strips are left out"),
        ("compositor", ""),
        ("compositor_without_output", ""),
        ("file_output", "Scene: the compositor's node File Output is left out"),
        ("file_output_alone", "Scene: the compositor's node File Output is left out"),
        ("border", "Scene: the render border is left out"),
        ("second_layer", ""),
        ("scenes", ""),
        ("no_slots", ""),
        ("slot_of_object", ""),
        ("two_slots", ""),
        ("linked", ""),
    ],
)
def test_is_the_picture_of_the_plain_scene(scenes, kind, note):
    plain = scenes.picture("plain")
    assert plain.max() > plain.min()
    scenes.file("plain")
    done = scenes.render(kind)
    assert done.returncode == 0, done.stderr
    assert note in done.stderr
    found = read_image(scenes.folder / "out" / f"{kind}.exr")
    assert found.shape == plain.shape
    assert np.abs(found - plain).max() < 1e-5


def test_a_shared_mesh_changes_on_one_object(scenes):
    assert np.abs(scenes.picture("shared") - scenes.picture("not_shared")).max() < 1e-5


@pytest.mark.parametrize("form", ["nodes", "osl"])
def test_a_point_of_a_cloud_is_a_ball(scenes, form):
    scenes.blender = scenes.blender.with_materials("tempered_steel")
    pictures = []
    for kind in ("ball", "point"):
        done = scenes.render(kind, "--form", form, assign="Ball=tempered_steel")
        assert done.returncode == 0, done.stderr
        pictures.append(read_image(scenes.folder / "out" / f"{kind}.exr"))
    assert pictures[0].min() < 0.8
    assert np.abs(pictures[1] - pictures[0]).mean() < 1e-3


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        ("stereo", "is stereoscopic (views: left, right), and a picture holds one view"),
        ("anaglyph", "is stereoscopic (views: left, right)"),
        ("no_layer", "has no view layer in use (ViewLayer): turn on Use for Rendering"),
        ("no_camera", "has no camera"),
        ("override", "ViewLayer (Clay): clear its Material Override"),
    ],
)
def test_is_refused_before_anything_is_rendered(scenes, kind, message):
    done = scenes.render(kind)
    assert done.returncode == 1
    assert f"{kind}.blend: the scene Scene {message}" in done.stderr or message in done.stderr
    assert done.stdout == ""


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        (
            "broken_shader",
            "Cycles could not load the shader of Test Film, so that nothing is written",
        ),
        ("no_table", "the material Test Film lacks its tables R"),
    ],
)
def test_materials_that_would_be_black_or_magenta_are_no_success(scenes, kind, message):
    done = scenes.render(kind, assign=None)
    assert done.returncode == 1
    assert message in done.stderr
    done = scenes.render(kind)  # another material takes its place
    assert done.returncode == 0, done.stderr


def test_what_a_wave_material_needs_is_turned_on(scenes):
    """Of a file that was saved with it off."""
    done = scenes.render("off", assign=None)
    assert done.returncode == 0, done.stderr
    assert "Test Film: Open Shading Language is on, which it needs" in done.stderr
    off = read_image(scenes.folder / "out" / "off.exr")
    done = scenes.render("plain", "--form", "osl")
    assert np.abs(off - read_image(scenes.folder / "out" / "plain.exr")).max() < 1e-5
    done = scenes.render("dispersed", assign=None)
    assert done.returncode == 0, done.stderr
    assert "Test Grating: motion blur is on, it carries the wavelengths" in done.stderr


def test_linked_objects_that_share_a_mesh_are_refused(scenes):
    scenes.file("shared")
    done = scenes.render("linked_twins")
    assert done.returncode == 1
    assert (
        "--assign: Cube: is linked from shared.blend and has the same data as Twin" in done.stderr
    )


def test_one_of_several_scenes(scenes):
    assert (
        np.abs(scenes.picture("scenes", "--scene", "Shot") - scenes.picture("plain")).max() < 1e-5
    )
    done = scenes.render("scenes", "--scene", "Third")
    assert "--scene: no scene 'Third'; there are: " in done.stderr
    done = scenes.render("scenes", assign="Far=test_film")
    assert done.returncode == 1
    assert "no object 'Far' takes a material in the scene Scene; there are: Cube" in done.stderr
    assert "'Far' is in: Other (--scene)" in done.stderr


def test_the_pixel_is_of_the_layer_that_is_rendered(scenes):
    found = []
    blender = scenes.blender.with_materials("tempered_steel")
    for kind in ("plain", "second_layer", "border"):
        done = blender.render(
            "--blend", scenes.file(kind), "--assign", "Cube=tempered_steel", "--form", "nodes",
            "--pixel", "8", "8", "--json",
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        found.append(json.loads(done.stdout)["probes"])
    assert found[0] == found[1] == found[2]


def test_samples_hold_for_layers_with_a_number_of_their_own(scenes):
    layered = scenes.picture("layer_samples", "--samples", "3")
    assert np.abs(layered - scenes.picture("plain", "--samples", "3")).max() < 1e-5


def test_files_of_other_blenders(blenders, tmp_path):
    """Of an older one as it is, of a newer one with a word about it."""
    both = {version: blenders.get(version, tmp_path) for version in ("4.5", "5.2")}
    if None in both.values():
        pytest.skip("needs both Blenders")
    pictures = []
    for saves, saver in both.items():
        file = tmp_path / f"{saves}.blend"
        saver.call("user_scenes.make", kind="plain", file=str(file))
        for renders, renderer in both.items():
            output = tmp_path / f"{saves}-{renders}.exr"
            done = renderer.render("--blend", file, *PICTURE[:2], "-o", output)
            assert done.returncode == 0, done.stderr
            newer = "saved by Blender 5.2, rendered by 4.5, which leaves out what it does not know"
            assert (newer in done.stderr) == (saves > renders)
            pictures.append(read_image(output))
    assert max(np.abs(picture - pictures[0]).max() for picture in pictures) < 0.02


def test_a_file_that_is_no_blend_is_refused(blender45, tmp_path):
    blender45.call("user_scenes.make", kind="plain", file=str(tmp_path / "cut.blend"))
    cut = (tmp_path / "cut.blend").read_bytes()[:2000]
    for name, content in (("empty", b""), ("text", b"BLENDER but no file"), ("cut", cut)):
        file = tmp_path / f"{name}.blend"
        file.write_bytes(content)
        done = blender45.render("--blend", file, "-o", tmp_path / "out.exr")
        assert done.returncode == 1
        assert f"--blend: {file}: cannot be opened" in done.stderr
        assert not (tmp_path / "out.exr").exists()
