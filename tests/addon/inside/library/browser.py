# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The side bar: what is typed chooses, what was assigned is remembered, favourites stay."""

from __future__ import annotations

from types import SimpleNamespace

import bpy

from jobs.extension import load, module
from jobs.steps import new_file, refused

extension = load()
extension.register()
chosen = module("browser.chosen")
thumbnails = module("browser.thumbnails")
words = module("core.words")
entries = module("core.looks").variants(module("core.library").Library.default().entries())
browser = bpy.context.window_manager.nacre

# All of them at first, each with its picture.
assert list(entries) == [item[0] for item in module("browser.properties")._choices(browser, None)]
assert browser.choice in entries
# Without a window pictures are read but have no icons.
assert set(thumbnails._collections[0]) == set(entries)
assert thumbnails.icon("nothing") == 0

# What is typed finds, and chooses the first unless what is chosen is found as well.
for word in ("oil", "OIL on wat", "gasoline", "thin film", "disc"):
    browser.search = word
    found = [item.key for item in entries.values() if words.finds(item.entry, word)]
    assert browser.choice == (kept if (kept := browser.choice) in found else found[0]), word
browser.search = "disc"
kept = browser.choice
browser.search = ""
assert browser.choice == kept
browser.search = "spaghetti"
assert browser.choice not in entries
browser.search = ""
assert browser.choice in entries


# What needs Open Shading Language cannot be chosen without it, and says so before it is tried.
class Layout:
    """Stands for a UILayout: what is said, and which buttons can be pressed."""

    def __init__(self, said, buttons):
        self.said, self.buttons, self.enabled = said, buttons, True

    def row(self, **_options):
        return Layout(self.said, self.buttons)

    column = grid_flow = row

    def label(self, text="", icon="NONE"):
        self.said.append((text, icon))

    def operator(self, name, **_options):
        self.buttons.append((name, self.enabled))
        return SimpleNamespace()

    def prop(self, *_arguments, **_options):
        pass

    template_icon_view = template_icon = prop


def drawn(material):
    said, buttons = [], []
    browser.choice = material
    assert browser.choice == material
    context = bpy.context
    panel.NACRE_PT_viewport.draw(SimpleNamespace(layout=Layout(said, buttons)), context)
    return " ".join(text for text, _ in said), {icon for _, icon in said}, dict(reversed(buttons))


panel = module("browser.panel")
osl_alone = {
    name: item.entry.kind for name, item in entries.items() if item.entry.forms == ("osl",)
}
assert {"cd", "dvd", "disc", "thin_film"} <= set(osl_alone)
assert set(osl_alone.values()) == {"grating", "shader"}
assert drawn("cd")[2]["nacre.assign_material"]
real, panel.has_osl = panel.has_osl, lambda: False
said, icons, buttons = drawn("cd")
assert "Open Shading Language" in said
assert "LOCKED" in icons
assert not buttons["nacre.assign_material"]
assert drawn("soap_film")[2]["nacre.assign_material"]
panel.has_osl = real

# Remembered, the last one first, each once, and no more than there is room for.
cube = new_file()
browser = bpy.context.window_manager.nacre
names = list(entries)[:9]
for name in [*names, *names[:2]]:
    bpy.ops.nacre.assign_material(
        material=name, form="nodes" if entries[name].entry.kind == "film" else "osl"
    )
assert chosen.recent(entries)[:2] == [names[1], names[0]]
assert browser.choice == names[1]  # the picture is that of what was assigned
assert len(chosen.recent(entries)) == len(set(chosen.recent(entries))) <= chosen.MOST_RECENT
cube.select_set(False)
bpy.context.view_layer.objects.active = None
refused(lambda: bpy.ops.nacre.assign_material(material=name), "poll()")

# There and back; what a library has no more is not shown, and not forgotten.
first, second = names[:2]
assert bpy.ops.nacre.favourite(material=first) == {"FINISHED"}
assert bpy.ops.nacre.favourite(material=second) == {"FINISHED"}
assert chosen.favourites(entries) == [first, second]
chosen._kept().favourites += " of_a_larger_library"
assert chosen.favourites(entries) == [first, second]
assert bpy.ops.nacre.favourite(material=first) == {"FINISHED"}
assert chosen.favourites(entries) == [second]
assert "of_a_larger_library" in chosen._kept().favourites
extension.unregister()
assert not hasattr(bpy.types.WindowManager, "nacre")
