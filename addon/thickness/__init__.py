# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a thickness follows over a surface: sources, painting, heat, and their panel."""
