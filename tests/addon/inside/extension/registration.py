# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""On, off and on again leaves nothing behind."""

from __future__ import annotations

import bpy

from jobs.extension import load, module
from support.paths import ADDON


def snapshot() -> dict[str, set[str]]:
    handlers = {
        f"{name}:{handler}"
        for name in dir(bpy.app.handlers)
        if isinstance(getattr(bpy.app.handlers, name), list)
        for handler in getattr(bpy.app.handlers, name)
    }
    drawn = {
        f"{name}:{len(getattr(bpy.types, name)._dyn_ui_initialize())}"
        for name in ("VIEW3D_MT_object", "MATERIAL_MT_context_menu", "VIEW3D_MT_view")
    }
    return {
        "types": set(dir(bpy.types)),
        "operators": set(dir(bpy.ops.nacre)),
        "handlers": handlers,
        "menus": drawn,
        **{
            owner: set(getattr(bpy.types, owner).bl_rna.properties.keys())
            for owner in ("Scene", "Object", "Material", "WindowManager", "ShaderNodeTree")
        },
    }


extension = load()
known = {path.parent.name for path in ADDON.glob("*/feature.py")}
assert set(module("registration").NAMES) == known
extension.register()  # what Blender itself makes once, on first use, is not ours
extension.unregister()
before = snapshot()
for _ in range(2):
    extension.register()
    assert "assign_material" in dir(bpy.ops.nacre)
    assert "nacre" in bpy.types.Scene.bl_rna.properties
    assert snapshot() != before
    extension.unregister()
    after = snapshot()
    assert after == before, {key: after[key] ^ before[key] for key in before}
