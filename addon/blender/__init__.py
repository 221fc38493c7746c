# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the rest needs of Blender and that knows no materials: node formulas, colour spaces, files, icons."""
