# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What every wave material has: its node group and tables, the form that it takes, what is wrong with it, and
its panel."""
