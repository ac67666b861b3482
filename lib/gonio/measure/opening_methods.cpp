#include <gonio/light/luminaire.hpp>
#include <gonio/measure/opening_methods.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/luminance_pattern.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>

namespace gonio::measure {

namespace {

// The tables of one luminaire, made before methods are timed.
struct Tables {
    explicit Tables(const OpeningCases& cases)
        : luminance(cases.face(), tables, webs), web(*cases.face().emission->web) {}

    detail::LuminanceTables tables;
    detail::WebTables webs;
    detail::LuminancePattern luminance;
    detail::WebTable web;
};

// The light must outlive this: made once for each set of cases, as a scene does.
const Tables& tables_of(const OpeningCases& cases) {
    thread_local const Light* known = nullptr;
    thread_local std::shared_ptr<const Light> kept;
    thread_local std::unique_ptr<Tables> tables;
    if (known != cases.luminaire.get()) {
        tables = std::make_unique<Tables>(cases);
        kept = cases.luminaire;
        known = kept.get();
    }
    return *tables;
}

void by_columns(const OpeningCases& cases, simd::InstructionSet set, std::span<float> lx) {
    const Tables& tables = tables_of(cases);
    const Light& face = cases.face();
    shading::kernels(set).irradiance(cases.surfaces(), light_constants(face), lx.data());
    thread_local std::vector<float> share;
    tables.luminance.evaluate(cases.receivers(), glm::dvec3(0.0), transport::luminance_kernels(set),
                              transport::intensity_kernels(set), share);
    const auto nt = static_cast<float>(face.luminance.value);
    for (std::size_t i = 0; i < lx.size(); ++i)
        lx[i] *= nt * share[i];
}

// Directions in which the web is looked up, in one batch: points of light towards receivers.
struct LookUps {
    std::array<std::vector<float>, 3> towards;
    std::vector<float> weight;   // of the intensity of the look-up
    std::vector<std::size_t> of; // receiver
    std::vector<float> cd;

    void clear() {
        for (std::vector<float>& axis : towards)
            axis.clear();
        weight.clear();
        of.clear();
    }
    void add(std::size_t receiver, const glm::vec3& direction, float factor) {
        for (int axis = 0; axis < 3; ++axis)
            towards.at(static_cast<std::size_t>(axis)).push_back(direction[axis]);
        weight.push_back(factor);
        of.push_back(receiver);
    }
    // Sums of weight times intensity.
    void sum(const OpeningCases& cases, simd::InstructionSet set, std::span<float> to) {
        cd.assign(weight.size(), 1.0F);
        transport::LightFrame frame;
        const Frame& luminaire = cases.face().emission->luminaire;
        for (int axis = 0; axis < 3; ++axis) {
            frame.x[axis] = static_cast<float>(luminaire.x[axis]);
            frame.y[axis] = static_cast<float>(luminaire.y[axis]);
            frame.z[axis] = static_cast<float>(luminaire.z[axis]);
        }
        const auto scale = static_cast<float>(cases.luminaire->web_scale);
        transport::intensity_kernels(set).web(
            {{towards[0].data(), towards[1].data(), towards[2].data()}, weight.size()}, frame,
            tables_of(cases).web.constants(scale), cd.data());
        std::fill(to.begin(), to.end(), 0.0F);
        for (std::size_t i = 0; i < weight.size(); ++i)
            to[of[i]] += weight[i] * cd[i];
    }
};

LookUps& look_ups() {
    thread_local LookUps some;
    some.clear();
    return some;
}

// The opening in floats, and a receiver seen from it.
struct FloatOpening {
    explicit FloatOpening(const OpeningCases& cases) : cases_(cases) {
        const Light& face = cases.face();
        const auto& rect = std::get<RectShape>(face.shape);
        origin = glm::vec3(face.frame.origin);
        x = glm::vec3(0.5 * rect.width.value * face.frame.x);
        y = glm::vec3(0.5 * rect.height.value * face.frame.y);
        axis = glm::vec3(-face.frame.z);
        area = static_cast<float>(rect.width.value * rect.height.value);
    }
    glm::vec3 position(std::size_t i) const {
        return {cases_.position[0][i], cases_.position[1][i], cases_.position[2][i]};
    }
    glm::vec3 normal(std::size_t i) const { return {cases_.normal[0][i], cases_.normal[1][i], cases_.normal[2][i]}; }

    glm::vec3 origin, x, y, axis;
    float area;

private:
    const OpeningCases& cases_;
};

void by_point(const OpeningCases& cases, simd::InstructionSet set, std::span<float> lx) {
    const FloatOpening opening(cases);
    LookUps& found = look_ups();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const glm::vec3 away = opening.position(i) - opening.origin;
        const float d2 = glm::dot(away, away);
        found.add(i, away, std::max(-glm::dot(opening.normal(i), away), 0.0F) / (d2 * std::sqrt(d2)));
    }
    found.sum(cases, set, lx);
}

constexpr std::size_t sample_count = 8;

void by_samples(const OpeningCases& cases, simd::InstructionSet set, std::span<float> lx) {
    const FloatOpening opening(cases);
    LookUps& found = look_ups();
    Random random(0x5A);
    for (std::size_t i = 0; i < cases.size(); ++i)
        for (std::size_t sample = 0; sample < sample_count; ++sample) {
            const glm::vec3 from = opening.origin + static_cast<float>(random.uniform(-1.0, 1.0)) * opening.x +
                                   static_cast<float>(random.uniform(-1.0, 1.0)) * opening.y;
            const glm::vec3 away = opening.position(i) - from;
            const float d2 = glm::dot(away, away);
            // The cosine at the light cancels that of its projected area.
            found.add(i, away,
                      std::max(-glm::dot(opening.normal(i), away), 0.0F) /
                          (d2 * std::sqrt(d2) * static_cast<float>(sample_count)));
        }
    found.sum(cases, set, lx);
}

// A rectangle and its cut with the horizon has at most five corners.
struct Polygon {
    std::array<glm::vec3, 5> corner{};
    std::size_t count = 0;
};

Polygon above_horizon(const FloatOpening& opening, const glm::vec3& position, const glm::vec3& normal) {
    const glm::vec3 center = opening.origin - position;
    const std::array<glm::vec3, 4> corners{center - opening.x - opening.y, center + opening.x - opening.y,
                                           center + opening.x + opening.y, center - opening.x + opening.y};
    Polygon cut;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3& a = corners.at(i);
        const glm::vec3& b = corners.at((i + 1) % 4);
        const float at_a = glm::dot(a, normal);
        const float at_b = glm::dot(b, normal);
        if (at_a >= 0.0F) cut.corner.at(cut.count++) = a;
        if ((at_a >= 0.0F) != (at_b >= 0.0F) && cut.count < 5)
            cut.corner.at(cut.count++) = a + (at_a / (at_a - at_b)) * (b - a);
    }
    return cut;
}

glm::vec3 nearest_on_edge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& point) {
    const glm::vec3 edge = b - a;
    const float length2 = glm::dot(edge, edge);
    const float t = length2 > 0.0F ? std::clamp(glm::dot(point - a, edge) / length2, 0.0F, 1.0F) : 0.0F;
    return a + t * edge;
}

// The point of the polygon nearest to the receiver, which is the origin.
glm::vec3 nearest_point(const Polygon& polygon, const glm::vec3& axis) {
    const glm::vec3 foot = glm::dot(polygon.corner[0], axis) * axis;
    glm::vec3 nearest = foot;
    float least = -1.0F;
    float sense = 0.0F;
    bool inside = true;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::vec3& a = polygon.corner.at(i);
        const glm::vec3& b = polygon.corner.at((i + 1) % polygon.count);
        const float side = glm::dot(glm::cross(b - a, foot - a), axis);
        if (sense == 0.0F) sense = side;
        if (side * sense < 0.0F) inside = false;
        const glm::vec3 on_edge = nearest_on_edge(a, b, foot);
        const float distance2 = glm::dot(on_edge - foot, on_edge - foot);
        if (least < 0.0F || distance2 < least) {
            least = distance2;
            nearest = on_edge;
        }
    }
    return inside ? foot : nearest;
}

float solid_angle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const float up = std::abs(glm::dot(a, glm::cross(b, c)));
    const float down = 1.0F + glm::dot(a, b) + glm::dot(b, c) + glm::dot(a, c);
    return 2.0F * std::atan2(up, down); // A. van Oosterom and J. Strackee, 1983
}

void by_cubature(const OpeningCases& cases, simd::InstructionSet set, std::span<float> lx) {
    const FloatOpening opening(cases);
    LookUps& found = look_ups();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const glm::vec3 normal = opening.normal(i);
        const Polygon polygon = above_horizon(opening, opening.position(i), normal);
        if (polygon.count < 3) continue;
        struct Corner {
            glm::vec3 direction;
            float cosine;         // at the receiver
            float over_projected; // 1/(A cosθ) at the light
            float weight = 0.0F;  // of its luminance
        };
        const auto corner_at = [&](const glm::vec3& point) {
            const glm::vec3 direction = glm::normalize(point);
            return Corner{direction, std::max(glm::dot(direction, normal), 0.0F),
                          1.0F / (opening.area * std::max(-glm::dot(direction, opening.axis), 1e-4F))};
        };
        std::array<Corner, 6> corners{};
        corners[0] = corner_at(nearest_point(polygon, opening.axis));
        for (std::size_t k = 0; k < polygon.count; ++k)
            corners.at(k + 1) = corner_at(polygon.corner.at(k));
        for (std::size_t k = 0; k < polygon.count; ++k) {
            Corner& a = corners.at(k + 1);
            Corner& b = corners.at((k + 1) % polygon.count + 1);
            const float geometry = solid_angle(corners[0].direction, a.direction, b.direction) *
                                   (corners[0].cosine + a.cosine + b.cosine) / 9.0F;
            if (!(geometry > 0.0F)) continue;
            corners[0].weight += geometry;
            a.weight += geometry;
            b.weight += geometry;
        }
        for (std::size_t k = 0; k <= polygon.count; ++k)
            found.add(i, -corners.at(k).direction, corners.at(k).weight * corners.at(k).over_projected);
    }
    found.sum(cases, set, lx);
}

} // namespace

std::vector<Method<OpeningCases>> opening_methods() {
    std::vector<Method<OpeningCases>> methods;
    const std::span<const simd::InstructionSet> sets = simd::available_sets();
    using Work = void (*)(const OpeningCases&, simd::InstructionSet, std::span<float>);
    const auto add = [&](const char* name, Work work, simd::InstructionSet set) {
        methods.push_back({name,
                           set == simd::InstructionSet::scalar ? "float" : std::string(simd::to_text(set)),
                           [=](const OpeningCases& cases, std::span<float> lx) { work(cases, set, lx); },
                           {}});
    };
    for (const simd::InstructionSet set : sets)
        add("columns", by_columns, set);
    for (const auto& [name, work] :
         {std::pair<const char*, Work>{"point", by_point}, {"samples-8", by_samples}, {"cubature", by_cubature}}) {
        add(name, work, simd::InstructionSet::scalar);
        if (sets.size() > 1) add(name, work, sets.back());
    }
    return methods;
}

} // namespace gonio::measure
