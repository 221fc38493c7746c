# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""One Blender a version for all suites; `server` and `jobs` run inside it."""
