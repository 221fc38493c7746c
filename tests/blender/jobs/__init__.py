# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What the server does inside Blender: each function takes and returns what JSON can hold."""
