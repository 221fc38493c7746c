# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The extension inside Blender 4.5 and 5.2."""

from __future__ import annotations

import pytest

from support.paths import OTHER_KINDS, materials_folder


def test_registers_and_unregisters_without_trace(blender):
    blender.script("extension/registration")


def test_assigns_in_both_forms_and_mends(blender):
    blender.script("library/assign")


def test_thickness_varies(blender, tmp_path):
    blender.script("thickness/each_source", tmp_path)


def test_sources_lie_upon_others(blender):
    blender.script("thickness/upon_others")


def test_manifests_say_what_is_done(blender):
    blender.script("materials/other_kinds", OTHER_KINDS)


def test_materials_are_in_the_asset_browser(blender):
    blender = blender.with_materials("tempered_steel", "water")
    blender.script("library/assets")


@pytest.mark.parametrize("form", ["osl", "nodes"])
def test_missing_tables_are_flat_not_magenta(blender, tmp_path, form):
    blender.script("materials/missing", tmp_path, form)


def test_all_ways_in_which_a_table_is_missing(blender, tmp_path):
    blender.script("materials/images", tmp_path)


@pytest.mark.parametrize("form", ["osl", "nodes"])
def test_stack_is_edited(blender, tmp_path, form, thin_slick):
    blender.with_environment(NACRE_MATERIALS=thin_slick).script("films/stack", tmp_path, form)


def test_a_stack_keeps_the_light_that_it_was_compiled_for(blender, tmp_path, sodium_slick):
    blender.with_environment(NACRE_MATERIALS=sodium_slick).script("films/compiled_light", tmp_path)


def test_side_bar(blender, tmp_path):
    shipped = str(materials_folder())
    blender.with_environment(NACRE_MATERIALS=shipped).script("library/browser", tmp_path)


def test_materials_look_like_their_pictures(blender):
    shipped = str(materials_folder())
    blender.with_environment(NACRE_MATERIALS=shipped).script("library/dressed")


def test_asset_library_is_made_aside(blender, tmp_path, thin_slick):
    blender.with_environment(NACRE_MATERIALS=thin_slick).script("library/asset_build", tmp_path)


def test_other_versions_and_damage(blender, tmp_path, thin_slick):
    blender.with_environment(NACRE_MATERIALS=thin_slick).script("materials/versions", tmp_path)


@pytest.mark.parametrize(
    "script",
    [
        "materials/linked",
        "films/storm",
        "extension/panels",
        "materials/paths",
        "materials/copies",
        "films/own_entry",
        "scenes/lighting",
        "extension/tooltips",
        "scenes/portraits",
    ],
)
def test_bad_input_and_upkeep(blender, tmp_path, script, thin_slick):
    blender.with_environment(NACRE_MATERIALS=thin_slick).script(script, tmp_path)


def test_saved_files_render_the_same_without_the_extension(blender, tmp_path):
    """In a Blender that has never seen it."""
    saved = []
    for form, material in (("osl", "test_film"), ("nodes", "test_film"), ("osl", "test_grating")):
        saved.append(tmp_path / f"{form}_{material}")
        saved[-1].mkdir()
        blender.script("materials/save", saved[-1], form, material)
    nowhere = blender.with_environment(NACRE_MATERIALS=str(tmp_path / "nowhere"))
    nowhere.script_process("materials/reopen", *saved)


def test_osl_asks_for_no_file_without_a_name(blender, tmp_path):
    """Packed tables are looked up outside the shader; Cycles 5.2 tells of textures that it cannot find."""
    blender = blender.with_materials("oil_on_water")
    printed = blender.script("materials/save", tmp_path, "osl", "oil_on_water")
    assert "Failed to load" not in printed


def test_spectral_scene_and_back(blender, tmp_path):
    blender.script("spectral/scene", tmp_path)


def test_lamps_of_a_spectral_file(blender, tmp_path):
    blender.script("spectral/lamps", tmp_path)


def test_surfaces_of_a_spectral_file(blender, tmp_path):
    blender.script("spectral/surfaces", tmp_path)


def test_what_paths_draw(blender):
    blender.script("spectral/draws")


def test_films_and_keyframes_in_a_spectral_file(blender, tmp_path):
    blender = blender.with_materials("oil_on_water", "tempered_steel")
    blender.script("spectral/films", tmp_path)
