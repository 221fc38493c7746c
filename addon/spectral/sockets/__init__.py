# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sockets of shaders that take colours, and the nodes in front of them that make spectra."""
