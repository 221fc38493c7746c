# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What befalls one request is told, and stays that request's alone."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

from blender.harness import VERSIONS, Blender, BlenderError, Blenders
from support.paths import ROOT


@pytest.fixture(scope="module")
def servers():
    """Apart from those of the session, which nothing here may end."""
    found = Blenders()
    yield found
    found.close()


@pytest.fixture
def blender(servers, tmp_path) -> Blender:
    found = servers.get("4.5", tmp_path)
    if found is None:
        pytest.skip(f"{VERSIONS['4.5']} names no Python with bpy 4.5")
    return found


@pytest.fixture
def ends(blender):
    """The process that a test begins with is not the one that is asked after it."""
    before = blender.call("trouble.which")
    yield
    assert blender.call("trouble.which") != before


def test_one_process_answers_all(blender):
    assert blender.call("trouble.which") == blender.call("trouble.which")
    assert blender.server.starts == 1


@pytest.mark.usefixtures("ends")
def test_a_crash_costs_one_picture(blender):
    jobs = {
        "before": {"red": 0.25},
        "crash": {"red": 0.5, "number": signal.SIGABRT},
        "after": {"red": 0.75},
    }
    picture = blender.pictures("trouble.paint", jobs.get)
    assert picture("before")[0, 0].tolist() == [0.25, 0, 0]
    for _ in range(2):  # told to all who ask for it, and not tried again
        with pytest.raises(
            BlenderError, match=r"trouble\.paint: Blender ended by SIGABRT"
        ) as failed:
            picture("crash")
        assert "last words" in str(failed.value)
    assert picture("after")[0, 0].tolist() == [0.75, 0, 0]


@pytest.mark.usefixtures("ends")
def test_an_end_with_a_status_is_told(blender):
    with pytest.raises(BlenderError, match=r"trouble\.leave: Blender ended by status 3"):
        blender.call("trouble.leave", status=3)


@pytest.mark.usefixtures("ends")
def test_an_exception_comes_with_what_was_printed(blender):
    with pytest.raises(BlenderError) as failed:
        blender.call("trouble.fail")
    for words in ("ValueError: no such film", "in fail", "said before", "complained before"):
        assert words in str(failed.value)


@pytest.mark.usefixtures("ends")
def test_silence_has_an_end(blender, tmp_path):
    with pytest.raises(BlenderError, match=r"trouble\.sleep: no answer within 0\.5 s"):
        blender.server.request(
            "trouble.sleep", {"seconds": 60}, environment=blender.surroundings, folder=tmp_path,
            fresh=False, timeout=0.5,
        )  # fmt: skip


@pytest.mark.usefixtures("ends")
@pytest.mark.parametrize("what", ["stay_registered", "leave_handler"])
def test_what_stays_registered_ends_with_the_process(blender, what):
    blender.call(f"trouble.{what}")


MESS = """
import os, sys
import bpy
import neighbour
from jobs import extension
assert sys.argv[1:] == ["a b"]
assert os.environ["NACRE_TEST_VARIABLE"] == "own"
extension.load()
bpy.ops.mesh.primitive_cube_add()
bpy.context.object.name = "Left"
bpy.context.preferences.filepaths.asset_libraries.new(name="Left", directory=os.getcwd())
os.environ["NACRE_TEST_VARIABLE"] = "left"
os.chdir("/")
sys.path.insert(0, "/nacre-test/left")
neighbour.state.append("left")
"""


def test_nothing_is_left_to_the_next(blender, tmp_path):
    (tmp_path / "neighbour.py").write_text("state = []\nprint('made anew')\n")
    script = tmp_path / "mess.py"
    script.write_text(MESS)
    own = blender.with_environment(NACRE_TEST_VARIABLE="own")
    plain, _, _ = blender.ask("trouble.surroundings", fresh=True)
    assert plain["variable"] is None
    assert plain["path"] == []
    before = blender.call("trouble.which")
    for _ in range(2):
        assert "made anew" in own.script(script, "a b")
        assert blender.ask("trouble.surroundings", fresh=True)[0] == plain
    assert blender.call("trouble.which") == before


def test_a_version_that_is_not_there_is_skipped_with_a_word():
    environment = {
        name: value
        for name, value in os.environ.items()
        if name not in VERSIONS.values() and not name.startswith("PYTEST")
    }
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-rs", "-p", "no:xdist", "-p", "no:cacheprovider",
         "tests/addon/test_blender.py", "-k", "registers"],
        cwd=ROOT, env=environment, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert "2 skipped" in done.stdout, done.stdout
    for version, variable in VERSIONS.items():
        assert f"{variable} names no Python with bpy {version}" in done.stdout
