#include <gonio/asset/detail/file_record_json.hpp>
#include <gonio/asset/detail/sun_json.hpp>
#include <gonio/asset/prefilter_sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/version.hpp>

#include <vector>

namespace gonio {

namespace {

using detail::Json;

// Which directions a texel covers, without what environment images hold in it.
std::string directions_of(EnvironmentLayout layout) {
    const std::string_view convention = info_of(layout).texel_convention;
    return std::string(convention.substr(0, convention.rfind("; a texel holds")));
}

Json error_json(const PrefilterError& error) {
    if (error.texels == 0) return {};
    return {{"texels", error.texels},
            {"mean_nt", error.mean_nt},
            {"rms_percent", 100.0 * error.rms},
            {"max_percent", 100.0 * error.greatest}};
}

Json rgb_json(const glm::dvec3& rgb) {
    return Json::array({rgb.x, rgb.y, rgb.z});
}

Json coefficients_json(std::span<const glm::dvec3> coefficients) {
    Json rows = Json::array();
    for (const glm::dvec3& c : coefficients)
        rows.push_back(rgb_json(c + 0.0)); // no -0
    return rows;
}

Json table_json(const PrefilterDescription& of, const SplitSumTable& table) {
    const MultipleScatteringInfo& more = info_of(of.variant->multiple_scattering);
    Json channels = Json::array({"A: the factor of F0", "B: the factor of F90"});
    channels.push_back(table.model() == SplitSumModel::frostbite ? "the albedo of the diffuse part" : "0");
    Json means = Json::array();
    for (int row = 0; row < table.size(); ++row)
        means.push_back(table.mean_albedo((row + 0.5) / table.size()));
    return {{"file", of.table_file.file},
            {"size", table.size()},
            {"model", info_of(table.model()).name},
            {"channels", std::move(channels)},
            {"columns", "n.v = (column + 0.5)/size, from the left"},
            {"rows", "roughness = (row + 0.5)/size, from the top"},
            {"max_lookup_error", of.table_error},
            {"mean_albedo_of_rows", std::move(means)},
            {"multiple_scattering", {{"name", more.name}, {"reflects", more.summary}}}};
}

Json harmonics_json(const IrradianceSh& sh) {
    const glm::dvec3 least = sh.least();
    return {{"basis", "real, orthonormal, no Condon-Shortley phase; index l(l + 1) + m; x east, y north, z up"},
            {"order", sh.order()},
            {"order_2", "the first 9"},
            {"radiance", coefficients_json(sh.radiance())},
            {"irradiance", coefficients_json(sh.irradiance_coefficients())},
            {"irradiance_lx", "sum of irradiance[i] * Y[i](n); band 3 adds nothing"},
            {"least_lx", rgb_json(least)},
            {"is_negative_somewhere", least.x < 0.0 || least.y < 0.0 || least.z < 0.0}};
}

} // namespace

std::string prefilter_sidecar(const PrefilterDescription& of, const SplitSumTable& table) {
    const EnvironmentLayout layout = of.levels.front().grid.layout();
    const RoughnessMappingInfo& mapping = info_of(of.variant->mapping);
    Json levels = Json::array();
    std::vector<FileRecord> files;
    for (std::size_t i = 0; i < of.levels.size(); ++i) {
        const PrefilterImage& level = of.levels[i];
        levels.push_back({{"level", i},
                          {"roughness", level.roughness},
                          {"width", level.grid.width()},
                          {"height", level.grid.height()},
                          {"file", level.file.file},
                          {"error", error_json(level.error)}});
        files.push_back(level.file);
    }
    files.push_back(of.irradiance.file);
    files.push_back(of.table_file);
    Json sidecar{
        {"schema", "gonio.prefilter/1"},
        {"for", of.variant->name},
        {"layout", info_of(layout).name},
        {"channels", 3},
        {"pixel", of.pixel},
        {"space", "rec709"},
        {"texel_convention", directions_of(layout)},
        {"texel_value",
         "the light about the direction of the texel's middle; in a level of roughness 0 the mean over the texel"},
        {"frame", {{"up", "+Z"}, {"north", "+Y"}, {"east", "+X"}}},
        {"nits_per_unit", of.nits_per_unit},
        {"lobe",
         {{"distribution", "ggx"},
          {"alpha", "roughness^2"},
          {"weights", "n.l, divided by their sum"},
          {"directions", "N = V = R"}}},
        {"roughness_to_level", {{"name", mapping.name}, {"formula", mapping.formula}, {"last", of.levels.size() - 1}}},
        {"lookup", of.variant->lookup},
        {"error", "as stored, against quadrature over the texels of the source, relative to the mean of the level"},
        {"levels", std::move(levels)},
        {"irradiance",
         {{"means", "illuminance of a plane that faces the texel, over pi: cd/m2 of a matte white surface"},
          {"width", of.irradiance.grid.width()},
          {"height", of.irradiance.grid.height()},
          {"file", of.irradiance.file.file},
          {"error", error_json(of.irradiance.error)}}},
        {"split_sum", table_json(of, table)},
        {"spherical_harmonics", harmonics_json(of.harmonics)},
        {"sun", detail::to_json(of.sun)},
        {"source",
         {{"sky", of.source},
          {"layout", info_of(of.source_grid.layout()).name},
          {"width", of.source_grid.width()},
          {"height", of.source_grid.height()}}},
        {"tool", std::string("gonio ") + version},
        {"files", detail::to_json(files)},
    };
    if (!of.source_sha256.empty()) sidecar["source"]["sha256"] = of.source_sha256;
    // A file name need not be UTF-8: invalid bytes become a replacement character instead of a failure.
    return sidecar.dump(2) + "\n";
}

} // namespace gonio
