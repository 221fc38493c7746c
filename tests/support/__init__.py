# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What several suites share: where things are, the tool, pictures, colours, truth."""
