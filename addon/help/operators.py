# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual, and what a report of a fault should say."""

from __future__ import annotations

import platform
import sys
from pathlib import Path

import bpy
from bpy.props import EnumProperty, StringProperty

from ..core import manual
from ..core.computation import library_problem
from ..core.library import Library
from ..materials.guard import reports_errors
from ..materials.script import has_osl


class NACRE_OT_open_manual(bpy.types.Operator):
    bl_idname = "nacre.open_manual"
    bl_label = "Nacre: Open Manual"
    bl_description = "Open the manual, which came with the extension, in the browser"

    page: EnumProperty(
        name="Page",
        description="Which page",
        items=[(*item, number) for number, item in enumerate(manual.PAGES)],
    )
    said: StringProperty(
        name="Said",
        description="What the button that opens the page explains by itself",
        options={"HIDDEN", "SKIP_SAVE"},
    )

    @classmethod
    def description(cls, _context, properties):
        if properties.said:
            return f"{properties.said}.\nA click opens the manual."
        text = next(text for name, _, text in manual.PAGES if name == properties.page)
        return f"{text}: opens the manual in the browser."

    @classmethod
    def poll(cls, _context):
        if not manual.is_there():
            cls.poll_message_set("The manual is in the packaged extension; here, see cpp_tools/doc")
            return False
        return True

    @reports_errors
    def execute(self, _context):
        bpy.ops.wm.url_open(url=manual.page(self.page).as_uri())
        return {"FINISHED"}


class NACRE_OT_copy_report(bpy.types.Operator):
    bl_idname = "nacre.copy_report"
    bl_label = "Nacre: Copy for a Bug Report"
    bl_description = (
        "Copy the versions of Nacre, Blender and the system, and what is at hand, for a report"
    )

    @reports_errors
    def execute(self, context):
        context.window_manager.clipboard = report()
        self.report({"INFO"}, "Copied; paste it into the report, with what you did and expected.")
        return {"FINISHED"}


def report() -> str:
    library = Library.default()
    lines = {
        "Nacre": f"{_version()}, {len(library.entries())} materials",
        "Computation": library_problem() or "at hand",
        "Blender": f"{bpy.app.version_string} ({bpy.app.build_hash.decode()})",
        "Open Shading Language": "yes" if has_osl() else "no",
        "Engine": bpy.context.scene.render.engine,
        "Python": sys.version.split()[0],
        "System": platform.platform(),
    }
    return "\n".join(f"{name}: {value}" for name, value in lines.items())


def _version() -> str:
    import tomllib

    text = (
        Path(__file__).resolve().parent.parent.joinpath("blender_manifest.toml").read_text("utf-8")
    )
    return tomllib.loads(text)["version"]


def manual_map():
    """F1 over an operator of ours."""
    prefix = f"{manual.FOLDER.as_uri()}/"
    pages = (
        ("bpy.ops.nacre.*thickness*", "thickness.html"),
        ("bpy.ops.nacre.*layer*", "stacks.html"),
        ("bpy.ops.nacre.*stack*", "stacks.html"),
        ("bpy.ops.nacre.*template*", "stacks.html"),
        ("bpy.ops.nacre.*probe*", "viewer.html"),
        ("bpy.ops.nacre.*", "blender.html"),
    )
    return prefix, pages


CLASSES = (NACRE_OT_open_manual, NACRE_OT_copy_report)


def register() -> None:
    bpy.utils.register_manual_map(manual_map)


def unregister() -> None:
    bpy.utils.unregister_manual_map(manual_map)
