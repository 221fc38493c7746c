# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender data made from compiled materials: images, script nodes, node groups, materials."""
