// The luminance of an area light that is not uniform: behind a mask, as a face of a luminous opening, or with an image.
//
// For many receivers at once, the mean of the luminance over what each sees of the light, weighted as its irradiance
// is. Flat lights have tables of running integrals (kernels_luminance.hpp) or the nodes of their image
// (image_pattern.hpp), spheres and tubes a few directions.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/transport/image_pattern.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/kernels_luminance.hpp>
#include <gonio/transport/web_variation.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace gonio::detail {

// T of kernels_luminance.hpp for one side of a flat light.
class ColumnPattern {
public:
    // `columns_along_y`: of the light's frame; else along X. `behind`: for the far side of a two-sided light.
    ColumnPattern(const Light& light, bool columns_along_y, bool behind, double step_deg);

    transport::ColumnTable constants() const;

private:
    std::size_t count_;
    double step_rad_;
    std::vector<float> nodes_;
};

// Tables shared by lights with the same profile and opening, or with the same image and size; each is made once.
struct LuminanceTables {
    std::map<std::tuple<const void*, std::size_t, bool, bool>, std::shared_ptr<const ColumnPattern>> columns;
    std::map<std::tuple<const ImagePlane*, double, double>, std::shared_ptr<const ImagePattern>> images;
    std::map<const Web*, std::shared_ptr<const WebVariation>> variations;
};

class LuminancePattern {
public:
    // The light must have a pattern (Light::has_pattern()), be an area light and outlive this.
    LuminancePattern(const Light& light, LuminanceTables& tables, WebTables& webs);

    // One factor on Light::luminance per receiver, ≥ 0. Positions are relative to `anchor`.
    void evaluate(const transport::Receivers& receivers, const glm::dvec3& anchor,
                  const transport::LuminanceKernels& columns, const transport::IntensityKernels& intensity,
                  std::vector<float>& share) const;

    // The same for what a lobe of roughness `alpha` (GGX) reflects towards the views, given the results of evaluate():
    // a narrow lobe shows the luminance from where the mirrored view meets the light, a wide one the mean.
    void along_lobes(const shading::Surfaces& surfaces, const glm::dvec3& anchor, double alpha,
                     const transport::LuminanceKernels& kernels, const transport::IntensityKernels& intensity,
                     const std::vector<float>& mean, std::vector<float>& share) const;

    // The factor as from the centre of the light alone, and how far at most the factors of evaluate() and of
    // along_lobes() with this `alpha` can be from it (derived beside the code). Infinite where there is no bound, and
    // everywhere for a light with an image, which has no such factor. `alpha`: nothing if there is no lobe.
    void from_center(const transport::Receivers& receivers, const glm::dvec3& anchor, std::optional<double> alpha,
                     const transport::IntensityKernels& intensity, std::vector<float>& share,
                     std::vector<float>& error) const;
    bool has_center_form() const { return variation_ != nullptr && variation_->is_bounded(); }

    // The candela that the web sends from the centre towards each point, for a face of a luminous opening; behind a
    // mask the web has no unit.
    void candela(const transport::Points& points, const glm::dvec3& anchor,
                 const transport::IntensityKernels& intensity, float* cd) const;
    // How much the web changes with direction; null for a light with an image.
    const WebVariation* variation() const { return variation_.get(); }

    // Factors on Light::luminance that a receiver sees along unit directions, of images blurred to a few parts of their
    // side.
    void towards(const glm::dvec3& receiver, const transport::Points& directions,
                 const transport::IntensityKernels& intensity, float* share) const;

private:
    void by_columns(const transport::Receivers& receivers, const glm::dvec3& anchor,
                    const transport::LuminanceKernels& kernels, float* share) const;

    void replace_far(const transport::Receivers& receivers, const glm::dvec3& anchor, float* share) const;

    void add_faces(const FaceEmission& emission);

    // Factors on Light::luminance towards points, relative to its centre, of lights without an image. `side`: −1 for
    // points as far on the other side.
    void towards_points(const transport::Points& points, double side, const transport::IntensityKernels& kernels,
                        float* share) const;

    void blurred_by_lobes(const transport::LobePoints& points, const glm::dvec3& anchor, double lobe_rad,
                          float* seen) const;
    double blurred(const glm::dvec3& viewer, const glm::dvec3& toward, const glm::dvec2& half) const;

    void by_directions(const transport::Receivers& receivers, const glm::dvec3& anchor,
                       const transport::IntensityKernels& kernels, std::vector<float>& share) const;

    const Light& light_;
    bool columns_along_y_ = true;
    double column_rad_ = 0.0;
    std::shared_ptr<const ColumnPattern> front_;    // of flat lights
    std::shared_ptr<const ColumnPattern> back_;     // of two-sided ones
    std::shared_ptr<const WebTable> web_;           // of all without an image
    std::shared_ptr<const ImagePattern> image_;     // of rectangles with an image
    std::shared_ptr<const WebVariation> variation_; // of web_
    double node_rad_ = 0.0;                         // of these, the angle between directions
    // Of the luminous body: transport::BodyFaces.
    std::array<std::vector<float>, 3> face_normals_;
    float round_m2_ = 0.0F;
};

} // namespace gonio::detail
