#include <gonio/light/light_image.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/web/web.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace gonio::detail {

namespace {

using transport::LobeConstants;
using transport::WebConstants;

constexpr std::size_t most_steps = 4096;

WebConstants::Angles angles_of(const Web& web) {
    if (web.photometry() == Photometry::a) return WebConstants::Angles::type_a;
    if (web.photometry() == Photometry::b) return WebConstants::Angles::type_b;
    switch (web.stored_symmetry()) {
    case Symmetry::axial:
        return WebConstants::Angles::axial;
    case Symmetry::quadrant:
        return WebConstants::Angles::quadrant;
    case Symmetry::bilateral_0_180:
        return WebConstants::Angles::bilateral_0_180;
    case Symmetry::bilateral_90_270:
        return WebConstants::Angles::bilateral_90_270;
    case Symmetry::none:
        break;
    }
    return WebConstants::Angles::full;
}

LobeConstants::Kind kind_of_falloff(Falloff falloff) {
    switch (falloff) {
    case Falloff::frostbite:
        return LobeConstants::Kind::frostbite;
    case Falloff::hard:
        return LobeConstants::Kind::hard;
    case Falloff::linear_cos:
        return LobeConstants::Kind::linear_cos;
    case Falloff::smoothstep_cos:
        return LobeConstants::Kind::smoothstep_cos;
    case Falloff::linear_angle:
        return LobeConstants::Kind::linear_angle;
    case Falloff::smoothstep_angle:
        break;
    }
    return LobeConstants::Kind::smoothstep_angle;
}

// The lobe of a punctual shape.
LobeConstants lobe_of(const PointShape& /*alike in all directions*/) {
    return {};
}
LobeConstants lobe_of(const ProfileShape& /*its web says it*/) {
    return {};
}
LobeConstants lobe_of(const SpotShape& spot) {
    LobeConstants lobe;
    lobe.kind = kind_of_falloff(spot.falloff);
    lobe.inner = static_cast<float>(spot.inner.value);
    lobe.outer = static_cast<float>(spot.outer.value);
    return lobe;
}
LobeConstants lobe_of(const FrustumShape& frustum) {
    LobeConstants lobe;
    lobe.kind = LobeConstants::Kind::frustum;
    lobe.inner = static_cast<float>(0.5 * frustum.horizontal.value);
    lobe.outer = static_cast<float>(0.5 * frustum.vertical.value);
    return lobe;
}

LobeConstants lobe_of(const Shape& shape) {
    return with_traits(shape, []<class Kind>(const Kind& kind, ShapeTraits<Kind>) -> LobeConstants {
        if constexpr (PunctualShape<Kind>)
            return lobe_of(kind);
        else
            return {};
    });
}

// Finer than pictures show it, a projected image would flicker between their pixels: means over 1024 pixels a side at
// most.
std::shared_ptr<const ImagePlane> reduced(const std::shared_ptr<const ImagePlane>& image) {
    constexpr int most = 1024;
    const int width = std::min(image->width(), most);
    const int height = std::min(image->height(), most);
    if (width == image->width() && height == image->height()) return image;
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const glm::dvec2 size(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const glm::dvec2 low = glm::dvec2(column, row) / size;
            values.push_back(static_cast<float>(image->mean(low, low + 1.0 / size)));
        }
    return std::make_shared<const ImagePlane>(width, height, std::move(values));
}

transport::ImageConstants image_constants(const Shape& shape, const ImagePlane& image) {
    transport::ImageConstants constants{image.pixels().data(), static_cast<std::size_t>(image.width()),
                                        static_cast<std::size_t>(image.height())};
    const glm::dvec2 covered = covered_by_image(shape);
    constants.slope_x = static_cast<float>(covered.x);
    constants.slope_y = static_cast<float>(covered.y);
    return constants;
}

void copy(const glm::dvec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = static_cast<float>(from[i]);
}

} // namespace

WebTable::Axis::Axis(std::span<const double> angles) : angles_deg(angles.begin(), angles.end()) {
    if (angles.size() < 2) return;
    double narrowest = angles[1] - angles[0];
    double widest = narrowest;
    for (std::size_t i = 1; i < angles.size(); ++i) {
        narrowest = std::min(narrowest, angles[i] - angles[i - 1]);
        widest = std::max(widest, angles[i] - angles[i - 1]);
        inverse_width.push_back(static_cast<float>(1.0 / (angles[i] - angles[i - 1])));
    }
    const double whole = angles.back() - angles.front();
    const auto steps =
        static_cast<std::size_t>(std::clamp(std::round(whole / narrowest), 1.0, static_cast<double>(most_steps)));
    steps_per_deg = static_cast<float>(static_cast<double>(steps) / whole);
    is_uniform = widest - narrowest < 1e-7 * widest && steps + 1 == angles.size();
    std::size_t cell = 0;
    for (std::size_t step = 0; step < steps; ++step) {
        // Slightly before the step begins: rounding may put an angle into the step after its correct one.
        const double begin = angles.front() + whole * (static_cast<double>(step) - 1e-3) / static_cast<double>(steps);
        while (cell + 2 < angles.size() && angles[cell + 1] <= begin)
            ++cell;
        first_cell.push_back(static_cast<std::uint32_t>(cell));
    }
}

transport::TableAxis WebTable::Axis::constants() const {
    return {angles_deg.data(), inverse_width.data(), first_cell.data(), angles_deg.size(),
            first_cell.size(), steps_per_deg,        is_uniform};
}

WebTable::WebTable(const Web& web)
    : angles_(angles_of(web)),
      symmetry_(web.stored_symmetry()),
      horizontal_(web.horizontal_deg()),
      vertical_(web.vertical_deg()) {
    candela_.reserve(horizontal_.angles_deg.size() * vertical_.angles_deg.size());
    for (std::size_t column = 0; column < horizontal_.angles_deg.size(); ++column)
        for (const double cd : web.column(column))
            candela_.push_back(static_cast<float>(cd));
}

WebConstants WebTable::constants(double scale) const {
    return {angles_,
            mirrored_in_90_270(symmetry_),
            mirrored_in_0_180(symmetry_),
            horizontal_.constants(),
            vertical_.constants(),
            candela_.data(),
            static_cast<float>(scale)};
}

IntensityPattern::IntensityPattern(const Light& light, WebTables& tables, bool as_point)
    : light_(light), as_point_(as_point), is_share_(!as_point && has_extent(light.shape)) {
    if (as_point) return;
    if (light.emission != nullptr) { // from its centre
        as_point_ = true;
        return;
    }
    if (light.image != nullptr) {
        along_axis_ = is_share_ ? light.image->mean() : light.intensity.value;
        if (is_share_) return;
        lobe_ = lobe_of(light.shape);
        image_ = reduced(light.image);
        along_axis_ *= image_ == light.image ? 1.0 : image_->peak();
        image_constants_ = image_constants(light.shape, *image_);
        return;
    }
    const auto* profile = std::get_if<ProfileShape>(&light.shape);
    const Web* const web = profile != nullptr ? profile->web.get() : mask_of(light.shape).web;
    along_axis_ = is_share_ || profile != nullptr ? 1.0 : light.intensity.value;
    if (!is_share_) lobe_ = lobe_of(light.shape);
    if (web == nullptr) return;
    web_scale_ = light.web_scale;
    std::shared_ptr<const WebTable>& table = tables[web];
    if (table == nullptr) table = std::make_shared<const WebTable>(*web);
    table_ = table;
}

bool IntensityPattern::has_axial_web() const {
    return table_ != nullptr && table_->is_axial();
}

void IntensityPattern::evaluate(const transport::Points& points, const glm::dvec3& anchor,
                                const transport::IntensityKernels& kernels, float* cd) const {
    if (as_point_) {
        for (std::size_t i = 0; i < points.count; ++i) {
            const glm::dvec3 at =
                anchor + glm::dvec3(points.position[0][i], points.position[1][i], points.position[2][i]);
            const glm::dvec3 towards = at - light_.frame.origin;
            const double value = is_share_ ? light_.luminance_share(towards) : light_.intensity_towards(towards).value;
            cd[i] = value > 0.0 ? static_cast<float>(value) : 0.0F; // 0 at the position of the light itself
        }
        return;
    }
    std::fill(cd, cd + points.count, static_cast<float>(along_axis_));
    if (lobe_.kind == LobeConstants::Kind::none && table_ == nullptr && image_ == nullptr) return;
    transport::LightFrame frame;
    copy(light_.frame.origin - anchor, frame.origin);
    copy(light_.frame.x, frame.x);
    copy(light_.frame.y, frame.y);
    copy(light_.frame.z, frame.z);
    kernels.lobe(points, frame, lobe_, cd);
    if (table_ != nullptr) kernels.web(points, frame, table_->constants(web_scale_), cd);
    if (image_ != nullptr) kernels.image(points, frame, image_constants_, cd);
}

} // namespace gonio::detail
