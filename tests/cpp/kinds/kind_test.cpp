// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nacre/core/resources.h"
#include "nacre/kinds/read_template.h"

namespace nacre::kinds {
namespace {

/// What was ever shipped of each kind is what the contract is tested on.
std::vector<MaterialTemplate> one_of_each_kind()
{
    std::vector<MaterialTemplate> result;
    std::set<std::string_view> kinds;
    for (const std::string_view path : list_resources("templates/")) {
        MaterialTemplate source = parse_template(find_resource(path).value(), path);
        if (kinds.insert(source.kind->name()).second) result.push_back(std::move(source));
    }
    return result;
}

CompileOptions quick()
{
    CompileOptions options;
    options.tolerance = 2.0;
    return options;
}

TEST(Kind, EachAnswersForItsMaterials)
{
    const auto sources = one_of_each_kind();
    EXPECT_GE(sources.size(), 3u);
    for (const MaterialTemplate& source : sources) {
        SCOPED_TRACE(source.id);
        const oslgen::Traits traits = source.kind->traits();
        EXPECT_FALSE(traits.stage.empty());
        EXPECT_FALSE(traits.closures.empty());
        EXPECT_NO_THROW(source.kind->check(source, quick()));

        const Prepared made = source.kind->prepare(source, quick());
        std::set<std::string> names;
        for (const oslgen::Socket& socket : made.program.sockets)
            EXPECT_TRUE(names.insert(socket.name).second) << socket.name;
        EXPECT_TRUE(names.contains("normal"));
        const std::string driven = source.kind->driven_socket();
        EXPECT_TRUE(driven.empty() || names.contains(driven)) << driven;
    }
}

TEST(Kind, IsExportedAsAFilmOrSaysWhyNot)
{
    for (const MaterialTemplate& source : one_of_each_kind()) {
        const auto found = source.kind->exported(source);
        if (const auto* reason = std::get_if<std::string>(&found))
            EXPECT_FALSE(reason->empty()) << source.id;
        else
            EXPECT_EQ(std::get<MaterialTemplate>(found).kind->name(), "film") << source.id;
    }
}

}  // namespace
}  // namespace nacre::kinds
