# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stages: what `render --stage NAME` puts a material on."""

from __future__ import annotations

from .stage import Stage, StageError, build_stage, stage_names

__all__ = ["Stage", "StageError", "build_stage", "stage_names"]
