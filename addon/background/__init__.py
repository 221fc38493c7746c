# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The program without a window: `nacre render`, `blender --command nacre`, and what makes the asset library."""
