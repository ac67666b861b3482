#include <gonio/asset/detail/file_record_json.hpp>
#include <gonio/asset/detail/sun_json.hpp>
#include <gonio/asset/environment_sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/version.hpp>

#include <vector>

namespace gonio {

namespace {

using detail::Json;

} // namespace

std::string environment_sidecar(const EnvironmentDescription& environment) {
    const EnvironmentLayoutInfo& layout = info_of(environment.grid.layout());
    const SkyMeasures& of = environment.measures;
    Json sidecar{
        {"schema", "gonio.environment/1"},
        {"layout", layout.name},
        {"width", environment.grid.width()},
        {"height", environment.grid.height()},
        {"channels", 3},
        {"pixel", environment.pixel},
        {"space", "rec709"},
        {"texel_convention", layout.texel_convention},
        {"frame", {{"up", "+Z"}, {"north", "+Y"}, {"east", "+X"}}},
        {"nits_per_unit", environment.nits_per_unit},
        {"horizontal_lx", of.horizontal.value},
        {"vertical_lx",
         {{"north", of.vertical[0].value},
          {"east", of.vertical[1].value},
          {"south", of.vertical[2].value},
          {"west", of.vertical[3].value}}},
        {"mean_nt", of.mean.value},
        {"zenith_nt", of.zenith.value},
        {"peak_nt", of.spot ? of.spot->luminance.value : of.zenith.value},
        {"sun", detail::to_json(environment.sun)},
        {"source", {{"sky", environment.source}}},
        {"tool", std::string("gonio ") + version},
    };
    if (!environment.source_sha256.empty()) sidecar["source"]["sha256"] = environment.source_sha256;
    if (environment.file) sidecar["files"] = detail::to_json(std::vector{*environment.file});
    // A file name need not be UTF-8: invalid bytes become a replacement character instead of a failure.
    return sidecar.dump(2) + "\n";
}

} // namespace gonio
