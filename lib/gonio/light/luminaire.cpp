#include <gonio/base/codes/result.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/web/integrate.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio {

namespace {

constexpr double largest_usual_m = 10.0;

Frame placed(const Frame& local, const Frame& luminaire) {
    return {luminaire.origin + luminaire.to_world(local.origin), luminaire.to_world(local.x),
            luminaire.to_world(local.y), luminaire.to_world(local.z)};
}

double intensity_over_luminance(const LuminousFace& face) {
    return face.is_flat ? face.area_m2 : 0.25 * face.area_m2;
}

} // namespace

OpeningBody opening_body(const Opening& opening, const Web& web) {
    std::optional<LuminousBody> body = LuminousBody::of(opening, web);
    if (!body) return {};
    const double behind = body->flux_behind().value / flux(web).value;
    return {std::make_shared<const LuminousBody>(std::move(*body)), behind};
}

void give_body(Light& light, Diagnostics& diagnostics, const OpeningBodies& known) {
    const auto* const profile = std::get_if<ProfileShape>(&light.shape);
    const Opening* const opening = profile != nullptr ? profile->opening() : nullptr;
    if (opening == nullptr) return;
    const auto say = [&](CodeOf<result_codes> code, std::string message, std::string hint) {
        diagnostics.push_back(result_diagnostic(code, std::move(message), std::move(hint)));
        diagnostics.back().location.file = profile->file;
    };
    const bool is_asked_for = profile->size == ProfileSize::opening;
    if (opening->shape == OpeningShape::point) {
        if (!is_asked_for) return;
        say("RES0404", "the file declares no luminous opening: the light is a point",
            "name one: ies:FILE,opening=rect:w=1.2m,h=0.3m");
        return;
    }
    if (opening->largest_m() > largest_usual_m)
        say("RES0405", fmt::format("the luminous opening is very large: {}", to_text(*opening)),
            "name another one: ies:FILE,opening=rect:w=1.2m,h=0.3m");
    const auto found = known.find({profile->web.get(), opening});
    const OpeningBody of_light = found != known.end() ? found->second : opening_body(*opening, *profile->web);
    const std::shared_ptr<const LuminousBody>& body = of_light.body;
    if (body == nullptr) return;
    constexpr double noticeable = 0.01;
    if (of_light.behind > noticeable && is_asked_for)
        say("RES0406",
            fmt::format("{:.3g} lm, {:.3g} % of the light, leave through the back of a flat opening: it emits to both "
                        "sides",
                        light.web_scale * body->flux_behind().value, 100.0 * of_light.behind),
            "if the luminaire shines from its sides, name its body: ies:FILE,opening=box:w=1.2m,h=0.3m,d=0.1m");
    light.body = body;
}

std::vector<Light> faces_of(const Light& light) {
    const auto& web = std::get<ProfileShape>(light.shape).web;
    const double mean_nt = light.body->mean_luminance().value;
    std::vector<Light> faces;
    for (const LuminousFace& part : light.body->faces()) {
        Light face;
        face.name = light.name;
        face.shape = part.shape;
        face.frame = placed(part.frame, light.frame);
        face.color = light.color;
        face.luminance = Nits(light.web_scale * mean_nt);
        face.intensity = Candelas(face.luminance.value * intensity_over_luminance(part));
        face.web_scale = 1.0 / mean_nt;
        face.range = light.range;
        face.emission = std::make_shared<const FaceEmission>(FaceEmission{light.body, web, light.frame, faces.size()});
        faces.push_back(std::move(face));
    }
    return faces;
}

} // namespace gonio
