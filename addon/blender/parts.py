# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a feature adds to Blender or to other features, besides classes, while the extension is registered."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import bpy


class Part(Protocol):
    """A module may be one, too."""

    def register(self) -> None: ...
    def unregister(self) -> None: ...


@dataclass(frozen=True)
class Joined:
    """An item of a list."""

    items: list[Any]
    item: Any

    def register(self) -> None:
        self.items.append(self.item)

    def unregister(self) -> None:
        self.items.remove(self.item)


class Extended:
    """A class of Blender's, or one that is registered already, with further properties."""

    def __init__(self, owner: type, **properties: object) -> None:
        self.owner, self.properties = owner, properties

    def register(self) -> None:
        for name, made in self.properties.items():
            setattr(self.owner, name, made)

    def unregister(self) -> None:
        for name in reversed(self.properties):
            delattr(self.owner, name)


@dataclass(frozen=True)
class InMenu:
    """Entries at the end of a menu of Blender's."""

    menu: str
    draw: Callable[[bpy.types.Menu, bpy.types.Context], None]

    def register(self) -> None:
        getattr(bpy.types, self.menu).append(self.draw)

    def unregister(self) -> None:
        getattr(bpy.types, self.menu).remove(self.draw)


@dataclass(frozen=True)
class Forgotten:
    """What a session remembers until the extension goes."""

    forget: Callable[[], None]

    def register(self) -> None:
        """There is nothing to remember yet."""

    def unregister(self) -> None:
        self.forget()
