// Web: the photometric web, candela by direction; the one form of a measured light that everything downstream takes.
//
// The grid is the file's own (type C: half planes C around the vertical axis, γ from the nadir), angles strictly
// ascending and in degrees, so that a table angle is hit exactly; symmetry is kept and not expanded; every factor is
// already applied, candela are absolute. Between the grid's angles the intensity is linear in C and in γ; outside
// them, after symmetry, it is 0. Frame: γ = 0 is −Z, C0 is +X, C90 is +Y (gonio/base/frame.hpp).
// Evaluation costs two searches (none on even grids) and no allocation; a Web does not change once made and may be read
// by any number of threads.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

// How the stored planes cover the circle.
enum class Symmetry {
    axial,            // one plane for every C
    quadrant,         // planes 0°–90°, mirrored in both axes
    bilateral_0_180,  // planes 0°–180°, mirrored in the C0–C180 plane
    bilateral_90_270, // planes 90°–270°, mirrored in the C90–C270 plane
    none              // planes as they stand
};

const char* to_text(Symmetry symmetry); // "bilateral-0-180": as in reports

// How many images of the stored planes make the circle: 4, 2 or 1.
double image_count(Symmetry stored);

class Web {
public:
    // `candela` is [plane][gamma]. Fails (malformed) unless both angle lists are non-empty, finite and strictly
    // ascending, γ lies in [0°, 180°], the planes lie in the range of `stored` (none: at most 360° wide), and there is
    // one finite candela for each pair.
    static Result<Web> create(Symmetry stored, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                              std::vector<double> candela);

    // Intensity towards (C, γ). Any finite C; γ in [0°, 180°], 0 outside. NaN gives 0.
    double candela(double c_deg, double gamma_deg) const;

    // Intensity along a direction of the light's own frame, of any length > 0.
    double candela(const glm::dvec3& direction) const;

    Symmetry stored_symmetry() const { return stored_; }
    std::span<const double> planes_deg() const { return planes_.angles_deg; }
    std::span<const double> gammas_deg() const { return gammas_.angles_deg; }

    // A stored plane's column of intensities, one per γ.
    std::span<const double> column(std::size_t plane) const {
        return {candela_.data() + plane * gammas_.angles_deg.size(), gammas_.angles_deg.size()};
    }

    // The same light with every intensity multiplied by `factor` ≥ 0.
    Web scaled(double factor) const;

    // C folded by the stored symmetry into the range of the stored planes; the planes may still not reach it.
    double folded_c_deg(double c_deg) const;

private:
    // Strictly ascending angles with the cell of an angle found at once where they are evenly spaced.
    struct Axis {
        std::vector<double> angles_deg;
        double cells_per_deg = 0.0; // 0 when uneven

        explicit Axis(std::vector<double> angles);
        // The cell [i, i+1] that holds the angle and the weight of its upper end; false outside the angles.
        bool locate(double angle_deg, std::size_t& cell, double& weight) const;
    };

    Web(Symmetry stored, Axis planes, Axis gammas, std::vector<double> candela);

    Symmetry stored_;
    Axis planes_;
    Axis gammas_;
    std::vector<double> candela_;
};

} // namespace gonio
