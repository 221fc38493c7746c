// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "files/json_input.h"

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
}

/// @file
/// The records of `nacre eval`: one JSON object in, one out.

namespace nacre::tool {

struct Session;

/// Answers one record. @throws InputError with every problem of the record.
using RecordEvaluator = std::function<ordered_json(const json& record)>;

struct RecordFiles {
    std::string input = "-", output;
};

/// A kind of record: FILE and -o.
CLI::App* add_record_command(CLI::App& eval, const char* name, const char* description,
                             const char* help, const std::shared_ptr<RecordFiles>& files);

/// The same for records that need no more than that: their answers are what the command does.
void add_record_command(CLI::App& eval, Session& session, const char* name, const char* description,
                        const char* help, ordered_json (*evaluate)(const json& record));

/// Answers the record or the array of records of a file.
/// @param finish  acts on all answers together before they are written; may be empty
/// @return the exit code: that of wrong input where one record is wrong
[[nodiscard]] int evaluate_file(const Session& session, const RecordFiles& files,
                                const RecordEvaluator& evaluate,
                                const std::function<void(std::vector<ordered_json>&)>& finish = {});

}  // namespace nacre::tool
