#include "picture_method.hpp"

#include <gonio/base/named.hpp>
#include <gonio/preview/capture.hpp>

#include "../options/method_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace gonio::cli {

std::string_view to_text(const PictureMethod& method) {
    return method.surroundings == SurroundingsMethod::exact ? to_text(method.light) : to_text(method.surroundings);
}

PictureMethod method_of(const RenderOptions& options) {
    return {options.method, options.surroundings};
}

void set_method(RenderOptions& options, const PictureMethod& method) {
    options.method = method.light;
    options.surroundings = method.surroundings;
}

std::vector<PictureMethodInfo> picture_methods() {
    std::vector<PictureMethodInfo> infos;
    for (const IrradianceMethodName& known : irradiance_methods())
        infos.push_back({known.name, std::string(known.summary), {known.method, SurroundingsMethod::exact}});
    for (const SurroundingsMethodInfo& known : surroundings_methods()) {
        const auto same = std::find_if(infos.begin(), infos.end(),
                                       [&](const PictureMethodInfo& info) { return info.name == known.name; });
        if (same == infos.end()) {
            infos.push_back({known.name, std::string(known.summary), {IrradianceMethod::exact, known.method}});
            continue;
        }
        same->method.surroundings = known.method;
        same->summary += fmt::format("; {}", known.summary);
    }
    return infos;
}

Result<PictureMethod> parse_picture_method(std::string_view name) {
    const std::vector<PictureMethodInfo> infos = picture_methods();
    return find_named("method", without_aliases(name), infos).map([](const PictureMethodInfo* info) {
        return info->method;
    });
}

Result<std::vector<PictureMethod>> parse_picture_methods(std::string_view list) {
    const std::vector<PictureMethodInfo> infos = picture_methods();
    auto named = find_all_named("method", without_aliases(list), infos);
    if (!named) return pass_on(named);
    std::vector<PictureMethod> methods;
    for (const auto* const info : *named)
        methods.push_back(info->method);
    return methods;
}

Result<void> check_sky(std::span<const PictureMethod> methods, const Sky& sky) {
    for (const PictureMethod& method : methods)
        if (is_of_open_sky(method.surroundings) && method.light == IrradianceMethod::exact && sky.is_dark())
            return fail("USE0104", fmt::format("the method {} is about the light of a sky", to_text(method)),
                        "add --sky, for example --sky cie:12,sun=180/40,horizontal=20klx");
    return {};
}

Result<void> prepare(RenderOptions& options, std::span<const PictureMethod> methods, const Stage& stage,
                     std::span<const Light> lights, const std::optional<glm::dvec3>& probe_at) {
    const bool needs_probe = std::any_of(methods.begin(), methods.end(), [](const PictureMethod& method) {
        return has_local_probe(method.surroundings);
    });
    if (!needs_probe) return {};
    Result<LocalProbe> probe =
        local_probe(stage, lights, probe_at.value_or(0.5 * (stage.camera.position + stage.camera.target)), options);
    if (!probe) return pass_on(probe);
    options.probe = std::make_shared<const LocalProbe>(std::move(*probe));
    return {};
}

} // namespace gonio::cli
