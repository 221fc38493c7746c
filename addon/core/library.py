# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiled materials at hand: bundled with the extension, or a folder named by the environment."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from .looks import look_of
from .manifest import FORMS, CompiledMaterial, ManifestError, load_folder, read_manifest
from .traits import UNSAID, Traits, of_header

ENVIRONMENT = "NACRE_MATERIALS"


@dataclass(frozen=True)
class Entry:
    """What a list of materials shows."""

    id: str
    name: str
    category: str
    description: str
    kind: str
    tags: tuple[str, ...] = ()
    forms: tuple[str, ...] = FORMS
    varies: bool = False  # whether its picture shows a thickness that does
    traits: Traits = UNSAID


class Library:
    _default: Library | None = None

    def __init__(self, root: Path):
        self.root = root
        self._entries: dict[str, Entry] | None = None
        self._stamp = self._stamps()

    @classmethod
    def default(cls) -> Library:
        """The same one, manifests read once, until a manifest changes: panels ask at each redraw."""
        bundled = Path(__file__).resolve().parents[1] / "compiled"
        root = Path(os.environ.get(ENVIRONMENT) or bundled)
        kept = Library._default
        if kept is None or kept.root != root or kept._stamps() != kept._stamp:
            kept = Library._default = cls(root)
        return kept

    def entries(self) -> dict[str, Entry]:
        """By id, in the order of categories and names; folders that cannot be read are left out."""
        if self._entries is None:
            found = [entry for entry in map(_entry, self._folders()) if entry]
            found.sort(key=lambda entry: (entry.category, entry.name))
            self._entries = {entry.id: entry for entry in found}
        return self._entries

    def load(self, material_id: str) -> CompiledMaterial:
        if not isinstance(material_id, str) or material_id not in self.entries():
            known = ", ".join(sorted(self.entries())) or f"none, as {self.root} holds no materials"
            raise ManifestError(f"unknown material {material_id!r}; there are: {known}")
        return load_folder(self.root / material_id)

    def _stamps(self) -> dict[str, tuple[int, ...]]:
        """What tells each manifest from one that takes its place: its time alone does not, an archive
        may bring an old one along."""
        stamps = {}
        for folder in self._folders():
            try:
                status = _manifest(folder).stat()
            except OSError:
                continue
            stamps[folder.name] = (
                status.st_ino,
                status.st_size,
                status.st_mtime_ns,
                status.st_ctime_ns,
            )
        return stamps

    def _folders(self) -> list[Path]:
        return sorted(path for path in self.root.glob("*") if path.is_dir())


def _manifest(folder: Path) -> Path:
    return folder / f"{folder.name}.json"


def _entry(folder: Path) -> Entry | None:
    try:
        data = read_manifest(_manifest(folder))
    except ManifestError:
        return None
    if data["id"] != folder.name:
        return None
    return Entry(
        id=data["id"],
        name=data["name"],
        category=data["category"],
        description=data["description"],
        kind=data["kind"],
        tags=tuple(map(str, data.get("tags") or ())),
        forms=tuple(form for form in FORMS if data["graphs"].get(form) is not None),
        varies=bool((look := look_of(data)) and look.thickness),
        traits=of_header(data),
    )
