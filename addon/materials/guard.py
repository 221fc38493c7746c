# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns faults into reports."""

from __future__ import annotations

import functools
import traceback

import bpy

from ..core.faults import ForeseenError
from . import schema
from .material import belongs_here, group_node

_EXPECTED = (ForeseenError, OSError, RuntimeError)


def must_be_local(name: str, library: bpy.types.Library | None) -> str:
    source = library.name if library else "another file"
    return f"{name} is linked from {source}: make it local first"


def allows_change(operator: type[bpy.types.Operator], material: bpy.types.Material) -> bool:
    """For `poll`: whether a wave material may be changed; if not, the operator says why."""
    if not material.is_editable:
        operator.poll_message_set(must_be_local("The material", material.library))
        return False
    if not belongs_here(material):
        source = material.override_library.reference.library.name
        operator.poll_message_set(
            f"The material is a library override from {source}: make it local first"
        )
        return False
    refusal = schema.refusal(group_node(material).node_tree)
    if refusal:
        operator.poll_message_set(refusal)
    return not refusal


def reports_errors(execute):
    """For `execute`: a fault becomes an error report, and the operator cancels. One that nobody thought
    of, such as a name that this Blender does not know, is told to the console in full as well."""

    @functools.wraps(execute)
    def guarded(self, context):
        try:
            return execute(self, context)
        except _EXPECTED as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except Exception as error:
            traceback.print_exc()
            self.report({"ERROR"}, f"{type(error).__name__}: {error}")
            return {"CANCELLED"}

    return guarded
