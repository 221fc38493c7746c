# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled materials: reads and checks what `nacre compile` writes (cpp_tools/doc/manifest.md)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .faults import ForeseenError
from .graph import Graph, parse_graph
from .light import USUAL, Conditions, conditions_problem
from .looks import PLAIN, Look, look_of
from .presets import Preset, parse_presets
from .space import REC709, Matrix, SpaceError, parse
from .traits import UNSAID, Traits, assumed, parse_traits

SCHEMA = 1
FORMS = ("osl", "nodes")
BANDS = "bands"
"""The form where bands of wavelengths are rendered; of materials that need one of their own."""
SOCKET_TYPES = ("float", "int", "color", "normal", "tangent")
DIRECTIONS = ("normal", "tangent")  # left to the geometry where nothing is plugged in
THICKNESSES = ("thickness_nm", "thickness_scale")
"""Sockets that say how thick a material is."""
_TEXT_FIELDS = (
    "id",
    "name",
    "kind",
    "category",
    "description",
    "source",
    "template_sha256",
    "tool_version",
)


class ManifestError(ForeseenError):
    """A compiled material is not usable; the message has one line for each fault."""


@dataclass(frozen=True)
class Socket:
    """An input that the artist sees. `name` is what files and `--set` know it by."""

    name: str
    label: str
    type: str
    unit: str
    default: Any
    minimum: float | None
    maximum: float | None
    description: str


@dataclass(frozen=True)
class Table:
    name: str
    file: str
    width: int
    height: int
    content: str = ""  # smooth, rough, further or powers; empty where an older tool wrote none


@dataclass(frozen=True)
class CompiledMaterial:
    id: str
    name: str
    kind: str  # a word that it is found by; what it can be asked for is in the traits
    category: str
    description: str
    source: str
    status: str  # measured, sourced or typical
    tags: tuple[str, ...]
    template: str  # the text that it was compiled from; empty where an older tool wrote none
    template_sha256: str
    wavelength_per_path: bool
    negative_gamut: bool
    sockets: tuple[Socket, ...]
    tables: tuple[Table, ...]
    graphs: Mapping[str, Graph | None]
    osl: str
    bytecode: str | None
    digest: str  # of manifest and shader: what makes two node groups the same
    traits: Traits
    to_xyz_d65: Matrix = REC709  # of the space that its colours are in
    notes: tuple[str, ...] = ()  # of media that are held where their data end
    conditions: Conditions = USUAL
    look: Look = PLAIN
    presets: tuple[Preset, ...] = ()
    directory: Path | None = None
    texels: Mapping[str, Any] = field(default_factory=dict)  # float32 (H, W, 3), row 0 on top

    @property
    def forms(self) -> tuple[str, ...]:
        return tuple(form for form in FORMS if self.graphs.get(form) is not None)

    @property
    def thickness(self) -> Socket | None:
        """What says how thick it is, where that can vary."""
        return next(filter(None, map(self.socket, THICKNESSES)), None)

    def socket(self, name: str) -> Socket | None:
        return next((socket for socket in self.sockets if socket.name == name), None)


def load_folder(directory: Path) -> CompiledMaterial:
    """Reads `DIR/<id>.json` and its shader; checks that the tables are there.

    The folder need not be called `<id>`: the one `.json` in it is the manifest.
    """
    manifests = sorted(directory.glob("*.json")) if directory.is_dir() else []
    if len(manifests) != 1:
        raise ManifestError(
            f"{directory}: must be a folder with one manifest (got {len(manifests)})"
        )
    path = manifests[0]
    data = read_manifest(path)
    shader = path.with_suffix(".osl")
    problems = [
        f"{path}: tables[{index}].file: {table.get('file')!r} is missing in {directory}"
        for index, table in enumerate(data["tables"])
        if not (directory / str(table.get("file"))).is_file()
    ]
    if not shader.is_file():
        problems.append(f"{path}: its shader {shader.name} is missing in {directory}")
    if problems:
        raise ManifestError("\n".join(problems))
    compiled = path.with_suffix(".oso")
    bytecode = compiled.read_text("utf-8") if compiled.is_file() else None
    return _material(data, str(path), shader.read_text("utf-8"), bytecode, directory, {})


def from_memory(data: Any, osl: str, texels: Mapping[str, Any]) -> CompiledMaterial:
    """A material that `nacre.compile_template` made in this process."""
    where = f"{data.get('id', 'material')}.json" if isinstance(data, dict) else "manifest"
    _require_header(data, where)
    missing = [table["name"] for table in data["tables"] if table.get("name") not in texels]
    if missing:
        raise ManifestError(f"{where}: tables: no texels for {', '.join(map(str, missing))}")
    return _material(data, where, osl, None, None, texels)


def read_manifest(path: Path) -> dict[str, Any]:
    """Reads the JSON and checks the part that lists of materials need."""
    try:
        data = json.loads(path.read_text("utf-8"))
    except OSError as error:
        raise ManifestError(f"{path}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ManifestError(f"{path}: must be UTF-8 text") from error
    except json.JSONDecodeError as error:
        raise ManifestError(f"{path}:{error.lineno}: not JSON: {error.msg}") from error
    _require_header(data, str(path))
    return data


def _require_header(data: Any, where: str) -> None:
    if not isinstance(data, dict):
        raise ManifestError(f"{where}: must be a JSON object (got {type(data).__name__})")
    if data.get("schema") != SCHEMA:
        raise ManifestError(f"{where}: schema: must be {SCHEMA} (got {data.get('schema')!r})")
    problems = [
        f"{where}: {name}: must be text (got {data.get(name)!r})"
        for name in _TEXT_FIELDS
        if not isinstance(data.get(name), str)
    ]
    problems += [
        f"{where}: {name}: must be a list of objects (got {data.get(name)!r})"
        for name in ("sockets", "tables")
        if not _is_list_of_objects(data.get(name))
    ]
    if not isinstance(data.get("graphs"), dict):
        problems.append(f"{where}: graphs: must be an object (got {data.get('graphs')!r})")
    if problems:
        raise ManifestError("\n".join(problems))


def _is_list_of_objects(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(item, dict) for item in value)


def _material(
    data: dict[str, Any],
    where: str,
    osl: str,
    bytecode: str | None,
    directory: Path | None,
    texels: Mapping[str, Any],
) -> CompiledMaterial:
    problems: list[str] = []
    sockets = _parse_sockets(data["sockets"], f"{where}: sockets", problems)
    tables = _parse_tables(data["tables"], f"{where}: tables", problems)
    graphs = _parse_graphs(data["graphs"], f"{where}: graphs", sockets, tables, problems)
    to_xyz_d65 = _parse_space(data, where, problems)
    notes = _parse_notes(data, where, problems)
    conditions = _parse_conditions(data, where, problems)
    traits = _parse_traits(data, where, graphs, problems)
    numbers = [socket.name for socket in sockets if socket.type in ("float", "int")]
    presets = parse_presets(data.get("presets", []), f"{where}: presets", numbers, problems)
    look = look_of(data)
    if look is None:
        problems.append(
            f"{where}: look: must have an object, a word, and thickness, a list of texts "
            f"(got {data['look']!r})"
        )
    if problems:
        raise ManifestError("\n".join(problems))
    canonical = json.dumps(data, sort_keys=True) + osl
    return CompiledMaterial(
        id=data["id"],
        name=data["name"],
        kind=data["kind"],
        category=data["category"],
        description=data["description"],
        source=data["source"],
        status=str(data.get("status", "typical")),
        tags=tuple(map(str, data.get("tags") or ())),
        template=str(data.get("template", "")),
        template_sha256=data["template_sha256"],
        wavelength_per_path=bool(data.get("wavelength_per_path", False)),
        negative_gamut=bool((data.get("gamut") or {}).get("negative", False)),
        sockets=sockets,
        tables=tables,
        graphs=graphs,
        osl=osl,
        bytecode=bytecode,
        digest=hashlib.sha256(canonical.encode()).hexdigest(),
        traits=traits,
        to_xyz_d65=to_xyz_d65,
        notes=notes,
        conditions=conditions,
        look=look or PLAIN,
        presets=presets,
        directory=directory,
        texels=texels,
    )


def _parse_space(data: dict[str, Any], where: str, problems: list[str]) -> Matrix:
    """Older tools name the space alone."""
    if "to_xyz_d65" not in data:
        name = data.get("space", "lin_rec709_scene")
        if name != "lin_rec709_scene":
            problems.append(f"{where}: to_xyz_d65: missing; must be the matrix from {name} to XYZ")
        return REC709
    try:
        return parse(data["to_xyz_d65"])
    except SpaceError as error:
        problems.append(f"{where}: to_xyz_d65: {error} (got {data['to_xyz_d65']!r})")
        return REC709


def _parse_notes(data: dict[str, Any], where: str, problems: list[str]) -> tuple[str, ...]:
    held = data.get("held_ends", [])
    if _is_list_of_objects(held) and all(isinstance(ends.get("note"), str) for ends in held):
        return tuple(ends["note"] for ends in held)
    problems.append(f"{where}: held_ends: must be a list of objects with a note (got {held!r})")
    return ()


def _parse_traits(
    data: dict[str, Any], where: str, graphs: Mapping[str, Graph | None], problems: list[str]
) -> Traits:
    """Older tools say nothing of them."""
    made = [graph for graph in graphs.values() if graph is not None]
    if "traits" in data:
        outputs = [graph.outputs for graph in made]
        return parse_traits(data["traits"], f"{where}: traits", outputs, problems) or UNSAID
    return assumed(
        str(data.get("template", "")),
        made[0].outputs if made else (),
        any(graph.refracts_light for graph in made),
    )


def _parse_conditions(data: dict[str, Any], where: str, problems: list[str]) -> Conditions:
    """Older tools always adapt by Bradford's matrix and do not say so."""
    default = USUAL._asdict()
    names = [data.get(name, default[name]) for name in Conditions._fields]
    if problem := conditions_problem(*names):
        problems.append(f"{where}: {problem}")
        return USUAL
    return Conditions(*names)


def _parse_sockets(
    data: list[dict[str, Any]], where: str, problems: list[str]
) -> tuple[Socket, ...]:
    sockets: dict[str, Socket] = {}
    for index, item in enumerate(data):
        at = f"{where}[{index}]"
        name, kind = item.get("name"), item.get("type")
        if not isinstance(name, str) or not name.isidentifier() or name in sockets:
            problems.append(f"{at}.name: must be a unique identifier (got {name!r})")
            continue
        if kind not in SOCKET_TYPES:
            problems.append(f"{at}.type: must be one of {', '.join(SOCKET_TYPES)} (got {kind!r})")
            continue
        socket = Socket(
            name=name,
            label=str(item.get("label", name)),
            type=kind,
            unit=str(item.get("unit", "1")),
            default=item.get("default"),
            minimum=item.get("min"),
            maximum=item.get("max"),
            description=str(item.get("description", "")),
        )
        _check_default(socket, at, problems)
        sockets[name] = socket
    return tuple(sockets.values())


def _check_default(socket: Socket, at: str, problems: list[str]) -> None:
    if socket.type in DIRECTIONS:
        return
    if socket.type == "color":
        if not (isinstance(socket.default, list) and len(socket.default) == 3):
            problems.append(f"{at}.default: must be three numbers (got {socket.default!r})")
        return
    numbers = {"default": socket.default, "min": socket.minimum, "max": socket.maximum}
    wrong = {
        k: v for k, v in numbers.items() if isinstance(v, bool) or not isinstance(v, (int, float))
    }
    for key, value in wrong.items():
        problems.append(f"{at}.{key}: must be a number (got {value!r})")
    if not wrong and not socket.minimum <= socket.default <= socket.maximum:
        problems.append(
            f"{at}.default: must be in [{socket.minimum}, {socket.maximum}] (got {socket.default})"
        )


def _parse_tables(data: list[dict[str, Any]], where: str, problems: list[str]) -> tuple[Table, ...]:
    tables = []
    for index, item in enumerate(data):
        at = f"{where}[{index}]"
        name, file = item.get("name"), item.get("file")
        if not isinstance(name, str) or not isinstance(file, str) or Path(file).name != file:
            problems.append(f"{at}: must have a name and a bare file name (got {name!r}, {file!r})")
            continue
        shape = (item.get("width"), item.get("height"))
        if not all(isinstance(size, int) and size > 0 for size in shape):
            problems.append(f"{at}: width and height must be whole numbers above 0 (got {shape})")
            continue
        role = item.get("role")
        content = role.get("content", "") if isinstance(role, dict) else ""
        tables.append(Table(name, file, *shape, content=str(content)))
    return tuple(tables)


def _parse_graphs(
    data: dict[str, Any],
    where: str,
    sockets: tuple[Socket, ...],
    tables: tuple[Table, ...],
    problems: list[str],
) -> dict[str, Graph | None]:
    names = [socket.name for socket in sockets]
    table_names = [table.name for table in tables]
    graphs = {
        form: parse_graph(data[form], f"{where}.{form}", names, table_names, problems)
        for form in (*FORMS, BANDS)
        if data.get(form) is not None
    }
    if not any(form in graphs for form in FORMS):
        problems.append(f"{where}: must have a graph for one of {', '.join(FORMS)}")
    return graphs
