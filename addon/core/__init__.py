# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the extension knows without Blender: materials, graphs, forms, values. Imports no bpy."""
