// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/pipeline/compile.h"
#include "base/guard.h"
#include "nacre/capi/templates.h"
#include "nacre/kinds/read_template.h"
#include "tables/result.h"
#include "templates/compile_options.h"

extern "C" {

nacre_status nacre_compile_template(const char* text, const char* file, const char* illuminant,
                                    const char* observer, const char* space, const char* adaptation,
                                    double tolerance, nacre_result** result)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(result, "result");
        kinds::CompileOptions options =
            capi::compile_options(text, file, {illuminant, observer, space, adaptation});
        options.tolerance = tolerance;
        auto compiled = pipeline::compile(kinds::parse_template(text, file), options);
        *result = new nacre_result{std::move(compiled.id), std::move(compiled.osl),
                                   std::move(compiled.manifest), std::move(compiled.tables)};
    });
}
}
