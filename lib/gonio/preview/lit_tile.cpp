#include <gonio/light/light_color.hpp>
#include <gonio/light/light_parts.hpp>
#include <gonio/preview/detail/lit_tile.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/named_surroundings.hpp>
#include <gonio/transport/reflected_view.hpp>
#include <gonio/transport/sky_light.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <variant>

namespace gonio::detail {

namespace {

// Times the error: how large a light may be, over its distance, to be seen from its centre.
constexpr double farthest_part = 25.0;
// Lights that are too near for the error, before the nearest of those that are left are taken as they are.
constexpr std::size_t most_failed = 2;

} // namespace

LitTile::LitTile(const LitScene& scene, const RenderOptions& options, const RayScene& rays, int left, int top,
                 Rendering& picture, RenderStats& stats, std::vector<PartialLight>& partial)
    : scene_(scene),
      options_(options),
      tile_(rays, left, top),
      picture_(picture),
      stats_(stats),
      partial_(partial),
      shader_(scene),
      soft_shadow_(scene) {}

void LitTile::light_up() {
    show_emitters();
    if (options_.shows_sky) show_sky();
    show_subjects();
    count_samples();
    if (picture_.indirect != nullptr || scene_.sky != nullptr) add_surroundings();
    for (const SurfaceSamples& samples : tile_.surfaces()) {
        Amounts none;
        for (std::size_t channel = 0; channel < channels(); ++channel)
            none[channel].resize(samples.size());
        gathered_.push_back(none);
        if (options_.error > 0.0)
            known_.push_back({none, LobeVariation::of(scene_.core_materials[samples.surface]),
                              std::vector<std::vector<ChunkPart>>(samples.chunks.size())});
    }
    for (const std::uint32_t index : candidates()) {
        const LitLight& light = scene_.lights[index];
        if (!find_groups(light)) continue;
        find_shadows(light);
        for (Group& group : groups_) {
            if (options_.error > 0.0) set_aside(index, group);
            shade(light, group);
        }
        shade_edges(light);
    }
    shade_far();
    add_gathered();
    complete_parts();
    stats_.not_converged += shader_.not_converged();
}

void LitTile::show_emitters() {
    for (const TileSamples::EmitterShare& seen : tile_.emitters()) {
        const Light& light = scene_.lights[seen.light].light;
        const glm::dvec3 rgb = shown_luminance(scene_.all_lights, seen.light, tile_.eye(), -seen.view);
        picture_.shows_light[seen.pixel] = 1;
        add(seen.pixel, static_cast<double>(seen.share) * rgb);
        const std::size_t surface = light.emitted_by ? light.emitted_by->surface : no_surface;
        if (seen.share < 1.0F) add_part(seen, surface, rgb);
    }
}

void LitTile::show_subjects() {
    const SeenRays& centers = tile_.centers();
    const bool none =
        std::none_of(tile_.surfaces().begin(), tile_.surfaces().end(),
                     [&](const SurfaceSamples& samples) { return scene_.stage.surfaces[samples.surface].subject; });
    if (none) return;
    for (std::ptrdiff_t y = 1; y <= tile_.bottom() - tile_.top(); ++y)
        for (std::ptrdiff_t x = 1; x <= tile_.right() - tile_.left(); ++x) {
            const auto center = static_cast<std::size_t>(y * tile_.stride() + x);
            if (centers.is_surface(center) && scene_.stage.surfaces[centers.surface_of(center)].subject)
                picture_.shows_subject[tile_.pixel_of(center)] = 1;
        }
}

void LitTile::show_sky() {
    for (const TileSamples::OpenShare& open : tile_.open())
        add(open.pixel, static_cast<double>(open.share) * options_.sky.radiance(open.direction));
}

void LitTile::add(std::uint32_t pixel, const glm::dvec3& nt) {
    for (int channel = 0; channel < 3; ++channel)
        picture_.luminance_nt.pixels[std::size_t{pixel} * 3 + static_cast<std::size_t>(channel)] +=
            static_cast<float>(nt[channel]);
}

// The points of a pixel on one light come one after the other.
void LitTile::add_part(const TileSamples::EmitterShare& seen, std::size_t surface, const glm::dvec3& rgb) {
    const std::array part{static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z)};
    if (surface != no_surface) reflected_[{seen.pixel, surface}].share += seen.share;
    if (!partial_.empty() && partial_.back().pixel == seen.pixel && partial_.back().rgb == part &&
        partial_.back().widening == seen.widening && part_surfaces_.back() == surface) {
        partial_.back().share += seen.share;
        return;
    }
    partial_.push_back({seen.pixel, seen.share, part, seen.widening});
    part_surfaces_.push_back(surface);
}

void LitTile::add_to_part(const SurfaceSamples& samples, std::size_t i, const glm::vec3& nt) {
    if (samples.center[i] >= 0) return; // a whole pixel
    const auto found = reflected_.find({samples.pixel[i], samples.surface});
    if (found != reflected_.end()) found->second.nt += nt;
}

// A surface that emits shows what it reflects, too: of its part of a pixel, the mean.
void LitTile::complete_parts() {
    for (std::size_t i = 0; i < part_surfaces_.size(); ++i) {
        if (part_surfaces_[i] == no_surface) continue;
        const Reflected& reflected = reflected_[{partial_[i].pixel, part_surfaces_[i]}];
        for (int channel = 0; channel < 3; ++channel)
            partial_[i].rgb.at(static_cast<std::size_t>(channel)) += reflected.nt[channel] / reflected.share;
    }
}

void LitTile::count_samples() {
    for (const SurfaceSamples& samples : tile_.surfaces()) {
        stats_.samples += samples.size();
        const shading::MaterialConstants& material = scene_.materials[samples.surface];
        if (material.kind == shading::kind_of<shading::Lambert> && !material.coat.is_on)
            stats_.samples_without_specular += samples.size();
        stats_.pairs += scene_.lights.size();
        stats_.evaluations += scene_.lights.size() * samples.size();
    }
}

namespace {

// Points of a pixel on an outline beside each other as one: what is around changes little between them, on what is
// flat. Round surfaces turn by much within the pixels of their outlines.
SurfaceSamples merged(const SurfaceSamples& all) {
    constexpr std::size_t most = edge_samples; // more would miss narrow highlights
    constexpr double least_cosine = 0.99;      // between normals, within one face
    SurfaceSamples few;
    few.surface = all.surface;
    few.reserve(all.size());
    for (std::size_t i = 0; i < all.size();) {
        std::size_t end = i + 1;
        auto share = static_cast<double>(all.share[i]);
        while (all.center[i] < 0 && end < all.size() && end - i < most && all.center[end] < 0 &&
               all.pixel[end] == all.pixel[i] && glm::dot(all.normal_of(i), all.normal_of(end)) > least_cosine)
            share += static_cast<double>(all.share[end++]);
        const std::size_t middle = (i + end) / 2;
        few.add({all.position_of(middle), all.normal_of(middle), all.view_of(middle)}, all.pixel[i], share,
                all.center[i]);
        i = end;
    }
    return few;
}

} // namespace

// Light that bounced, and that of a sky: what surfaces scatter of it, and what glossy ones show of it.
void LitTile::add_surroundings() {
    const Interreflection* const indirect = picture_.indirect.get();
    const SkyLight* const sky = scene_.sky;
    const ExchangeGeometry& exchange = indirect != nullptr ? *indirect->geometry() : *sky->geometry();
    ReflectedView view(exchange, indirect, sky != nullptr ? &sky->sky() : nullptr, scene_.surroundings,
                       options_.instruction_set);
    NodeReader nodes(exchange);
    const NamedSurroundings* const named = scene_.named;
    const bool named_sky = named != nullptr && named->has_diffuse();
    const bool named_lobe = named != nullptr && named->has_glossy();
    for (const SurfaceSamples& all : tile_.surfaces()) {
        const Primitive& geometry = scene_.stage.surfaces[all.surface].geometry;
        const bool is_round = std::holds_alternative<Ball>(geometry) || std::holds_alternative<Capsule>(geometry);
        const bool has_outline = std::any_of(all.center.begin(), all.center.end(), [](auto of) { return of < 0; });
        const bool is_merged = !is_round && has_outline;
        const SurfaceSamples few = is_merged ? merged(all) : SurfaceSamples();
        const SurfaceSamples& samples = is_merged ? few : all;
        const std::vector<LobeRays>& lobes = scene_.surroundings[samples.surface]->lobes;
        const bool has_view = !lobes.empty() && !named_lobe;
        if (has_view) {
            const SampleSquares squares = is_round ? SampleSquares() : tile_.squares_of(samples);
            glossy_.assign(samples.size(), glm::vec3(0.0F));
            for (const LobeRays& lobe : lobes) {
                const std::vector<glm::vec3>& shown = view.luminance(samples, squares, lobe);
                for (std::size_t i = 0; i < samples.size(); ++i)
                    glossy_[i] += shown[i];
            }
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const glm::dvec3 position = samples.position_of(i);
            const glm::dvec3 normal = glm::normalize(samples.normal_of(i));
            const NodeMean around = nodes.around(samples.surface, face_at(geometry, position), position);
            glm::dvec3 lx(0.0);
            if (indirect != nullptr) lx += around(indirect->nodes_lx());
            if (sky != nullptr) lx += named_sky ? named->sky_lx(normal) : around(sky->nodes_lx());
            const double cosine = glm::dot(normal, samples.view_of(i));
            glm::dvec3 diffuse = scene_.surroundings[samples.surface]->albedo(cosine);
            glm::dvec3 rgb(has_view ? glossy_[i] : glm::vec3(0.0F));
            for (const LobeRays& lobe : lobes) {
                const glm::dvec3 albedo = lobe.albedo(cosine);
                diffuse -= albedo;
                if (named_lobe)
                    rgb += named->glossy(position, normal, samples.view_of(i), {samples.surface, lobe.alpha(), albedo});
            }
            rgb += std::numbers::inv_pi * lx * glm::max(diffuse, glm::dvec3(0.0));
            add(samples, i, glm::vec3(rgb), static_cast<float>(glm::dot(lx, rec709_luminance)));
        }
    }
}

void LitTile::add(const SurfaceSamples& samples, std::size_t i, const glm::vec3& nt, float lx) {
    for (int channel = 0; channel < 3; ++channel)
        picture_.luminance_nt.pixels[std::size_t{samples.pixel[i]} * 3 + static_cast<std::size_t>(channel)] +=
            samples.share[i] * nt[channel];
    if (!reflected_.empty()) add_to_part(samples, i, samples.share[i] * nt);
    if (options_.illuminance) picture_.illuminance_lx.pixels[samples.pixel[i]] += samples.share[i] * lx;
}

// The lights within range of the tile, in their order.
std::vector<std::uint32_t> LitTile::candidates() const {
    std::vector<std::uint32_t> found;
    if (tile_.surfaces().empty()) return found;
    if (!options_.skip) {
        for (std::uint32_t i = 0; i < scene_.lights.size(); ++i)
            found.push_back(i);
        return found;
    }
    for (const SurfaceSamples& samples : tile_.surfaces())
        scene_.reaches.meeting_box(samples.bounds.low, samples.bounds.high, found);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

bool LitTile::find_groups(const LitLight& light) {
    groups_.clear();
    const auto count = [&](Unlit why, std::size_t evaluations) {
        if (why == Unlit::outside_cone) stats_.outside_cone += evaluations;
        if (why == Unlit::below_horizon) stats_.below_horizon += evaluations;
    };
    for (const SurfaceSamples& samples : tile_.surfaces()) {
        if (light.light.is_emitted_by(samples.surface)) {
            count(Unlit::below_horizon, samples.size()); // it is convex
            continue;
        }
        const Unlit all = options_.skip ? light.reach.unlit(samples.bounds) : Unlit::no;
        if (all != Unlit::no) {
            count(all, samples.size());
            continue;
        }
        if (options_.skip && options_.shadows != Shadows::off &&
            scene_.is_behind_plane(samples.surface, samples.bounds, light)) {
            stats_.shadow_tests += samples.size();
            stats_.in_shadow += samples.size();
            continue;
        }
        Group group{&samples, {}};
        for (std::uint32_t i = 0; i < samples.chunks.size(); ++i) {
            const SurfaceSamples::Chunk& chunk = samples.chunks[i];
            const Unlit why = options_.skip ? light.reach.unlit(chunk.bounds) : Unlit::no;
            count(why, chunk.count);
            if (why == Unlit::no) group.chunks.push_back(i);
        }
        if (group.chunks.empty()) continue;
        ++stats_.pairs_lit;
        groups_.push_back(std::move(group));
    }
    return !groups_.empty();
}

const std::vector<LitTile::Visible>& LitTile::visible_at(const LitLight& light, std::size_t surface,
                                                         const ShadowPoints& points) {
    stats_.shadow_tested += points.size();
    visible_at_.assign(points.size(), Visible());
    if (!scene_.has_soft_shadow(light)) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto share = static_cast<float>(scene_.visible_center(light, surface, points.position(i)));
            visible_at_[i] = {share, glm::vec3(share)};
        }
        return visible_at_;
    }
    const std::span<const VisibleShare> shares = soft_shadow_.visible(surface, points, true);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (shares[i].lx == 1.0) continue;
        if (shares[i].lx > 0.0) ++stats_.in_penumbra;
        visible_at_[i] = {static_cast<float>(shares[i].lx), shares[i].rgb};
    }
    return visible_at_;
}

void LitTile::find_centers() {
    const SeenRays& all = tile_.centers();
    std::vector<std::size_t> count(scene_.stage.surfaces.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all.is_surface(i)) ++count[all.surface_of(i)];
    std::vector<Centers*> of_surface(count.size(), nullptr);
    centers_.reserve(count.size());
    for (std::size_t surface = 0; surface < count.size(); ++surface) {
        if (count[surface] == 0) continue;
        of_surface[surface] = &centers_.emplace_back();
        of_surface[surface]->surface = surface;
        of_surface[surface]->index.reserve(count[surface]);
        of_surface[surface]->points.resize(count[surface]);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all.is_surface(i)) continue;
        Centers& centers = *of_surface[all.surface_of(i)];
        centers.points.set(centers.index.size(), all.position_of(i), all.normal_of(i), all.view_of(i));
        centers.index.push_back(static_cast<std::uint32_t>(i));
    }
}

void LitTile::find_shadows(const LitLight& light) {
    edges_.clear();
    is_shadowed_ = false;
    if (options_.shadows == Shadows::off) return;
    soft_shadow_.begin(light);
    is_shadowed_ = !options_.skip;
    for (const Group& group : groups_) {
        std::vector<std::uint32_t>& bodies = soft_shadow_.bodies(group.samples->surface);
        scene_.find_shadowing(group.samples->surface, group.samples->bounds, light, bodies);
        is_shadowed_ = is_shadowed_ || !bodies.empty();
    }
    if (!is_shadowed_) return;
    if (centers_.empty()) find_centers();
    center_visible_.assign(tile_.centers().size(), Visible());
    for (const Centers& centers : centers_) {
        if (light.light.is_emitted_by(centers.surface)) continue;
        const std::vector<Visible>& visible = visible_at(light, centers.surface, centers.points);
        for (std::size_t i = 0; i < visible.size(); ++i)
            center_visible_[centers.index[i]] = visible[i];
    }
    find_edges();
}

// Soft shadows are smooth; only a jump from lit to dark between neighbouring pixels needs more points.
void LitTile::find_edges() {
    const SeenRays& centers = tile_.centers();
    const std::ptrdiff_t stride = tile_.stride();
    on_shadow_edge_.assign(centers.size(), 0);
    for (std::ptrdiff_t y = 1; y <= tile_.bottom() - tile_.top(); ++y)
        for (std::ptrdiff_t x = 1; x <= tile_.right() - tile_.left(); ++x) {
            const std::ptrdiff_t at = y * stride + x;
            const auto center = static_cast<std::size_t>(at);
            if (!centers.is_surface(center) || tile_.on_outline(center)) continue;
            const float here = center_visible_[center].lx;
            const std::array neighbours{at - 1, at + 1, at - stride, at + stride};
            const bool jumps = std::any_of(neighbours.begin(), neighbours.end(), [&](std::ptrdiff_t n) {
                return std::abs(here - center_visible_[static_cast<std::size_t>(n)].lx) > 0.5F;
            });
            if (!jumps) continue;
            on_shadow_edge_[center] = 1;
            edges_.push_back(center);
        }
}

void LitTile::shade(const LitLight& light, const Group& group) {
    const SurfaceSamples& samples = *group.samples;
    for (const std::uint32_t index : group.chunks) {
        const SurfaceSamples::Chunk& chunk = samples.chunks[index];
        stats_.shadow_tests += chunk.count;
        const float* weight = samples.share.data() + chunk.first;
        const Visible* through = nullptr;
        if (is_shadowed_) {
            weight_.assign(weight, weight + chunk.count);
            visible_.resize(chunk.count);
            within_.clear();
            for (std::size_t i = chunk.first; i < chunk.first + chunk.count; ++i)
                if (samples.center[i] < 0)
                    within_.add(samples.position_of(i), samples.normal_of(i), samples.view_of(i));
            std::size_t of_within = 0;
            const std::vector<Visible>& visible_within = visible_at(light, samples.surface, within_);
            for (std::size_t i = 0; i < chunk.count; ++i) {
                const std::int32_t center = samples.center[chunk.first + i];
                visible_[i] =
                    center < 0 ? visible_within[of_within++] : center_visible_[static_cast<std::size_t>(center)];
                if (center >= 0 && on_shadow_edge_[static_cast<std::size_t>(center)] != 0)
                    visible_[i] = Visible{0.0F, glm::vec3(0.0F)};
                if (visible_[i].is_none()) weight_[i] = 0.0F;
            }
            weight = weight_.data();
            through = visible_.data();
            if (options_.skip && std::all_of(weight_.begin(), weight_.end(), [](float w) { return w == 0.0F; })) {
                stats_.in_shadow += chunk.count;
                continue;
            }
        }
        stats_.evaluated += chunk.count;
        shader_.shade(light, samples, chunk.first, chunk.count, weight);
        gather(samples, chunk, through);
    }
}

const std::vector<float>& LitTile::shaded(std::size_t channel) const {
    return channel < 3 ? shader_.rgb()[channel] : shader_.lx();
}

void LitTile::gather(const SurfaceSamples& samples, const SurfaceSamples::Chunk& chunk, const Visible* visible) {
    Amounts& gathered = gathered_[static_cast<std::size_t>(&samples - tile_.surfaces().data())];
    for (std::size_t channel = 0; channel < channels(); ++channel) {
        float* const sum = gathered[channel].data() + chunk.first;
        const float* const value = shaded(channel).data();
        if (visible == nullptr)
            for (std::size_t i = 0; i < chunk.count; ++i)
                sum[i] += value[i];
        else
            for (std::size_t i = 0; i < chunk.count; ++i)
                sum[i] += (channel < 3 ? visible[i].rgb[static_cast<int>(channel)] : visible[i].lx) * value[i];
    }
}

void LitTile::add_gathered() {
    for (std::size_t surface = 0; surface < gathered_.size(); ++surface) {
        const SurfaceSamples& samples = tile_.surfaces()[surface];
        const Amounts& all = gathered_[surface];
        for (std::size_t i = 0; i < samples.size(); ++i)
            add(samples, i, {all[0][i], all[1][i], all[2][i]}, options_.illuminance ? all[3][i] : 0.0F);
    }
}

void LitTile::set_aside(std::uint32_t index, Group& group) {
    const LitLight& light = scene_.lights[index];
    if (is_shadowed_ || !light.luminance || !light.luminance->has_center_form()) return;
    // What is nearer would hardly stay within the error, and the exact light of near lights leaves more of it to
    // others.
    const double most = std::min(farthest_part * options_.error, WebVariation::reach_rad);
    const auto is_far = [&](std::uint32_t chunk) {
        const SampleBounds& bounds = group.samples->chunks[chunk].bounds;
        if (is_web_dark(light, bounds)) {
            stats_.outside_cone += group.samples->chunks[chunk].count;
            return true;
        }
        const double away = glm::length(light.reach.center - glm::clamp(light.reach.center, bounds.low, bounds.high));
        if (!(light.reach.body_radius < most * away)) return false;
        const auto surface = static_cast<std::uint32_t>(group.samples - tile_.surfaces().data());
        find_forms(far_.emplace_back(Far{light.reach.body_radius / away, index, surface, chunk, {}}));
        return true;
    };
    std::erase_if(group.chunks, is_far);
}

// For each chunk, those of which the least error can be expected come first, so that most of them find room.
void LitTile::shade_far() {
    if (far_.empty()) return;
    std::sort(far_.begin(), far_.end(), [](const Far& a, const Far& b) {
        return std::tie(a.surface, a.chunk, a.forms.most_lx, a.part, a.light) <
               std::tie(b.surface, b.chunk, b.forms.most_lx, b.part, b.light);
    });
    is_shadowed_ = false;
    for (auto first = far_.begin(); first != far_.end();) {
        const auto end = std::find_if(first, far_.end(), [&](const Far& far) {
            return far.surface != first->surface || far.chunk != first->chunk;
        });
        const SurfaceSamples& samples = tile_.surfaces()[first->surface];
        const SurfaceSamples::Chunk& chunk = samples.chunks[first->chunk];
        const Group group{&samples, {first->chunk}};
        std::size_t failed = 0;       // one after the other
        bool from_center_fits = true; // where it did not, it hardly does for those with a greater error as points
        for (auto last = end; first != last; ++first) {
            const LitLight& light = scene_.lights[first->light];
            bool fits = first->forms.are_bounded && adds_as_point(*first, chunk);
            if (!fits && (from_center_fits || !first->forms.are_bounded))
                fits = from_center_fits = adds_from_center(light, first->surface, chunk);
            if (fits) {
                failed = 0;
                continue;
            }
            shade(light, group);
            if (++failed < most_failed) continue;
            // More is known of the light after the nearest of those that are left, and fewer are left.
            failed = 0;
            for (auto nearest = (last - first - 1 + 15) / 16; nearest > 0; --nearest)
                shade(scene_.lights[(--last)->light], group);
        }
        first = end;
    }
}

// One form for the whole chunk is enough where its bound is below the error; a chunk of a floor far away is tens of
// metres deep.
void LitTile::find_forms(Far& far) {
    Known& known = known_[far.surface];
    if (!known.lobe) return;
    const LitLight& light = scene_.lights[far.light];
    const SurfaceSamples& samples = tile_.surfaces()[far.surface];
    const SurfaceSamples::Chunk& chunk = samples.chunks[far.chunk];
    std::vector<ChunkPart>& parts = known.parts[far.chunk];
    if (parts.empty()) {
        parts.push_back({chunk.bounds, ViewBounds(samples, chunk.first, chunk.count)});
        for (std::size_t first = 0; first < chunk.count && chunk.count <= of_part * most_parts; first += of_part) {
            const std::size_t count = std::min(of_part, chunk.count - first);
            BoundsBuilder builder;
            for (std::size_t i = chunk.first + first; i < chunk.first + first + count; ++i)
                builder.add(samples.position_of(i), samples.normal_of(i));
            parts.push_back({builder.bounds(), ViewBounds(samples, chunk.first + first, count)});
        }
    }
    Far::Forms& forms = far.forms;
    forms.of_parts[0] = point_form(light, parts[0].points, parts[0].views, *known.lobe);
    forms.of_each = chunk.count;
    std::size_t count = 1;
    if (parts.size() > 1 && !(forms.of_parts[0].share < options_.error)) {
        forms.of_each = of_part;
        count = parts.size() - 1;
        for (std::size_t i = 0; i < count; ++i)
            forms.of_parts[i] = point_form(light, parts[i + 1].points, parts[i + 1].views, *known.lobe);
    }
    forms.are_bounded = true;
    forms.most_lx = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        forms.are_bounded = forms.are_bounded && forms.of_parts[i].is_bounded();
        forms.most_lx = std::max(forms.most_lx, forms.of_parts[i].most_lx);
    }
}

bool LitTile::adds_as_point(const Far& far, const SurfaceSamples::Chunk& chunk) {
    shader_.shade_as_point(scene_.lights[far.light], far.forms.of_parts, far.forms.of_each,
                           tile_.surfaces()[far.surface], chunk.first, chunk.count);
    if (!adds_shaded(far.surface, chunk)) return false;
    stats_.as_point += chunk.count;
    return true;
}

bool LitTile::adds_from_center(const LitLight& light, std::size_t of_surface, const SurfaceSamples::Chunk& chunk) {
    shader_.shade_from_center(light, tile_.surfaces()[of_surface], chunk.first, chunk.count);
    if (!adds_shaded(of_surface, chunk)) return false;
    stats_.from_center += chunk.count;
    return true;
}

// All light is ≥ 0: the error may be a share of what is known of it, since more can only come.
bool LitTile::adds_shaded(std::size_t of_surface, const SurfaceSamples::Chunk& chunk) {
    const Amounts& gathered = gathered_[of_surface];
    Known& known = known_[of_surface];
    const auto errors = [&](std::size_t channel) {
        return channel < 3 ? shader_.rgb_error()[channel].data() : shader_.lx_error().data();
    };
    const auto most = static_cast<float>(options_.error);
    for (std::size_t channel = 0; channel < channels(); ++channel) {
        const float* const value = shaded(channel).data();
        const float* const error = errors(channel);
        const float* const light_so_far = gathered[channel].data() + chunk.first;
        const float* const error_so_far = known.error[channel].data() + chunk.first;
        unsigned misfits = 0; // counted, not branched on, so that it runs in packs
        for (std::size_t i = 0; i < chunk.count; ++i) {
            const float least = value[i] - error[i];
            const float sure = least > 0.0F ? least : 0.0F;
            const float known_light = light_so_far[i] - error_so_far[i]; // never more than the exact light
            misfits += error_so_far[i] + error[i] <= most * (known_light + sure) ? 0U : 1U;
        }
        if (misfits > 0) return false;
    }
    for (std::size_t channel = 0; channel < channels(); ++channel) {
        const float* const error = errors(channel);
        float* const error_so_far = known.error[channel].data() + chunk.first;
        for (std::size_t i = 0; i < chunk.count; ++i)
            error_so_far[i] += error[i];
    }
    stats_.shadow_tests += chunk.count;
    stats_.evaluated += chunk.count;
    gather(tile_.surfaces()[of_surface], chunk, nullptr);
    return true;
}

void LitTile::shade_edges(const LitLight& light) {
    if (!is_shadowed_ || edges_.empty()) return;
    struct Edge {
        std::size_t surface;
        ShadowPoints points;
        std::vector<std::size_t> center; // of the pixel of each
    };
    std::vector<Edge> by_surface;
    for (const std::size_t center : edges_)
        for (const Seen& seen : tile_.fine(center)) {
            if (seen.what != Seen::What::surface || light.light.is_emitted_by(seen.hit.surface)) continue;
            auto found = std::find_if(by_surface.begin(), by_surface.end(),
                                      [&](const Edge& edge) { return edge.surface == seen.hit.surface; });
            if (found == by_surface.end()) {
                by_surface.emplace_back().surface = seen.hit.surface;
                found = by_surface.end() - 1;
            }
            found->points.add(seen.hit.position, seen.hit.normal, seen.view);
            found->center.push_back(center);
        }
    for (const Edge& edge : by_surface) {
        const std::vector<Visible>& visible = visible_at(light, edge.surface, edge.points);
        SurfaceSamples samples;
        samples.surface = edge.surface;
        visible_.clear();
        for (std::size_t i = 0; i < visible.size(); ++i) {
            if (visible[i].is_none()) continue;
            samples.add({edge.points.position(i), edge.points.normal(i), edge.points.view(i)},
                        tile_.pixel_of(edge.center[i]),
                        static_cast<double>(tile_.share_of(edge.center[i])) / (edge_samples * edge_samples), -1);
            visible_.push_back(visible[i]);
        }
        stats_.at_shadow_edges += samples.size();
        shader_.shade(light, samples, 0, samples.size(), samples.share.data());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const glm::vec3 nt(shader_.rgb()[0][i], shader_.rgb()[1][i], shader_.rgb()[2][i]);
            add(samples, i, visible_[i].rgb * nt, options_.illuminance ? visible_[i].lx * shader_.lx()[i] : 0.0F);
        }
    }
}

} // namespace gonio::detail
