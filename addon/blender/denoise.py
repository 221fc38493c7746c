# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenImageDenoise for pictures that no render made: by Cycles' denoising of files, which needs neither
window nor compositor and is the same in every version."""

from __future__ import annotations

import tempfile
from pathlib import Path

import bpy
import numpy as np

from ..core import exr
from ..core.exr_write import ExrWriter

NOT_POSSIBLE = "not denoised: this Blender was built without OpenImageDenoise"


def is_possible() -> bool:
    """Some distributions' Blender has none, and its denoising of files then writes what memory holds."""
    import _cycles

    return bool(_cycles.with_openimagedenoise)


def denoised(
    scene: bpy.types.Scene,
    layer: bpy.types.ViewLayer,
    samples: int,
    rgb: np.ndarray,
    alpha: np.ndarray,
    albedo: np.ndarray,
    normal: np.ndarray,
) -> np.ndarray:
    """(height, width, 3), as the scene's settings have it; only where that `is_possible`. Raises RuntimeError
    where Blender refuses."""
    height, width = rgb.shape[:2]
    combined = np.concatenate([rgb, alpha[..., None]], axis=-1)
    parts = {
        "Combined": ("RGBA", combined),
        "Noisy Image": ("RGBA", combined),
        "Denoising Albedo": ("RGB", albedo),
        "Denoising Normal": ("XYZ", normal),
        "Denoising Depth": ("Z", np.zeros((height, width, 1))),
        # Asked for, though a still has no use for it.
        "Vector": ("XYZW", np.zeros((height, width, 4))),
    }
    names = [f"{layer.name}.{part}.{c}" for part, (letters, _) in parts.items() for c in letters]
    values = np.concatenate([array for _, array in parts.values()], axis=-1, dtype=np.float32)
    with tempfile.TemporaryDirectory() as folder:
        noisy, clean = Path(folder) / "noisy.exr", Path(folder) / "clean.exr"
        attributes = {f"cycles.{layer.name}.samples": str(samples)}
        with ExrWriter(noisy, width, height, names, attributes) as writer:
            writer.append(values)
        with bpy.context.temp_override(scene=scene, view_layer=layer):
            bpy.ops.cycles.denoise_animation(input_filepath=str(noisy), output_filepath=str(clean))
        found = exr.read_channels(clean)
    channels = [np.frombuffer(found[f"Combined.{c}"], np.float32) for c in "RGB"]
    return np.stack(channels, axis=-1).reshape(height, width, 3)
