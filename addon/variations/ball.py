# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A ball in a studio, drawn from a material's own tables without a renderer: what a look is known
by in lists. Arrays are float32, bottom row first as Blender wants them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ..core.plot import encode

RADIUS, CENTRE_Y = 0.84, 0.045
_WHITE = 4.0  # radiance that is shown as white
_GAIN_BELOW, _BRIGHT = 0.12, 0.34  # clear films reflect little; an eye grows used to that

_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


@dataclass(frozen=True)
class Box:
    """A soft box: where it is seen, half of its width and height as tangents, its radiance."""

    at: tuple[float, float, float]
    half: tuple[float, float]
    radiance: float


_BOXES = (
    Box((-0.62, 0.62, 0.62), (0.52, 0.62), 3.0),
    Box((0.93, 0.1, 0.25), (0.16, 0.95), 2.1),
    Box((0.1, 0.75, -0.62), (1.1, 0.22), 1.5),
)


@dataclass(frozen=True)
class Tables:
    """Over thickness (rows) and cosθ from 0 to 1 (columns), linear Rec.709. `bare` is what is
    seen where the layers do not cover, `transmittance` of what one looks through or into."""

    reflectance: np.ndarray
    bare: np.ndarray | None = None
    transmittance: np.ndarray | None = None


@dataclass(frozen=True)
class Finish:
    roughness: float = 0.0
    anisotropy: float = 0.0
    coverage: float = 1.0
    base: tuple[float, float, float] | None = None  # a matt one below the layers


@lru_cache(maxsize=4)
def sphere(size: int) -> tuple[np.ndarray, np.ndarray]:
    """Normals (size, size, 3), x to the right, y up, z to the viewer, and how much of a pixel is ball."""
    line = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    x, y = np.meshgrid(line / RADIUS, (line - CENTRE_Y) / RADIUS)
    squared = x * x + y * y
    inside = np.clip((1.0 - np.sqrt(squared)) * RADIUS * size / 2.0 + 0.5, 0.0, 1.0)
    shrink = np.maximum(np.sqrt(squared), 1.0)
    x, y = x / shrink, y / shrink
    z = np.sqrt(np.maximum(1.0 - x * x - y * y, 1e-4))
    return np.stack([x, y, z], axis=-1).astype(np.float32), inside.astype(np.float32)


def draw(tables: Tables, row: np.ndarray | float, finish: Finish, size: int) -> np.ndarray:
    """`row`: where in the tables the thickness is, from 0 to 1, of all or of each pixel."""
    normal, inside = sphere(size)
    cosine = normal[..., 2]
    seen = _looked_up(tables.reflectance, row, cosine, finish)
    if tables.bare is not None and finish.coverage < 1.0:
        bare = _looked_up(tables.bare, row, cosine, finish)
        seen = bare + (seen - bare) * finish.coverage
    seen = _brightened(np.maximum(seen, 0.0), tables.reflectance)
    colour = seen * _studio(_mirrored(normal), finish)[..., None]
    backdrop = _backdrop(size, tables.transmittance is not None and finish.base is None)
    if tables.transmittance is not None or finish.base is not None:
        through = _through(tables, row, cosine, finish)
        colour = colour + _behind(normal, seen, through, backdrop, finish)
    shown = encode(_toned(colour))
    behind = encode(backdrop)
    picture = np.ones((size, size, 4), dtype=np.float32)
    picture[..., :3] = behind + (shown - behind) * inside[..., None]
    return picture


def _looked_up(table: np.ndarray, row, cosine: np.ndarray, finish: Finish) -> np.ndarray:
    """Bilinear. Facets of a rough surface lean towards the viewer at grazing angles."""
    rows, columns = table.shape[:2]
    leaned = cosine + (1.0 - cosine) * 0.6 * finish.roughness**2
    across = leaned * (columns - 1)
    left = np.minimum(across.astype(np.int32), columns - 2)
    u = (across - left)[..., None].astype(np.float32)
    down = np.broadcast_to(np.clip(row, 0.0, 1.0) * (rows - 1), cosine.shape)
    top = np.clip(down.astype(np.int32), 0, max(rows - 2, 0))
    below = np.minimum(top + 1, rows - 1)
    v = (down - top)[..., None].astype(np.float32)
    flat = table.reshape(-1, 3)
    upper = _mixed(flat[top * columns + left], flat[top * columns + left + 1], u)
    lower = _mixed(flat[below * columns + left], flat[below * columns + left + 1], u)
    return _mixed(upper, lower, v)


def _mixed(a: np.ndarray, b: np.ndarray, share: np.ndarray) -> np.ndarray:
    return a + (b - a) * share


def _brightened(seen: np.ndarray, reflectance: np.ndarray) -> np.ndarray:
    """A mirror stays a mirror, as everything is at grazing angles."""
    brightest = float((reflectance[:, -1] @ _LUMINANCE).max())
    if not 1e-4 < brightest < _GAIN_BELOW:
        return seen
    gain = _BRIGHT / brightest
    return seen * gain / (1.0 + (gain - 1.0) * (seen @ _LUMINANCE)[..., None])


def _mirrored(normal: np.ndarray) -> np.ndarray:
    """The direction that the viewer sees in it."""
    mirrored = 2.0 * normal[..., 2:] * normal
    mirrored[..., 2] -= 1.0
    return mirrored


def _studio(direction: np.ndarray, finish: Finish) -> np.ndarray:
    """Radiance from a direction, blurred by the roughness: a bright tent, dark below, and soft boxes."""
    blur = 0.03 + 2.2 * finish.roughness**1.5
    sky = smooth_step(direction[..., 1], -0.45 - blur, 0.55 + blur)
    radiance = 0.2 + 0.6 * sky
    for box in _BOXES:
        radiance = radiance + box.radiance * _box(direction, box, blur, finish.anisotropy)
    return radiance


def _box(direction: np.ndarray, box: Box, blur: float, anisotropy: float) -> np.ndarray:
    ahead = np.array(box.at, dtype=np.float32)
    ahead /= np.linalg.norm(ahead)
    side = np.cross((0.0, 1.0, 0.0), ahead).astype(np.float32)
    side /= np.linalg.norm(side)
    up = np.cross(ahead, side)
    depth = np.maximum(direction @ ahead, 1e-3)
    mask = np.float32(1.0)
    # Brushed across: the highlight is drawn out along it.
    aspect = math.sqrt(1.0 - 0.9 * abs(anisotropy))
    for axis, half, own in (
        (side, box.half[0], blur * aspect),
        (up, box.half[1], blur / aspect),
    ):
        away = np.abs(direction @ axis) / depth
        # As much light as an edge without blur lets by.
        mask = (
            mask * (1.0 - smooth_step(away, half - own, half + own)) * half / math.hypot(half, own)
        )
    return mask * smooth_step(direction @ ahead, 0.0, 0.25)


def _through(tables: Tables, row, cosine: np.ndarray, finish: Finish) -> np.ndarray:
    if tables.transmittance is None:
        return np.ones((*cosine.shape, 3), dtype=np.float32)
    return np.clip(_looked_up(tables.transmittance, row, cosine, finish), 0.0, 1.0)


def _behind(normal, seen, through, backdrop, finish: Finish) -> np.ndarray:
    """A matt base as it is lit; of what is clear, the backdrop and the ball's far side."""
    if finish.base is not None:
        lit = np.clip(normal @ np.array([-0.45, 0.62, 0.64], dtype=np.float32), 0.0, 1.0)
        below = np.maximum(1.0 - seen.mean(axis=-1, keepdims=True), 0.0)
        return np.array(finish.base) * through * below * (0.12 + 0.95 * lit)[..., None]
    far = normal * np.array([-1.0, -1.0, 1.0], dtype=np.float32)
    mirrored = _studio(_mirrored(far), finish)[..., None]
    return through * (backdrop + 0.55 * seen * through * mirrored)


@lru_cache(maxsize=8)
def _backdrop(size: int, is_dark: bool) -> np.ndarray:
    """Neutral grey, lighter in the middle, with the ball's shadow."""
    line = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    x, y = np.meshgrid(line, line)
    grey = 0.13 - 0.06 * np.clip((x * x + (y - 0.1) ** 2) / 1.6, 0.0, 1.0)
    shadow = np.exp(-((x / 0.55) ** 2) - ((y + 0.86) / 0.12) ** 2)
    grey = grey * (1.0 - 0.75 * shadow) * (0.4 if is_dark else 1.0)
    return np.repeat(grey[..., None], 3, axis=-1).astype(np.float32)


def _toned(colour: np.ndarray) -> np.ndarray:
    """Bright parts are held back by their luminance, so that hues stay (Reinhard 2002, eq. 4)."""
    luminance = np.maximum(colour @ _LUMINANCE, 1e-6)[..., None]
    held = luminance * (1.0 + luminance / _WHITE**2) / (1.0 + 0.55 * luminance)
    toned = colour * held / luminance
    beyond = np.maximum(toned.max(axis=-1, keepdims=True) - 1.0, 0.0)
    return toned + beyond * 0.35


def smooth_step(value: np.ndarray, low: float, high: float) -> np.ndarray:
    part = np.clip((value - low) / (high - low), 0.0, 1.0)
    return part * part * (3.0 - 2.0 * part)
