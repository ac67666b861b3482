#include <gonio/base/version.hpp>
#include <gonio/simd/dispatch.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../revision.hpp"

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array groups{json_group, common_group};

int run(const Arguments& arguments, Console& console) {
    const char* const set = simd::to_text(simd::best_available());
    if (arguments.has("--json") || arguments.has("--jsonl"))
        console.print(dump({{"schema", "gonio.version/1"},
                            {"version", version},
                            {"commit", commit},
                            {"instruction_set", set},
                            {"diagnostics", Json::array()}},
                           arguments.has("--jsonl") ? -1 : 2));
    else
        console.print(fmt::format("gonio {} ({}, {})\n", version, commit, set));
    return 0;
}

} // namespace

extern const Command version_command;
const Command version_command{
    "version", "print the version, its commit and the instruction set in use", "", "", groups, {}, run};

} // namespace gonio::cli
