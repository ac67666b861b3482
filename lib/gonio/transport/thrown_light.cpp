#include <gonio/shading/brdf.hpp>
#include <gonio/transport/light_reach.hpp>
#include <gonio/transport/thrown_light.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>

namespace gonio::detail {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float least = 1e-4F; // a cosine
constexpr float wide = 0.15F;  // α

// The lobe [1/sr] with α² + widening2 for α². n·l, n·v > 0.
glm::vec3 value_of(const ThrowingLobe& lobe, const glm::vec3& n, const glm::vec3& l, const glm::vec3& v, float n_dot_l,
                   float n_dot_v, float widening2) {
    if (lobe.anisotropic) {
        shading::AnisotropicGgxLobe<float> grained = *lobe.anisotropic;
        const auto widened = [&](float alpha) { return std::sqrt(alpha * alpha + widening2); };
        grained.alphas = {widened(grained.alphas.x), widened(grained.alphas.y)};
        grained.alpha = grained.alphas.mean();
        const auto terms = grained({n.x, n.y, n.z}, {l.x, l.y, l.z}, {v.x, v.y, v.z}, grained.alpha);
        return lobe.factor * terms.scale * (lobe.f0 + (lobe.f90 - lobe.f0) * terms.grazing);
    }
    const float alpha2 = std::min(lobe.alpha * lobe.alpha + widening2, 1.0F);
    const glm::vec3 h = l + v;
    const float square = std::max(glm::dot(h, h), 1e-12F);
    const float along = glm::dot(n, h);
    const glm::vec3 across = glm::cross(n, h);
    const shading::HalfVector<float> half{
        {h.x, h.y, h.z}, along * along, glm::dot(across, across), square, 0.5F * std::sqrt(square)};
    const float alpha = std::sqrt(alpha2);
    const float value = lobe.is_ggx
                            ? shading::GgxLobe<float>{alpha}.value({0.0F, 0.0F, n_dot_l}, {0.0F, 0.0F, n_dot_v}, half)
                            : shading::CosinePowerLobe<float>{alpha, 2.0F / alpha2 - 2.0F}.value({}, {}, half);
    const float grazing = shading::schlick_weight(half.l_dot_h);
    return lobe.factor * value * (lobe.f0 + (lobe.f90 - lobe.f0) * grazing);
}

// A coat and the lobe below it are not told apart here.
template<class Core>
constexpr bool throws = requires {
    requires Core::lobe != shading::LobeKind::none;
};

template<class Gloss>
constexpr bool is_ggx_v = std::is_same_v<Gloss, shading::Gloss<double, shading::GgxLobe<double>>>;

} // namespace

glm::dvec3 ThrowingLobe::share(double cosine) const {
    return glm::clamp(whole(cosine) - rest(cosine), glm::dvec3(0.0), glm::dvec3(1.0));
}

std::optional<ThrowingLobe> throwing_lobe(const CoreMaterial& material, const DirectionalAlbedo& whole) {
    return std::visit(
        [&]<class Core>(const Core& core) -> std::optional<ThrowingLobe> {
            if constexpr (!throws<Core>) {
                return std::nullopt;
            } else {
                const auto gloss = shading::gloss(core);
                ThrowingLobe lobe;
                lobe.is_ggx = is_ggx_v<std::remove_cvref_t<decltype(gloss)>>;
                lobe.alpha = static_cast<float>(gloss.lobe.alpha);
                lobe.f90 = static_cast<float>(gloss.f90);
                if constexpr (Core::lobe == shading::LobeKind::anisotropic_ggx)
                    lobe.anisotropic = shading::lobe_of<float>(shading::constants_of(gloss.lobe));
                lobe.factor = static_cast<float>(gloss.factor);
                lobe.f0 = glm::vec3(gloss.f0.x, gloss.f0.y, gloss.f0.z);
                if (lobe.f0 == glm::vec3(0.0F) && !(lobe.f90 > 0.0F)) return std::nullopt;
                constexpr auto coarse = DirectionalAlbedo::Fineness::coarse;
                if constexpr (Core::lobe == shading::LobeKind::ggx_and_more) {
                    // Light that facets scatter more than once is not in the lobe.
                    lobe.whole = DirectionalAlbedo(shading::Ggx<double>{gloss.f0, gloss.lobe.alpha}, coarse);
                    lobe.rest = DirectionalAlbedo(shading::Lambert<double>{{0.0, 0.0, 0.0}}, coarse);
                } else {
                    lobe.whole = whole;
                    lobe.rest = DirectionalAlbedo(diffuse_alone(core), coarse);
                }
                return lobe;
            }
        },
        material);
}

ThrownLight::ThrownLight(const Patches& patches, std::span<const Light> lights, std::span<const ThrowingLight> shares,
                         std::span<const std::optional<ThrowingLobe>> lobes) {
    std::vector<std::size_t> lit;
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (!shares[i].lx.empty()) lit.push_back(i);
    if (lit.empty() || std::none_of(lobes.begin(), lobes.end(), [](const auto& lobe) { return lobe.has_value(); }))
        return;
    lobes_.assign(lobes.begin(), lobes.end());
    lights_ = lit.size();
    std::vector<LightReach> reaches;
    for (const std::size_t i : lit)
        reaches.push_back(reach_of(lights[i], true));
    const auto count = static_cast<std::uint32_t>(patches.count());
    const std::vector<Cell>& cells = patches.cells();
    const std::vector<CellGroup>& groups = patches.linked().groups();
    index_.assign(count + cells.size() + groups.size(), nothing);
    const auto add = [&](std::uint32_t number, std::size_t chart_index, const glm::dvec3& position,
                         const glm::dvec3& normal, double half_m, const auto& lx_of) {
        const Chart& chart = patches.charts().all()[chart_index];
        const auto first = static_cast<std::uint32_t>(shares_.size());
        bool throws = false;
        for (std::size_t i = 0; i < lights_; ++i) {
            Share& share = shares_.emplace_back();
            const glm::dvec3 lx = lx_of(shares[lit[i]]);
            const LightReach& reach = reaches[i];
            const glm::dvec3 way = reach.at_infinity ? lights[lit[i]].frame.z : reach.center - position;
            const double distance = reach.at_infinity ? std::numeric_limits<double>::infinity() : glm::length(way);
            const double size = reach.at_infinity ? reach.angular_radius_sin
                                                  : std::min(reach.body_radius / std::max(distance, 1e-9), 1.0);
            const double turn = std::min(half_m / std::max(distance, 1e-9), 1.0);
            const double bend = chart.kind == Chart::Kind::round ? half_m / chart.radius : 0.0;
            share.lx = glm::vec3(lx);
            share.towards = glm::vec3(way / std::max(glm::length(way), 1e-30));
            // Variances of slopes of facets: half an angle between directions; a quarter of the square of the radius of
            // a disk. α² is twice a variance.
            share.widening2 = static_cast<float>(0.125 * size * size + 0.125 * turn * turn + 0.5 * bend * bend);
            throws = throws || (lx != glm::dvec3(0.0) && glm::dot(glm::vec3(normal), share.towards) > least);
        }
        if (!throws) {
            shares_.resize(first);
            return;
        }
        index_[number] = static_cast<std::uint32_t>(senders_.size());
        senders_.push_back({glm::vec3(normal), glm::vec3(position), static_cast<std::uint32_t>(chart.surface), first,
                            patches.carried(number)});
    };
    for (std::uint32_t i = 0; i < count; ++i)
        if (lobes_[patches.surface_of(i)])
            add(i, patches.chart_of(i), patches.middle(i), patches.normal(i), patches.half_diagonal(i),
                [&](const ThrowingLight& light) { return glm::dvec3(light.lx[i]); });
    const auto sum_over = [&](std::uint32_t cell, const ThrowingLight& light) {
        glm::dvec3 sum(0.0);
        for (const std::uint32_t patch : patches.patches_of(cell))
            sum += patches.area_m2(patch) * glm::dvec3(light.lx[patch]);
        return sum;
    };
    const auto throws_any = [&](std::uint32_t chart) {
        return lobes_[patches.charts().all()[chart].surface].has_value();
    };
    for (const std::uint32_t i : patches.linked_cells())
        if (throws_any(cells[i].chart) && patches.cell_area_m2(i) > 0.0)
            add(count + i, cells[i].chart, cells[i].position, cells[i].normal, cells[i].half_diagonal_m,
                [&](const ThrowingLight& light) { return sum_over(i, light) / patches.cell_area_m2(i); });
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        const CellGroup& group = groups[i];
        if (!throws_any(group.chart)) continue;
        add(count + static_cast<std::uint32_t>(cells.size()) + i, group.chart, group.position, group.normal,
            group.half_diagonal_m, [&](const ThrowingLight& light) {
                glm::dvec3 sum(0.0);
                for (const std::uint32_t cell : group.cells)
                    sum += sum_over(cell, light);
                return sum / group.area_m2;
            });
    }
}

ThrownLight ThrownLight::times(const glm::vec3& rgb) const {
    ThrownLight changed = *this;
    for (Share& share : changed.shares_)
        share.lx *= rgb;
    return changed;
}

glm::vec3 ThrownLight::along(const Sender& sender, const glm::vec3& direction, float widening2) const {
    const float n_dot_v = glm::dot(sender.normal, direction);
    glm::vec3 sum(0.0F);
    if (!(n_dot_v > least)) return sum;
    const ThrowingLobe& lobe = *lobes_[sender.surface];
    for (std::size_t i = sender.first; i < sender.first + lights_; ++i) {
        const Share& share = shares_[i];
        const float n_dot_l = glm::dot(sender.normal, share.towards);
        if (n_dot_l > least && share.lx != glm::vec3(0.0F))
            sum +=
                pi * share.lx *
                value_of(lobe, sender.normal, share.towards, direction, n_dot_l, n_dot_v, share.widening2 + widening2);
    }
    return sum;
}

// The lobe is evaluated once, for the light as it lies between the patches.
glm::vec3 ThrownLight::along(const PatchMean& around, const glm::vec3& direction, float between_rays) const {
    std::array<const Sender*, 4> senders{};
    std::size_t count = 0;
    std::array<float, 4> weights{};
    glm::vec3 normal(0.0F);
    for (std::size_t i = 0; i < around.patch.size(); ++i) {
        const std::uint32_t index = index_[around.patch[i]];
        if (index == nothing || !(around.weight[i] > 0.0F)) continue;
        senders[count] = &senders_[index];
        weights[count++] = around.weight[i];
        normal += around.weight[i] * senders_[index].normal;
    }
    glm::vec3 sum(0.0F);
    if (count == 0) return sum;
    normal = glm::normalize(normal);
    const float n_dot_v = glm::dot(normal, direction);
    if (!(n_dot_v > least)) return sum;
    for (std::uint32_t light = 0; light < lights_; ++light) {
        Share share;
        for (std::size_t i = 0; i < count; ++i) {
            const Share& of = shares_[senders[i]->first + light];
            share.lx += weights[i] * of.lx;
            share.towards += weights[i] * of.towards;
            share.widening2 += weights[i] * of.widening2;
        }
        if (share.lx == glm::vec3(0.0F)) continue;
        share.towards = glm::normalize(share.towards);
        const float n_dot_l = glm::dot(normal, share.towards);
        if (n_dot_l > least)
            sum += pi * share.lx *
                   value_of(*lobes_[senders[0]->surface], normal, share.towards, direction, n_dot_l, n_dot_v,
                            share.widening2 + 0.5F * between_rays * between_rays);
    }
    return sum;
}

glm::dvec3 ThrownLight::gathered(const Bundles& bundles, std::size_t place, const Receivers::Place& at) const {
    const Frame frame = frame_about(at.position, at.normal);
    const glm::vec3 x(frame.x);
    const glm::vec3 y(frame.y);
    const glm::vec3 z(frame.z);
    const std::span<const PatchPoint> ends = bundles.ends(place);
    const DirectionArrays& directions = bundles.directions(place);
    // Between rays the direction changes by √(π/n), and the point that they meet with it. Every other ray is enough for
    // wide lobes.
    const auto count = static_cast<float>(ends.size());
    const std::size_t half = (ends.size() + 1) / 2;
    const float weight_of_half = count / static_cast<float>(half);
    glm::dvec3 by_rays(0.0);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!ends[i].is_on_patch()) continue;
        const std::uint32_t index = index_[ends[i].patch()];
        if (index == nothing) continue;
        const Sender& sender = senders_[index];
        const bool is_wide = lobes_[sender.surface]->alpha > wide;
        if (is_wide && i % 2 == 1) continue;
        const glm::vec3 direction = directions.axes[0][i] * x + directions.axes[1][i] * y + directions.axes[2][i] * z;
        by_rays +=
            glm::dvec3((is_wide ? weight_of_half : 1.0F) * sender.carried * along(sender, -direction, pi / count));
    }
    glm::dvec3 by_links(0.0);
    for (const Link& link : bundles.links(place)) {
        if (index_[link.sender] == nothing) continue;
        const Sender& sender = senders_[index_[link.sender]];
        const glm::vec3 direction = glm::normalize(glm::vec3(at.position) - sender.position);
        by_links += static_cast<double>(link.share) * glm::dvec3(sender.carried * along(sender, direction, 0.0F));
    }
    return by_rays / static_cast<double>(ends.size()) + by_links;
}

std::size_t ThrownLight::memory() const {
    return index_.size() * sizeof(std::uint32_t) + senders_.size() * sizeof(Sender) + shares_.size() * sizeof(Share);
}

} // namespace gonio::detail
