# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators. They report what is wrong and cancel; they never raise into the console."""
