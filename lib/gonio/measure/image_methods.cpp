#include <gonio/light/light_image.hpp>
#include <gonio/measure/image_methods.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/image_pattern.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>

namespace gonio::measure {

namespace {

// Made once for each set of cases, as a scene does.
const detail::ImagePattern& pattern_of(const OpeningCases& cases) {
    thread_local std::shared_ptr<const Light> known;
    thread_local std::unique_ptr<const detail::ImagePattern> pattern;
    if (known != cases.luminaire) {
        const Light& light = cases.face();
        pattern = std::make_unique<const detail::ImagePattern>(std::get<RectShape>(light.shape), *light.image);
        known = cases.luminaire;
    }
    return *pattern;
}

void closed_form(const OpeningCases& cases, simd::InstructionSet set, std::span<float> over_luminance) {
    shading::kernels(set).irradiance(cases.surfaces(), light_constants(cases.face()), over_luminance.data());
}

void by_nodes(const OpeningCases& cases, simd::InstructionSet set, std::span<float> lx) {
    closed_form(cases, set, lx);
    thread_local std::vector<float> share;
    share.resize(lx.size());
    pattern_of(cases).evaluate(cases.face(), cases.receivers(), glm::dvec3(0.0), transport::luminance_kernels(set),
                               share.data());
    const auto nt = static_cast<float>(cases.face().luminance.value);
    for (std::size_t i = 0; i < lx.size(); ++i)
        lx[i] *= nt * share[i];
}

void by_mean(const OpeningCases& cases, simd::InstructionSet set, std::span<float> lx) {
    closed_form(cases, set, lx);
    const Light& light = cases.face();
    const auto nt = static_cast<float>(light.luminance.value * light.image->mean());
    for (float& value : lx)
        value *= nt;
}

void by_samples(const OpeningCases& cases, simd::InstructionSet /*scalar*/, std::span<float> lx) {
    const Light& light = cases.face();
    const auto& rect = std::get<RectShape>(light.shape);
    const glm::vec3 origin(light.frame.origin);
    const glm::vec3 along_x(light.frame.x);
    const glm::vec3 along_y(light.frame.y);
    const glm::vec3 axis(-light.frame.z);
    constexpr int sample_count = 8;
    const auto scale =
        static_cast<float>(light.luminance.value * rect.width.value * rect.height.value / double{sample_count});
    Random random(0x5A);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const glm::vec3 position(cases.position[0][i], cases.position[1][i], cases.position[2][i]);
        const glm::vec3 normal(cases.normal[0][i], cases.normal[1][i], cases.normal[2][i]);
        float sum = 0.0F;
        for (int sample = 0; sample < sample_count; ++sample) {
            const double x = rect.width.value * random.uniform(-0.5, 0.5);
            const double y = rect.height.value * random.uniform(-0.5, 0.5);
            const glm::vec3 away =
                position - origin - static_cast<float>(x) * along_x - static_cast<float>(y) * along_y;
            const float d2 = glm::dot(away, away);
            const float cosines = std::max(-glm::dot(normal, away), 0.0F) * std::max(glm::dot(axis, away), 0.0F);
            sum += cosines / (d2 * d2) * static_cast<float>(light.image->pixel(place_on(rect, x, y)));
        }
        lx[i] = scale * sum;
    }
}

} // namespace

std::vector<Method<OpeningCases>> image_methods() {
    std::vector<Method<OpeningCases>> methods;
    using Work = void (*)(const OpeningCases&, simd::InstructionSet, std::span<float>);
    const auto add = [&](const char* name, Work work, simd::InstructionSet set) {
        methods.push_back({name,
                           set == simd::InstructionSet::scalar ? "float" : std::string(simd::to_text(set)),
                           [=](const OpeningCases& cases, std::span<float> lx) { work(cases, set, lx); },
                           {}});
    };
    for (const auto& [name, work] : {std::pair<const char*, Work>{"nodes", by_nodes}, {"mean", by_mean}})
        for (const simd::InstructionSet set : simd::available_sets())
            add(name, work, set);
    add("samples-8", by_samples, simd::InstructionSet::scalar);
    return methods;
}

} // namespace gonio::measure
