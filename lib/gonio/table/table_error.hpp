// The error of a table's lookups, against quadrature that shares nothing with what filled the table but the BRDF: over
// visible normals on a lattice.
//
// Poses are a golden-ratio lattice over n·v and linear roughness in (0, 1). dfg and kulla-conty: 2¹³ visible normals
// for each, within 3e-5, and 2¹⁴ for Ē, within 6e-5. Lobes: ∫ max(f − lobe, 0) and ∫ max(lobe − f, 0) over the
// hemisphere, in which the greater one is the error under the light for which it is greatest; 3072 directions each,
// within about 0.002.
#pragma once

#include <gonio/table/shading_table.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace gonio {

struct TableError {
    std::size_t poses = 0;
    double median = 0.0;
    double p95 = 0.0; // 95 % of the poses are within it
    double max = 0.0;
};

// A linearly transformed cosine in the frame of LtcLobe: scale · det M⁻¹ · z'/(π |p'|⁴) for p' = M⁻¹ l.
struct TransformedCosine {
    double m00 = 1.0, m02 = 0.0, m11 = 1.0, m20 = 0.0, m22 = 1.0; // of M⁻¹
    double scale = 1.0;
    bool is_clamped = false; // 0 where z' < 0; else negative there
};

// Of a lookup in a table of gonio: scaled so that the lobe above the horizon reflects its albedo; of ltc-heitz as its
// authors define it, so that the clamped lobe in all directions does.
TransformedCosine lobe_of(TableKind kind, const TableValues& values, double n_dot_v, double roughness);

// What tables of a kind are measured against: computed once, in one (dfg) to three seconds of
// a thread.
class TableTruth {
public:
    static constexpr std::size_t usual_poses = 512;

    explicit TableTruth(TableKind kind, std::size_t poses = usual_poses, unsigned threads = 0);

    [[nodiscard]] TableError error_of(const ShadingTable& table) const;

    // Of any other table: of the values of dfg and kulla-conty, and of lobes.
    using Values = std::function<TableValues(double n_dot_v, double roughness)>;
    using Lobes = std::function<TransformedCosine(double n_dot_v, double roughness)>;
    [[nodiscard]] TableError error_of_values(const Values& values) const;
    [[nodiscard]] TableError error_of_lobes(const Lobes& lobes) const;

    // The values at a pose; of lobes only the albedo, as the first.
    [[nodiscard]] std::size_t size() const { return poses_.size(); }
    [[nodiscard]] double n_dot_v(std::size_t pose) const { return poses_[pose].n_dot_v; }
    [[nodiscard]] double roughness(std::size_t pose) const { return poses_[pose].roughness; }
    [[nodiscard]] const TableValues& values(std::size_t pose) const { return poses_[pose].values; }

private:
    struct Direction {
        double x, y, z;
        double weight; // [sr]
        double value;  // f cosθ [1/sr]
    };
    struct Pose {
        double n_dot_v;
        double roughness;
        TableValues values;
        std::vector<Direction> directions; // of lobes
    };

    void integrate(Pose& pose) const;
    void lay_out(Pose& pose) const;

    TableKind kind_;
    unsigned threads_;
    std::vector<Pose> poses_;
};

} // namespace gonio
