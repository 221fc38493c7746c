// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "tables/result.h"

#include <string_view>

#include <fmt/format.h>

#include "base/guard.h"

extern "C" {

size_t nacre_result_tables(const nacre_result* result)
{
    return result == nullptr ? 0 : result->tables.size();
}

nacre_status nacre_result_table(const nacre_result* result, size_t index, nacre_table* table)
{
    return nacre::capi::guarded([&] {
        nacre::capi::require(result, "result");
        nacre::capi::require(table, "table");
        if (index >= result->tables.size())
            nacre::capi::fail("index",
                              fmt::format("must be < {} (got {})", result->tables.size(), index));
        const nacre::lut::Table& source = result->tables[index];
        *table = {.name = source.name().c_str(),
                  .quantity = source.quantity.c_str(),
                  .x_name = source.x.name.c_str(),
                  .y_name = source.y.name.c_str(),
                  .x_min = source.x.min,
                  .x_max = source.x.max,
                  .y_min = source.y.min,
                  .y_max = source.y.max,
                  .width = source.x.texels,
                  .height = source.y.texels,
                  .channels = static_cast<int>(source.channels.size()),
                  .error_max = source.error_max,
                  .error_mean = source.error_mean,
                  .texels = source.texels.data()};
    });
}

const char* nacre_result_text(const nacre_result* result, const char* name)
{
    if (result == nullptr || name == nullptr || result->id.empty()) return nullptr;
    const std::string_view wanted(name);
    if (wanted == "id") return result->id.c_str();
    if (wanted == "osl") return result->osl.c_str();
    if (wanted == "manifest") return result->manifest.c_str();
    return nullptr;
}

void nacre_result_free(nacre_result* result)
{
    delete result;
}
}
