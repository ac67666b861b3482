#include <gonio/scene/core_vector.hpp>
#include <gonio/transport/form_factor.hpp>
#include <gonio/transport/part_links.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::detail {

namespace {

constexpr int deepest_part = 8;
constexpr double least_moment = 0.003; // of a form factor about the middle of a patch, in its sides

} // namespace

void PartLinks::begin(const Frame& place, const Frame& chart, double least_distance) {
    place_ = place;
    chart_x_ = place.to_local(chart.x);
    chart_y_ = place.to_local(chart.y);
    least_distance_ = least_distance;
    numbers_.clear();
    cut_.clear();
    free_.clear();
    weights_.clear();
    for (std::vector<double>& axis : middle_)
        axis.clear();
    for (std::array<std::vector<double>, 2>* const arrays : {&half_side_, &at_, &half_})
        for (std::vector<double>& side : *arrays)
            side.clear();
}

void PartLinks::add(const FlatPatch& patch, std::uint32_t number, double weight) {
    if (!(weight > 0.0)) return;
    const glm::dvec3 to_patch = place_.to_local(patch.middle - place_.origin);
    const double rise_u = std::abs(chart_x_.z) * patch.sides_m.x;
    const double rise_v = std::abs(chart_y_.z) * patch.sides_m.y;
    if (to_patch.z + 0.5 * (rise_u + rise_v) <= 0.0) return;
    undivided_.assign(1, {glm::dvec2(0.0), glm::dvec2(0.5), 0});
    while (!undivided_.empty()) {
        Part part = undivided_.back();
        undivided_.pop_back();
        const glm::dvec3 to =
            to_patch + part.middle.x * patch.sides_m.x * chart_x_ + part.middle.y * patch.sides_m.y * chart_y_;
        const glm::dvec2 half_m = part.half * patch.sides_m;
        const bool is_small = glm::dot(to, to) > least_distance_ * least_distance_ * glm::dot(half_m, half_m);
        if (part.depth < deepest_part && !is_small) {
            const int axis = half_m.x >= half_m.y ? 0 : 1;
            part.half[axis] *= 0.5;
            ++part.depth;
            part.middle[axis] -= part.half[axis];
            undivided_.push_back(part);
            part.middle[axis] += 2.0 * part.half[axis];
            undivided_.push_back(part);
            continue;
        }
        if (!is_small || to.z < part.half.x * rise_u + part.half.y * rise_v) cut_.push_back(numbers_.size());
        numbers_.push_back(number);
        free_.push_back(patch.free);
        weights_.push_back(weight);
        for (int axis = 0; axis < 3; ++axis)
            middle_.at(static_cast<std::size_t>(axis)).push_back(to[axis]);
        for (int side = 0; side < 2; ++side) {
            const auto at = static_cast<std::size_t>(side);
            half_side_.at(at).push_back(half_m[side]);
            at_.at(at).push_back(part.middle[side]);
            half_.at(at).push_back(part.half[side]);
        }
    }
}

void PartLinks::find() {
    const std::size_t count = size();
    share_.resize(count);
    for (std::vector<double>& moment : moment_)
        moment.resize(count);
    transport::FlatParts parts;
    for (int axis = 0; axis < 3; ++axis) {
        parts.x[axis] = chart_x_[axis];
        parts.y[axis] = chart_y_[axis];
        parts.middle[axis] = middle_.at(static_cast<std::size_t>(axis)).data();
    }
    for (std::size_t side = 0; side < 2; ++side) {
        parts.half_side[side] = half_side_.at(side).data();
        parts.at[side] = at_.at(side).data();
        parts.half[side] = half_.at(side).data();
    }
    parts.factor = free_.data();
    parts.count = count;
    kernels_.shares(parts, {share_.data(), {moment_[0].data(), moment_[1].data()}});
    for (const std::size_t part : cut_)
        find_cut(part);
}

void PartLinks::find_cut(std::size_t part) {
    const glm::dvec3 to = towards(part);
    const glm::dvec3 u = half_side_[0][part] * chart_x_;
    const glm::dvec3 v = half_side_[1][part] * chart_y_;
    const SeenPolygon seen = seen_above(glm::dvec3(0.0, 0.0, 1.0), {to - u - v, to + u - v, to + u + v, to - u + v});
    share_[part] = free_[part] * seen.form_factor;
    for (int axis = 0; axis < 3; ++axis)
        middle_.at(static_cast<std::size_t>(axis))[part] = seen.middle[axis];
    const double distance2 = glm::dot(seen.middle, seen.middle);
    const auto moment = [&](std::size_t side, const glm::dvec3& axis) {
        const double half = half_.at(side)[part];
        const double half_side = half_side_.at(side)[part];
        const double moved = glm::dot(seen.middle - to, axis) * half / half_side;
        const double steepness =
            seen.middle.z > 0.0 ? axis.z / seen.middle.z - 4.0 / distance2 * glm::dot(seen.middle, axis) : 0.0;
        return share_[part] * (at_.at(side)[part] + moved + half * half_side * steepness / 3.0);
    };
    moment_[0][part] = moment(0, chart_x_);
    moment_[1][part] = moment(1, chart_y_);
}

glm::dvec2 PartLinks::moment(std::size_t part) const {
    const glm::dvec2 moment(moment_[0][part], moment_[1][part]);
    const bool is_even = std::max(std::abs(moment.x), std::abs(moment.y)) < least_moment * share_[part];
    return is_even ? glm::dvec2(0.0) : moment;
}

} // namespace gonio::detail
