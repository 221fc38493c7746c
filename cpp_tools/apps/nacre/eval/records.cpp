// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "eval/records.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>
#include <CLI/CLI.hpp>

#include "files/output.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

std::string joined(const InputError& error)
{
    std::vector<std::string> texts;
    for (const Diagnostic& diagnostic : error.diagnostics()) texts.push_back(diagnostic.text());
    return fmt::format("{}", fmt::join(texts, "; "));
}

/// Answers of a batch, and which of them are errors.
struct Answers {
    std::vector<ordered_json> records;
    std::vector<std::unique_ptr<InputError>> errors;
};

Answers answer_all(const json& batch, const RecordEvaluator& evaluate)
{
    Answers answers;
    answers.records.resize(batch.size());
    answers.errors.resize(batch.size());
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
        try {
            answers.records[i] = evaluate(batch[i]);
        } catch (const InputError& error) {
            answers.records[i] = {{"error", joined(error)}};
            answers.errors[i] = std::make_unique<InputError>(error);
        }
    });
    return answers;
}

std::string batch_text(const std::vector<ordered_json>& records)
{
    std::string text = "[";
    for (std::size_t i = 0; i < records.size(); ++i)
        text += (i == 0 ? "\n" : ",\n") + records[i].dump();
    return text + "\n]\n";
}

/// Each note once, however many records have it.
void note_held(const Session& session, const std::vector<ordered_json>& records)
{
    std::set<std::string> said;
    for (const ordered_json& record : records)
        for (const ordered_json& ends : record.value("held_ends", ordered_json::array()))
            if (const auto note = ends["note"].get<std::string>(); said.insert(note).second)
                session.note(note);
}

void report(const Session& session, const std::string& file, const JsonDocument& document,
            const Answers& answers)
{
    for (std::size_t i = 0; i < answers.errors.size(); ++i) {
        if (!answers.errors[i]) continue;
        const bool is_batch = document.value.is_array();
        for (Diagnostic diagnostic : answers.errors[i]->diagnostics()) {
            diagnostic.file = file;
            if (is_batch) {
                diagnostic.line = document.record_lines[i];
                diagnostic.field = diagnostic.field.empty()
                                       ? fmt::format("[{}]", i)
                                       : fmt::format("[{}].{}", i, diagnostic.field);
            }
            session.error(diagnostic.text());
        }
    }
}

}  // namespace

int evaluate_file(const Session& session, const RecordFiles& files, const RecordEvaluator& evaluate,
                  const std::function<void(std::vector<ordered_json>&)>& finish)
{
    const JsonDocument document = parse_json(read_input(files.input), files.input);
    const bool is_batch = document.value.is_array();
    if (!is_batch && !document.value.is_object())
        throw InputError({files.input, 0, "",
                          fmt::format("must be one record {{…}} or an array of records (got {})",
                                      quoted(document.value))});
    Answers answers =
        answer_all(is_batch ? document.value : json::array({document.value}), evaluate);
    if (finish) finish(answers.records);
    write_text_output(files.output, is_batch ? batch_text(answers.records)
                                             : answers.records.front().dump() + "\n");
    note_held(session, answers.records);
    report(session, files.input, document, answers);
    const auto failed = [](const auto& error) { return error != nullptr; };
    return std::any_of(answers.errors.begin(), answers.errors.end(), failed) ? kExitInputError
                                                                             : kExitOk;
}

CLI::App* add_record_command(CLI::App& eval, const char* name, const char* description,
                             const char* help, const std::shared_ptr<RecordFiles>& files)
{
    CLI::App* kind = eval.add_subcommand(name, description)->fallthrough()->footer(help);
    kind->add_option("FILE", files->input,
                     "JSON record or array of records; - is the standard input")
        ->capture_default_str();
    kind->add_option("-o,--output", files->output, "where to write (default: standard output)");
    return kind;
}

void add_record_command(CLI::App& eval, Session& session, const char* name, const char* description,
                        const char* help, ordered_json (*evaluate)(const json& record))
{
    const auto files = std::make_shared<RecordFiles>();
    add_record_command(eval, name, description, help, files)->callback([&session, files, evaluate] {
        session.run = [&session, files, evaluate] {
            return evaluate_file(session, *files, evaluate);
        };
    });
}

}  // namespace nacre::tool
