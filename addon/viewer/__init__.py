# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a material is at a point: the probe, fields as views and passes, pictures of the viewport."""
