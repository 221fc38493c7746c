// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "files/json_input.h"
#include "fuzz_target.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return fuzz::run(data, size, [](std::string_view text) {
        const tool::JsonDocument document = tool::parse_json(text, "input.json");
        if (!document.value.is_array()) return;
        fuzz::require(document.record_lines.size() == document.value.size(),
                      "another count of lines than of records");
        DiagnosticList problems;
        for (const tool::json& record : document.value) {
            tool::ObjectReader reader(record, "", problems);
            (void)reader.numbers("n", tool::kPositive);
            (void)reader.text("pol");
            reader.refuse_unknown_keys();
            break;  // one record: each has problems of its own
        }
    });
}
