# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The package of the checkout, without anybody's own library."""

from __future__ import annotations

import os

os.environ["XDG_DATA_HOME"] = os.devnull
