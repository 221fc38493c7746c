// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nacre/capi/tables.h"
#include "nacre/lut/table.h"

struct nacre_result {
    std::string id, osl, manifest;
    std::vector<nacre::lut::Table> tables;
};
