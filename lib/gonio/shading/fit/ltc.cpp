// Prints lib/gonio/shading/ltc_table.cpp: the lobes of GGX and of the renormalised Disney diffuse as linearly
// transformed cosines (E. Heitz, J. Dupuy, S. Hill, D. Neubelt, "Real-Time Polygonal-Light Shading with Linearly
// Transformed Cosines", ACM Transactions on Graphics 35(4), 2016), in about half a minute.
//
//     gonio-ltc-fit > lib/gonio/shading/ltc_table.cpp      the source
//     gonio-ltc-fit --check                                exit status 0 if the table still matches the fit
//
// The target is f cosθ over the upper hemisphere. The fit minimises ∫ (f cosθ − lobe)²/(f cosθ + |lobe|) dω, which
// gives weight to a lobe's tail, where small lights are, as well as to its peak. The lobe's own sign is kept: below the
// plane z' = 0 of the transformed space it is negative. Its mass above the horizon equals the albedo of the BRDF, which
// is integrated separately. Four entries of the inverse matrix are free. They are found by simplex searches (J. A.
// Nelder, R. Mead, The Computer Journal 7, 1965) that start from the neighbours in the table. The table stores the
// matrix rotated to the mirrored direction and divided by 1/α: this varies slowly, so a table of 32 × 32 is enough down
// to α = 1e-4.
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/ltc_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace {

using namespace gonio::shading;
using Vec = vec3<double>;
using Parameters = std::array<double, 4>;

constexpr double pi = std::numbers::pi;

// A reflection at one roughness and view; the eye is in the plane y = 0 on the side of −x.
struct Reflection {
    bool specular;
    double roughness; // α for GGX, linear roughness for the diffuse part
    double mu;        // n·v
    double s;         // sine of the same angle

    [[nodiscard]] Vec view() const { return {-s, 0.0, mu}; }
    // f cosθ [1/sr], l above the horizon.
    [[nodiscard]] double value(Vec l) const {
        if (specular) return specular_ggx<double>({0, 0, 1}, l, view(), roughness, roughness).scale * l.z;
        return diffuse_frostbite(l.z, mu, dot(l, view()), roughness) * l.z;
    }
    // The factor that the table applies to the matrix' first two rows.
    [[nodiscard]] double width() const { return specular ? roughness : 1.0; }
};

Reflection reflection(bool specular, double roughness, double mu) {
    return {specular, roughness, mu, std::sqrt((1.0 - mu) * (1.0 + mu))};
}

struct Node {
    Vec toward;
    double weight; // [sr]
    double value;
    double schlick;
};

// Directions above the horizon by the balance heuristic (E. Veach, 1997) of up to three densities: GGX half vectors of
// α and of 3α, and four times as many that are uniform in √z, since the lobe changes sign near the horizon. `count`
// points of a golden-ratio lattice each.
std::vector<Node> nodes(const Reflection& r, int count, bool half_sphere) {
    const Vec v = r.view();
    std::vector<double> widths;
    if (r.specular) widths = {r.roughness, std::min(1.0, 3.0 * r.roughness)};
    const auto density = [&](Vec l) {
        const Vec h = normalized(l + v);
        const Vec across = cross(Vec{0, 0, 1}, h);
        double sum = 1.0 / (pi * std::sqrt(l.z));
        for (const double a : widths)
            sum += distribution_ggx(h.z, dot(across, across), a, a) * h.z / (4.0 * dot(v, h));
        return sum;
    };
    std::vector<Node> made;
    for (std::size_t k = 0; k <= widths.size(); ++k)
        for (int i = 0, all = k < widths.size() ? count : 4 * count; i < all; ++i) {
            const double u = (i + 0.5) / all;
            const double phi = (half_sphere ? 1.0 : 2.0) * pi * std::fmod(0.5 + i * 0.61803398874989485, 1.0);
            const double sine = std::sqrt((1.0 - u * u) * (1.0 + u * u));
            Vec l{sine * std::cos(phi), sine * std::sin(phi), u * u};
            if (k < widths.size()) {
                const double t = widths[k] * std::sqrt(u / (1.0 - u));
                const Vec h = normalized(Vec{t * std::cos(phi), t * std::sin(phi), 1.0});
                if (dot(v, h) <= 0.0) continue;
                l = h * (2.0 * dot(v, h)) - v;
            }
            if (l.z <= 1e-12) continue;
            made.push_back({l, 1.0 / (count * density(l)), r.value(l), schlick_weight(dot(l, normalized(l + v)))});
        }
    return made;
}

// z' of the direction at the angle `peak` from the normal.
double height(double peak, double m20) {
    return std::cos(peak) + m20 * std::sin(peak);
}

// A lobe as stored in the table, from its free parameters: the angle of the peak from the normal, m20, and the
// logarithms of the first row's length and of m11, both as they would be with z' = 1 at the peak: a narrow lobe then
// hardly depends on m20.
LtcEntry entry(const Reflection& r, const Parameters& p) {
    const double peak = p[1];
    const double up = height(peak, p[3]);
    const double long_axis = std::exp(p[0]) * up;
    const double tilt = std::atan2(r.s, r.mu) - peak;
    LtcEntry e{};
    e.along = static_cast<float>(long_axis * std::cos(tilt));
    e.raised = static_cast<float>(long_axis * std::sin(tilt) / r.s);
    e.across = static_cast<float>(std::exp(p[2]) * up);
    e.slant = static_cast<float>(p[3] / r.s);
    return e;
}

Parameters parameters(const Reflection& r, const LtcEntry& e) {
    const auto along = static_cast<double>(e.along);
    const double raised = static_cast<double>(e.raised) * r.s;
    const double peak = std::atan2(r.s, r.mu) - std::atan2(raised, along);
    const double slant = static_cast<double>(e.slant) * r.s;
    const double up = height(peak, slant);
    return {std::log(std::hypot(along, raised) / up), peak, std::log(static_cast<double>(e.across) / up), slant};
}

double objective(const Reflection& r, const std::vector<Node>& nodes, double albedo, const Parameters& p) {
    const double up = height(p[1], p[3]);
    if (std::fabs(p[1]) > 1.65 || std::fabs(p[3]) > 4.0 || up <= 1e-3) return HUGE_VAL;
    const double length = std::exp(p[0]) * up / r.width();
    const double m00 = length * std::cos(p[1]);
    const double m02 = -length * std::sin(p[1]);
    const double m11 = std::exp(p[2]) * up / r.width();
    const double m20 = p[3];
    const double determinant = m11 * (m00 - m02 * m20);
    if (m00 <= 0.0 || determinant <= 0.0) return HUGE_VAL;
    const double scale = albedo * determinant / (pi * m00 / std::hypot(m00, m20));
    double sum = 0.0;
    for (const Node& n : nodes) {
        const double x = m00 * n.toward.x + m02 * n.toward.z;
        const double y = m11 * n.toward.y;
        const double z = m20 * n.toward.x + n.toward.z;
        const double square = x * x + y * y + z * z;
        const double lobe = scale * z / (square * square);
        const double off = n.value - lobe;
        sum += n.weight * off * off / (n.value + std::fabs(lobe) + 1e-300);
    }
    return sum;
}

struct Found {
    Parameters at;
    double objective;
};

Found simplex(const std::function<double(const Parameters&)>& f, Parameters start, const Parameters& step) {
    constexpr std::size_t n = 4;
    std::array<Found, n + 1> x;
    for (std::size_t i = 0; i <= n; ++i) {
        x[i].at = start;
        if (i > 0) x[i].at[i - 1] += step[i - 1];
        x[i].objective = f(x[i].at);
    }
    const auto lower = [](const Found& a, const Found& b) { return a.objective < b.objective; };
    for (int iteration = 0; iteration < 400; ++iteration) {
        std::sort(x.begin(), x.end(), lower);
        if (x[n].objective - x[0].objective <= 1e-8 * x[0].objective) break;
        const auto at = [&](double t) {
            Found moved{};
            for (std::size_t k = 0; k < n; ++k) {
                double middle = 0.0;
                for (std::size_t i = 0; i < n; ++i)
                    middle += x[i].at[k] / n;
                moved.at[k] = middle + t * (x[n].at[k] - middle);
            }
            moved.objective = f(moved.at);
            return moved;
        };
        const Found mirrored = at(-1.0);
        if (mirrored.objective < x[0].objective) {
            const Found farther = at(-2.0);
            x[n] = lower(farther, mirrored) ? farther : mirrored;
        } else if (mirrored.objective < x[n - 1].objective) {
            x[n] = mirrored;
        } else {
            const Found nearer = at(mirrored.objective < x[n].objective ? -0.5 : 0.5);
            if (lower(nearer, x[n]) && lower(nearer, mirrored)) {
                x[n] = nearer;
            } else {
                for (std::size_t i = 1; i <= n; ++i) {
                    for (std::size_t k = 0; k < n; ++k)
                        x[i].at[k] = 0.5 * (x[i].at[k] + x[0].at[k]);
                    x[i].objective = f(x[i].at);
                }
            }
        }
    }
    return *std::min_element(x.begin(), x.end(), lower);
}

struct Problem {
    Reflection reflection;
    std::vector<Node> nodes;
    double albedo = 0.0;  // of F = 1
    double grazing = 0.0; // of F = (1 − l·h)⁵

    Problem(const Reflection& r, int count) : reflection(r), nodes(::nodes(r, count, true)) {
        for (const Node& n : ::nodes(r, 40000, false)) {
            albedo += n.weight * n.value;
            grazing += n.weight * n.value * n.schlick;
        }
    }
    [[nodiscard]] double objective(const Parameters& p) const { return ::objective(reflection, nodes, albedo, p); }
    [[nodiscard]] Found solve(Found best, const Parameters& start) const {
        const auto f = [this](const Parameters& p) { return objective(p); };
        Found found = simplex(f, start, {0.1, 0.05 * reflection.roughness, 0.1, 0.2});
        found = simplex(f, found.at, {-0.1, 0.05 * reflection.roughness, -0.1, -0.1});
        found = simplex(f, found.at, {0.03, -0.02 * reflection.roughness, 0.03, 0.2});
        return found.objective < best.objective ? found : best;
    }
};

constexpr int fit_points = 500;

// The reflection at a place of the table; the ends of both axes are moved slightly inwards.
Reflection at_place(bool specular, std::size_t size, std::size_t row, std::size_t column) {
    const double x = static_cast<double>(column) / static_cast<double>(size - 1);
    const double y = static_cast<double>(row) / static_cast<double>(size - 1);
    const double mu = std::clamp(y * y, 1e-4, 1.0 - 1e-5);
    return reflection(specular, specular ? std::max(x * x, minimum_alpha) : x, mu);
}

std::vector<LtcEntry> fit(bool specular, std::size_t size) {
    std::vector<LtcEntry> table(size * size);
    for (std::size_t row = size; row-- > 0;)
        for (std::size_t column = size; column-- > 0;) {
            const Reflection r = at_place(specular, size, row, column);
            const Problem problem(r, fit_points);
            Found best{{}, HUGE_VAL};
            if (column + 1 < size) best = problem.solve(best, parameters(r, table[row * size + column + 1]));
            if (row + 1 < size) best = problem.solve(best, parameters(r, table[(row + 1) * size + column]));
            if (best.objective == HUGE_VAL) best = problem.solve(best, {0.0, 0.1 * std::atan2(r.s, r.mu), 0.0, 0.0});
            LtcEntry& e = table[row * size + column];
            e = entry(r, best.at);
            e.albedo = static_cast<float>(problem.albedo);
            e.grazing = static_cast<float>(problem.grazing);
        }
    return table;
}

void print(const char* name, const char* size, const std::vector<LtcEntry>& table) {
    (void)std::printf("\nconst std::array<LtcEntry, %s * %s> %s{{\n", size, size, name);
    for (const LtcEntry& e : table)
        (void)std::printf("    {%.5eF, %.5eF, %.5eF, %.5eF, %.5eF, %.5eF},\n", static_cast<double>(e.along),
                          static_cast<double>(e.raised), static_cast<double>(e.across), static_cast<double>(e.slant),
                          static_cast<double>(e.albedo), static_cast<double>(e.grazing));
    (void)std::printf("}};\n");
}

// Checks some places of the library's table: the albedo as integrated now, and an optimum that a new search cannot
// improve.
bool check(bool specular, std::size_t size, const LtcEntry* table) {
    bool same = true;
    for (const double y : {0.0, 0.3, 0.6, 1.0})
        for (const double x : {0.0, 0.25, 0.55, 1.0}) {
            const auto place = [&](double t) { return static_cast<std::size_t>(t * static_cast<double>(size - 1)); };
            const LtcEntry& e = table[place(y) * size + place(x)];
            const Reflection r = at_place(specular, size, place(y), place(x));
            const Problem problem(r, fit_points);
            const Parameters stored = parameters(r, e);
            const double had = problem.objective(stored);
            const Found found = problem.solve({stored, had}, stored);
            const double gain = (had - found.objective) / (problem.albedo + 1e-3);
            const double off = std::fabs(static_cast<double>(e.albedo) - problem.albedo) +
                               std::fabs(static_cast<double>(e.grazing) - problem.grazing);
            if (gain < 2e-4 && off < 2e-5) continue;
            same = false;
            (void)std::fprintf(stderr, "%s, roughness %g, n·v %g: the fit gains %g, the albedo differs by %g\n",
                               specular ? "GGX" : "diffuse", r.roughness, r.mu, gain, off);
        }
    return same;
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "--check") == 0) {
        const bool specular = check(true, ltc_ggx_size, ltc_ggx_table.data());
        const bool diffuse = check(false, ltc_diffuse_size, ltc_diffuse_table.data());
        return specular && diffuse ? 0 : 1;
    }
    (void)std::printf("// Printed by fit/ltc.cpp; by hand only what that program prints then too.\n"
                      "#include <gonio/shading/ltc_table.hpp>\n\nnamespace gonio::shading {\n");
    print("ltc_ggx_table", "ltc_ggx_size", fit(true, ltc_ggx_size));
    print("ltc_diffuse_table", "ltc_diffuse_size", fit(false, ltc_diffuse_size));
    (void)std::printf("\n} // namespace gonio::shading\n");
    return 0;
}
