# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials that are stacks of layers: the stack editor, and the colours that a film takes."""
