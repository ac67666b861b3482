// What the page never asks for, so that it holds no code for it: this stands in its link before the tool and the
// library. A call that comes here nevertheless is refused.
#include <gonio/plot/falloff_diagram.hpp>
#include <gonio/preview/capture.hpp>

#include "../bake/table_job.hpp"
#include "../preview/compare.hpp"
#include "../preview/layers.hpp"
#include "../preview/profile_sheet.hpp"
#include "../preview/refine.hpp"
#include "../preview/sweep.hpp"

#include <string>

namespace gonio {

namespace {

Unexpected left_out(const std::string& what) {
    return fail("UNS0101", "this page does not make " + what, "the command-line tool does");
}

} // namespace

Result<EnvironmentMap> capture(const Stage& /*stage*/, std::span<const Light> /*lights*/,
                               const glm::dvec3& /*position*/, int /*side*/, const RenderOptions& /*options*/) {
    return left_out("pictures of surroundings");
}

Result<LocalProbe> local_probe(const Stage& /*stage*/, std::span<const Light> /*lights*/,
                               const glm::dvec3& /*position*/, const RenderOptions& /*options*/) {
    return left_out("pictures of surroundings");
}

Result<Drawing> falloff_diagram(std::span<const PlottedLight> /*lights*/, const FalloffOptions& /*options*/) {
    return left_out("diagrams of falloff");
}

namespace cli {

Result<int> bake_table(const Command& /*command*/, const Arguments& /*arguments*/, Console& /*console*/) {
    return left_out("tables for shaders");
}

Result<int> preview_compare(const Arguments& /*arguments*/, Console& /*console*/) {
    return left_out("comparisons of methods");
}

Result<int> preview_layers(const Arguments& /*arguments*/, Console& /*console*/) {
    return left_out("layers");
}

Result<int> preview_sheet(const Arguments& /*arguments*/, Console& /*console*/) {
    return left_out("sheets of profiles");
}

Result<int> preview_sweep(const Arguments& /*arguments*/, Console& /*console*/) {
    return left_out("sweeps");
}

Result<ReferenceBudget> reference_budget(const Arguments& arguments, bool by_reference) {
    if (by_reference || arguments.has("--error") || arguments.has("--time")) return left_out("references");
    return ReferenceBudget();
}

Result<RefinedPicture> refine(const PreviewRequest& /*request*/, std::span<const Light> /*lights*/,
                              const Console& /*console*/) {
    return left_out("references");
}

} // namespace cli

} // namespace gonio
