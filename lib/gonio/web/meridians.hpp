// Integrals of a web along its own meridians, which turn its flux through any outline into a line integral.
//
// Every goniometer has a polar axis: γ counts from the nadir for type C, the latitude + 90° from −Y for type A and from
// −X for type B. With the azimuth α and the polar angle θ of that axis, dω = sinθ dθ dα, and by Green's theorem the
// flux through an outline is ∮ G(α, θ) dα with G = ∫₀^θ I(α, θ') sinθ' dθ'. Between the breaks, at which the
// interpolant bends or ends, I is linear in α and in θ, so G has a closed form and is smooth.
#pragma once

#include <gonio/web/web.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

class Meridians {
public:
    explicit Meridians(const Web& web);

    // (a, b, c) of a direction of the light's frame: α = atan2(b, a), and c is along the pole of θ = 0.
    [[nodiscard]] glm::dvec3 local(const glm::dvec3& direction) const {
        return {glm::dot(direction, azimuth_0_), glm::dot(direction, azimuth_90_), glm::dot(direction, pole_)};
    }
    [[nodiscard]] glm::dvec3 pole() const { return pole_; } // θ = 0, in the light's frame

    // Ascending, in radians: α within one turn, θ within [0, π].
    [[nodiscard]] std::span<const double> azimuth_breaks() const { return azimuths_; }
    [[nodiscard]] std::span<const double> polar_breaks() const { return polars_; }
    [[nodiscard]] std::span<const double> polar_break_cosines() const { return cosines_; }

    // The position of an angle among the breaks: the sector (which wraps around), and the number of polar breaks at or
    // below θ.
    [[nodiscard]] std::size_t sector_of(double azimuth) const;
    [[nodiscard]] std::size_t cell_of(double polar) const;

    // ∫₀^θ and −∫_θ^π of I sinθ' dθ' [cd], continued linearly in α from the sector. `cell` is cell_of(polar).
    struct Integral {
        double to_here = 0.0;
        double beyond = 0.0; // exactly 0 beyond the last light
    };
    [[nodiscard]] Integral integral(std::size_t sector, double azimuth, std::size_t cell, double polar,
                                    double cos_polar, double sin_polar) const;

    // I(θ) = intensity + slope·(θ − θⱼ) from the break j on, at one end of a sector; `constant` is G without the terms
    // in θ: G(θ) = constant − I(θ) cosθ + slope·sinθ.
    struct Piece {
        double intensity = 0.0;
        double slope = 0.0;
        double constant = 0.0;
    };

    // One cell of one sector, for callers that evaluate many points in it.
    struct Patch {
        double azimuth_begin = 0.0;
        double azimuth_width = 0.0;
        double polar_begin = 0.0;
        Piece low; // at the sector's two ends
        Piece high;
        double low_total = 0.0; // G at θ = π
        double high_total = 0.0;
    };
    [[nodiscard]] Patch patch(std::size_t sector, std::size_t cell) const;

    // Where there may be light: θ outside [from, to] is dark for every α.
    [[nodiscard]] double lit_polar_from() const { return lit_polar_from_; }
    [[nodiscard]] double lit_polar_to() const { return lit_polar_to_; }
    // The widest arc of α without light at any θ; of width 0 if there is none.
    [[nodiscard]] double dark_azimuth_begin() const { return dark_azimuth_begin_; }
    [[nodiscard]] double dark_azimuth_width() const { return dark_azimuth_width_; }

private:
    // Adds the pieces of one end of a sector, one for each number of breaks passed.
    void add_end(std::span<const double> candela);
    void find_darkness(std::span<const char> lit_polars, std::span<const char> lit_sectors);

    glm::dvec3 azimuth_0_{1.0, 0.0, 0.0};
    glm::dvec3 azimuth_90_{0.0, 1.0, 0.0};
    glm::dvec3 pole_{0.0, 0.0, -1.0};
    std::vector<double> azimuths_;
    std::vector<double> polars_;
    std::vector<double> cosines_;
    std::vector<Piece> pieces_; // [sector][end][cell]
    double lit_polar_from_ = 0.0;
    double lit_polar_to_ = 0.0;
    double dark_azimuth_begin_ = 0.0;
    double dark_azimuth_width_ = 0.0;
};

} // namespace gonio
