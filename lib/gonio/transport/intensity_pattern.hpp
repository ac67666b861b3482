// A light's distribution of intensity over directions, in the form that the intensity kernels read.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/transport/kernels_intensity.hpp>
#include <gonio/web/web.hpp>

#include <glm/vec3.hpp>

#include <map>
#include <memory>
#include <vector>

namespace gonio::detail {

// A web in float, at its own angles.
class WebTable {
public:
    explicit WebTable(const Web& web);

    transport::WebConstants constants(double scale) const;
    bool is_axial() const { return angles_ == transport::WebConstants::Angles::axial; }

private:
    struct Axis {
        std::vector<float> angles_deg;
        std::vector<float> inverse_width;
        std::vector<std::uint32_t> first_cell;
        float steps_per_deg = 0.0F;
        bool is_uniform = false;

        explicit Axis(std::span<const double> angles);
        transport::TableAxis constants() const;
    };

    transport::WebConstants::Angles angles_;
    Symmetry symmetry_;
    Axis horizontal_;
    Axis vertical_;
    std::vector<float> candela_;
};

// Web tables shared by lights; each is made once.
using WebTables = std::map<const Web*, std::shared_ptr<const WebTable>>;

// What a punctual light sends towards points; for a light with a size, its luminance by direction as seen from its
// centre: the approximation of engines.
class IntensityPattern {
public:
    // The light must outlive the pattern. `as_point`: for a light with a size, its intensity towards distant points,
    // computed in double for each point.
    IntensityPattern(const Light& light, WebTables& tables, bool as_point = false);

    bool has_axial_web() const;

    // Candela, or the factor of a mask, ≥ 0: one per point. Positions are relative to `anchor`.
    void evaluate(const transport::Points& points, const glm::dvec3& anchor, const transport::IntensityKernels& kernels,
                  float* cd) const;

private:
    const Light& light_;
    double along_axis_ = 0.0;
    transport::LobeConstants lobe_;
    std::shared_ptr<const WebTable> table_;
    std::shared_ptr<const ImagePlane> image_; // that a spot or a frustum projects
    transport::ImageConstants image_constants_;
    double web_scale_ = 1.0;
    bool as_point_ = false;
    bool is_share_ = false; // what evaluate() gives is a factor
};

} // namespace gonio::detail
