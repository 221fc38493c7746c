# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stages: what `render --stage NAME` puts a material on."""

from __future__ import annotations

from .stage import STAGES, Stage, StageError, build_stage

__all__ = ["STAGES", "Stage", "StageError", "build_stage"]
