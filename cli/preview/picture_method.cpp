#include "picture_method.hpp"

#include <gonio/base/named.hpp>
#include <gonio/preview/capture.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace gonio::cli {

std::string_view to_text(const PictureMethod& method) {
    return method.surroundings == SurroundingsMethod::exact ? to_text(method.light) : to_text(method.surroundings);
}

Result<PictureMethod> parse_picture_method(std::string_view name) {
    struct Row {
        std::string_view name;
        PictureMethod method;
    };
    std::vector<Row> rows;
    for (const IrradianceMethodName& known : irradiance_methods())
        rows.push_back({known.name, {known.method, SurroundingsMethod::exact}});
    for (const SurroundingsMethodInfo& known : surroundings_methods())
        rows.push_back({known.name, {IrradianceMethod::exact, known.method}});
    return find_named("method", name, rows).map([](const Row* row) { return row->method; });
}

Result<std::vector<PictureMethod>> picture_methods(std::string_view list) {
    std::vector<PictureMethod> methods;
    for (bool more = true; more;) {
        const std::size_t comma = list.find(',');
        Result<PictureMethod> parsed = parse_picture_method(list.substr(0, comma));
        if (!parsed) return pass_on(parsed);
        if (std::find(methods.begin(), methods.end(), *parsed) == methods.end()) methods.push_back(*parsed);
        more = comma != std::string_view::npos;
        if (more) list.remove_prefix(comma + 1);
    }
    return methods;
}

Result<void> prepare(RenderOptions& options, std::span<const PictureMethod> methods, const Stage& stage,
                     std::span<const Light> lights, const std::optional<glm::dvec3>& probe_at) {
    bool needs_probe = false;
    for (const PictureMethod& method : methods) {
        needs_probe = needs_probe || has_local_probe(method.surroundings);
        if (is_of_open_sky(method.surroundings) && options.sky.is_dark())
            return fail("USE0104", fmt::format("the method {} is about the light of a sky", to_text(method)),
                        "add --sky, for example --sky cie:12,sun=180/40,horizontal=20klx");
    }
    if (!needs_probe) {
        if (probe_at)
            return fail("USE0107", "--probe-at is for the methods parallax-box and parallax-sphere",
                        "add one of them to --method or --compare, or leave --probe-at out");
        return {};
    }
    Result<LocalProbe> probe =
        local_probe(stage, lights, probe_at.value_or(0.5 * (stage.camera.position + stage.camera.target)), options);
    if (!probe) return pass_on(probe);
    options.probe = std::make_shared<const LocalProbe>(std::move(*probe));
    return {};
}

} // namespace gonio::cli
