// Web: the photometric web, candela by direction; the only form of measured light that all other code uses.
//
// The grid is the file's own, in its goniometer type A, B or C (gonio/web/goniometer.hpp), with angles strictly
// ascending and in degrees, so that the values at table angles are exact; symmetry is kept and not expanded; every
// factor is already applied, candela are absolute. Between the grid's angles the intensity is linear in both of them;
// outside them, after symmetry, it is 0. Frame: γ = 0 is −Z, C0 is +X, C90 is +Y (gonio/base/frame.hpp). Webs are
// evaluated by direction or by (C, γ). Code that reads the grid must check photometry() first: a web of type A or B
// does not have C-planes and γ (gonio/web/resample.hpp makes a web that does). Evaluation costs two searches (none on
// uniform grids) and no allocation; a Web does not change and may be read by any number of threads.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/profile/photometry_type.hpp>

#include <glm/vec3.hpp>

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// How the stored grid covers the directions: the mirror symmetries of the light, which the grid omits.
enum class Symmetry {
    axial,            // C: one plane for every C; never A and B
    quadrant,         // mirrored in both; C: planes 0°–90°, A and B: H ≥ 0 and V ≥ 0
    bilateral_0_180,  // mirrored in the C0–C180 plane; C: planes 0°–180°, A and B: V ≥ 0
    bilateral_90_270, // mirrored in the C90–C270 plane; C: planes 90°–270°, A and B: H ≥ 0
    none              // as stored
};

const char* to_text(Symmetry symmetry); // "bilateral-0-180": as in reports

// Whether one side of a mirror is stored: across the C0–C180 plane, or across C90–C270.
constexpr bool mirrored_in_0_180(Symmetry stored) {
    return stored == Symmetry::quadrant || stored == Symmetry::bilateral_0_180;
}
constexpr bool mirrored_in_90_270(Symmetry stored) {
    return stored == Symmetry::quadrant || stored == Symmetry::bilateral_90_270;
}

// How many images of the stored grid cover all directions: 4, 2 or 1.
double image_count(Symmetry stored);

// Intensity by direction.
class Web {
public:
    // `candela` is [plane][gamma]. Fails (malformed) unless both angle lists are non-empty, finite and strictly
    // ascending, γ lies in [0°, 180°], the planes lie in the range of `stored` (none: at most 360° wide), and there is
    // one candela for each pair, finite and at most greatest_amount (gonio/base/amount_range.hpp) in magnitude.
    static Result<Web> create(Symmetry stored, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                              std::vector<double> candela);

    // A web of any goniometer type; `candela` is [horizontal][vertical]. Photometry::c is create(). Fails (malformed)
    // as that does, and for A and B unless latitudes are in [−90°, 90°], longitudes in [−180°, 180°], and the angles
    // that `stored` mirrors are not negative; A and B are never axial.
    static Result<Web> create(Photometry photometry, Symmetry stored, std::vector<double> horizontal_deg,
                              std::vector<double> vertical_deg, std::vector<double> candela);

    // Intensity towards (C, γ), for any goniometer type. Any finite C; γ in [0°, 180°], 0 outside. NaN gives 0.
    double candela(double c_deg, double gamma_deg) const;

    // Intensity along a direction in the light's frame, of any length > 0.
    double candela(const glm::dvec3& direction) const;

    // Intensity at the grid's own angles: (C, γ), or (H, V) for type A or B. Exact at table angles. NaN gives 0.
    double candela_at(double horizontal_deg, double vertical_deg) const;

    Photometry photometry() const { return photometry_; }
    Symmetry stored_symmetry() const { return stored_; }

    // The stored grid: C-planes and γ, or H and V.
    std::span<const double> horizontal_deg() const { return planes_.angles_deg; }
    std::span<const double> vertical_deg() const { return gammas_.angles_deg; }

    // The same by their type C names; the web must be of type C.
    std::span<const double> planes_deg() const {
        assert(photometry_ == Photometry::c);
        return planes_.angles_deg;
    }
    std::span<const double> gammas_deg() const {
        assert(photometry_ == Photometry::c);
        return gammas_.angles_deg;
    }

    // The intensities at a stored horizontal angle (a C-plane), one per vertical angle.
    std::span<const double> column(std::size_t horizontal) const {
        return {candela_.data() + horizontal * gammas_.angles_deg.size(), gammas_.angles_deg.size()};
    }

    // The same light with every intensity multiplied by `factor` ≥ 0; the results must not exceed greatest_amount.
    Web scaled(double factor) const;

    // Type C: C folded by the stored symmetry into the range of the stored planes, which may still not reach it.
    double folded_c_deg(double c_deg) const;

    // The same of the grid's own angles, for any goniometer.
    double folded_horizontal_deg(double horizontal_deg) const;
    double folded_vertical_deg(double vertical_deg) const;

private:
    // Strictly ascending angles; if they are uniformly spaced, the cell of an angle is found without a search.
    struct Axis {
        std::vector<double> angles_deg;
        double cells_per_deg = 0.0; // 0 if not uniform

        explicit Axis(std::vector<double> angles);
        // The cell [i, i+1] that contains the angle and the weight of its upper end; false outside the angles.
        bool locate(double angle_deg, std::size_t& cell, double& weight) const;
    };

    Web(Photometry photometry, Symmetry stored, Axis planes, Axis gammas, std::vector<double> candela);

    double interpolate(double horizontal_deg, double vertical_deg) const;

    Photometry photometry_;
    Symmetry stored_;
    Axis planes_;
    Axis gammas_;
    std::vector<double> candela_;
};

} // namespace gonio
#pragma GCC visibility pop
