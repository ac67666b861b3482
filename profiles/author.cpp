// gonio-author-profiles FOLDER: computes the luminaires of this folder from their formulas (README.md) and writes each
// as IES and as EULUMDAT. The bytes are the same on every run: the committed files are compared with them.
#include <gonio/base/atomic_file.hpp>
#include <gonio/profile/write.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using std::numbers::pi;

constexpr double to_radians = pi / 180.0;

// Exact at the multiples of 90°, where a distribution must be exactly dark.
double cos_deg(double deg) {
    return std::fmod(deg, 180.0) == 90.0 ? 0.0 : std::cos(deg * to_radians);
}
double sin_deg(double deg) {
    return cos_deg(90.0 - deg);
}

struct Luminaire {
    std::string name;
    std::string description;
    std::string lamp;
    std::string color_temperature;
    std::string color_rendering;
    IesVersion version = IesVersion::lm63_2002;
    double flux_lm = 0.0;
    double watts = 0.0;
    int type_indicator = 1;
    int symmetry = 0; // of EULUMDAT: 1 axial, 2 C0–C180, 4 both
    double plane_step_deg = 0.0;
    double gamma_step_deg = 0.0;
    double gamma_end_deg = 90.0;
    std::array<double, 3> ies_opening_m{}; // width, length, height with the sign codes of LM-63-2002
    std::array<double, 3> size_mm{};       // length, width, height
    std::array<double, 3> luminous_mm{};
    std::function<double(double c_deg, double gamma_deg)> shape; // relative intensity
};

// Recessed LED downlight: cosγ [(1 − a) 2^−(γ/15°)² + a cos³γ], a = 0.05: half of the peak near 15°, a soft spill, dark
// from 90° on.
double downlight(double, double gamma_deg) {
    constexpr double spill = 0.05;
    const double cosine = cos_deg(gamma_deg);
    const double beam = std::exp2(-(gamma_deg / 15.0) * (gamma_deg / 15.0));
    return cosine * ((1.0 - spill) * beam + spill * cosine * cosine * cosine);
}

// Wall-washer with the wall towards C0. v is the angle from nadir towards the wall, h the angle out of the plane
// C0–C180: 2^−((v − 35°)/18°)² − (h/32°)² + 0.03, times cosγ and a smooth cut-off from 70° to 90°.
double wall_washer(double c_deg, double gamma_deg) {
    const double towards_wall = sin_deg(gamma_deg) * cos_deg(c_deg);
    const double along_wall = sin_deg(gamma_deg) * sin_deg(c_deg);
    const double v = std::atan2(towards_wall, cos_deg(gamma_deg)) / to_radians;
    const double h = std::asin(along_wall) / to_radians;
    const double x = std::min(1.0, (90.0 - gamma_deg) / 20.0);
    const double cut_off = x * x * (3.0 - 2.0 * x);
    const double beam = std::exp2(-((v - 35.0) / 18.0) * ((v - 35.0) / 18.0) - (h / 32.0) * (h / 32.0));
    return cut_off * cos_deg(gamma_deg) * (beam + 0.03);
}

// T8 tube, its axis along C0: a Lambertian capsule of radius r and length l seen at the angle θ to its axis has the
// projected area 2 r l sinθ + π r².
double bare_tube(double c_deg, double gamma_deg) {
    constexpr double r = 0.013;
    constexpr double l = 1.2;
    const double cosine = sin_deg(gamma_deg) * cos_deg(c_deg);
    return 2.0 * r * l * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) + pi * r * r;
}

std::vector<double> steps(double last, double step) {
    std::vector<double> values;
    const int count = static_cast<int>(std::lround(last / step));
    for (int i = 0; i <= count; ++i)
        values.push_back(step * i);
    return values;
}

// To `digits` significant digits.
double rounded_to(double value, int digits) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1).ptr;
    double result = 0.0;
    std::from_chars(text.data(), end, result);
    return result;
}

struct Table {
    std::vector<double> planes_deg; // stored
    std::vector<double> gammas_deg;
    std::vector<double> values; // [plane][gamma]

    double at(std::size_t plane, std::size_t gamma) const { return values[plane * gammas_deg.size() + gamma]; }

    // The integral over the sphere of the interpolant that is linear in both angles, cell by cell exactly, over the
    // part of it that lies in gamma rows [first, last).
    double flux(std::size_t first, std::size_t last) const {
        double sum = 0.0;
        const std::size_t cells = planes_deg.size() > 1 ? planes_deg.size() - 1 : 1;
        const double width = 2.0 * pi / static_cast<double>(cells); // the planes that symmetry adds are as these
        for (std::size_t p = 0; p < cells; ++p) {
            const std::size_t q = planes_deg.size() > 1 ? p + 1 : p;
            for (std::size_t g = first; g < last; ++g) {
                const double m = 0.5 * (gammas_deg[g] + gammas_deg[g + 1]) * to_radians;
                const double h = 0.5 * (gammas_deg[g + 1] - gammas_deg[g]) * to_radians;
                const double i0 = 0.5 * (at(p, g) + at(q, g));
                const double i1 = 0.5 * (at(p, g + 1) + at(q, g + 1));
                sum += 2.0 * width *
                       (0.5 * (i0 + i1) * std::sin(m) * std::sin(h) +
                        0.5 * (i1 - i0) * std::cos(m) * (std::sin(h) / h - std::cos(h)));
            }
        }
        return sum;
    }
    double flux() const { return flux(0, gammas_deg.size() - 1); }
};

// cd/klm with seven digits, scaled so that the table's flux is 1000 lm.
Table table_of(const Luminaire& luminaire) {
    Table table;
    const double span = luminaire.symmetry == 2 ? 180.0 : 90.0;
    table.planes_deg = luminaire.symmetry == 1 ? std::vector<double>{0.0} : steps(span, luminaire.plane_step_deg);
    table.gammas_deg = steps(luminaire.gamma_end_deg, luminaire.gamma_step_deg);
    for (const double c : table.planes_deg)
        for (const double gamma : table.gammas_deg)
            table.values.push_back(luminaire.shape(c, gamma));
    const double scale = 1000.0 / table.flux();
    for (double& value : table.values)
        value = rounded_to(value * scale, 7);
    return table;
}

// The share of the downward flux that reaches the working plane directly, for luminaires spread evenly over the ceiling
// of a square room of index k = a/2h: a ray that travels (x, y) over the height h stays within the walls from the part
// (1 − |x|/a)(1 − |y|/a) of the ceiling.
std::vector<double> direct_ratios(const Luminaire& luminaire) {
    std::vector<double> ratios;
    for (const double k : {0.60, 0.80, 1.00, 1.25, 1.50, 2.00, 2.50, 3.00, 4.00, 5.00}) {
        double down = 0.0;
        double direct = 0.0;
        for (int g = 0; g < 360; ++g) {
            for (int c = 0; c < 360; ++c) {
                const double gamma = (g + 0.5) / 4.0;
                const double azimuth = c + 0.5;
                const double reach = std::tan(gamma * to_radians) / (2.0 * k); // in units of a
                const double x = std::abs(reach * cos_deg(azimuth));
                const double y = std::abs(reach * sin_deg(azimuth));
                const double light =
                    luminaire.shape(azimuth > 180.0 ? 360.0 - azimuth : azimuth, gamma) * sin_deg(gamma);
                down += light;
                direct += light * std::max(0.0, 1.0 - x) * std::max(0.0, 1.0 - y);
            }
        }
        ratios.push_back(std::round(direct / down * 1e4) / 1e4);
    }
    return ratios;
}

LdtFile ldt_of(const Luminaire& luminaire, const Table& table) {
    LdtFile file;
    file.company = "gonio project";
    file.type_indicator = luminaire.type_indicator;
    file.symmetry = luminaire.symmetry;
    file.planes_deg = luminaire.symmetry == 1 ? std::vector<double>{0.0}
                                              : steps(360.0 - luminaire.plane_step_deg, luminaire.plane_step_deg);
    file.plane_count = static_cast<int>(file.planes_deg.size());
    file.plane_step_deg = luminaire.plane_step_deg;
    file.gammas_deg = table.gammas_deg;
    file.gamma_count = static_cast<int>(file.gammas_deg.size());
    file.gamma_step_deg = luminaire.gamma_step_deg;
    file.report_number = "computed, see README.md";
    file.luminaire_name = luminaire.description;
    file.luminaire_number = luminaire.name;
    file.file_name = luminaire.name.substr(0, 8);
    file.date_user = "2026-11-20 gonio-author-profiles";
    file.length_mm = luminaire.size_mm[0];
    file.width_mm = luminaire.size_mm[1];
    file.height_mm = luminaire.size_mm[2];
    file.luminous_length_mm = luminaire.luminous_mm[0];
    file.luminous_width_mm = luminaire.luminous_mm[1];
    file.luminous_height_c0_mm = file.luminous_height_c90_mm = file.luminous_height_c180_mm =
        file.luminous_height_c270_mm = luminaire.luminous_mm[2];
    std::size_t horizon = 0;
    while (horizon + 1 < table.gammas_deg.size() && table.gammas_deg[horizon] < 90.0)
        ++horizon;
    file.downward_flux_percent = std::round(table.flux(0, horizon) / table.flux() * 1e4) / 1e2;
    file.light_output_ratio_percent = 100.0;
    file.lamp_sets = {{1, luminaire.lamp, luminaire.flux_lm, luminaire.color_temperature, luminaire.color_rendering,
                       luminaire.watts}};
    file.direct_ratios = direct_ratios(luminaire);
    file.candela_per_klm = table.values;
    return file;
}

IesFile ies_of(const Luminaire& luminaire, const Table& table) {
    IesFile file;
    file.version = luminaire.version;
    file.keywords = {{"TEST", "computed, see README.md"},
                     {"TESTLAB", "none"},
                     {"ISSUEDATE", "2026-11-20"},
                     {"MANUFAC", "gonio project"},
                     {"LUMCAT", luminaire.name},
                     {"LUMINAIRE", luminaire.description},
                     {"LAMP", luminaire.lamp},
                     {"OTHER", "written by gonio-author-profiles, Apache-2.0"}};
    file.lumens_per_lamp = luminaire.flux_lm;
    file.width = luminaire.ies_opening_m[0];
    file.length = luminaire.ies_opening_m[1];
    file.height = luminaire.ies_opening_m[2];
    if (file.version == IesVersion::lm63_2019) file.field_12 = 1.0001; // file generation type: computer simulation
    file.input_watts = luminaire.watts;
    file.vertical_deg = table.gammas_deg;
    file.horizontal_deg = table.planes_deg;
    // Seven digits of cd/klm times three of the flux: ten hold the product exactly.
    for (const double per_klm : table.values)
        file.candela.push_back(rounded_to(per_klm * luminaire.flux_lm / 1000.0, 10));
    return file;
}

std::vector<Luminaire> luminaires() {
    std::vector<Luminaire> all(3);
    Luminaire& down = all[0];
    down.name = "downlight";
    down.description = "Recessed LED downlight, 30 degree beam";
    down.lamp = "LED module";
    down.color_temperature = "3000";
    down.color_rendering = "90";
    down.flux_lm = 1200.0;
    down.watts = 12.0;
    down.symmetry = 1;
    down.gamma_step_deg = 1.0;
    down.ies_opening_m = {-0.15, -0.15, 0.0};
    down.size_mm = {180.0, 0.0, 110.0};
    down.luminous_mm = {150.0, 0.0, 0.0};
    down.shape = downlight;

    Luminaire& wash = all[1];
    wash.name = "wall-washer";
    wash.description = "LED wall-washer, the wall towards C0";
    wash.lamp = "LED module";
    wash.color_temperature = "3500";
    wash.color_rendering = "90";
    wash.flux_lm = 2500.0;
    wash.watts = 24.0;
    wash.type_indicator = 3;
    wash.symmetry = 2;
    wash.plane_step_deg = 5.0;
    wash.gamma_step_deg = 2.5;
    wash.ies_opening_m = {0.3, 0.1, 0.0};
    wash.size_mm = {320.0, 120.0, 100.0};
    wash.luminous_mm = {300.0, 100.0, 0.0};
    wash.shape = wall_washer;

    Luminaire& tube = all[2];
    tube.name = "bare-tube";
    tube.description = "Bare T8 fluorescent tube, 1.2 m, axis along C0";
    tube.lamp = "T8 36 W";
    tube.color_temperature = "4000";
    tube.color_rendering = "80";
    tube.version = IesVersion::lm63_2019;
    tube.flux_lm = 3350.0;
    tube.watts = 36.0;
    tube.type_indicator = 2;
    tube.symmetry = 4;
    tube.plane_step_deg = 5.0;
    tube.gamma_step_deg = 2.0;
    tube.gamma_end_deg = 180.0;
    tube.ies_opening_m = {-0.026, 1.226, -0.026};
    tube.size_mm = {1226.0, 26.0, 26.0};
    tube.luminous_mm = {1226.0, 26.0, 26.0};
    tube.shape = bare_tube;
    return all;
}

bool write(const std::string& path, const std::string& bytes) {
    const Result<void> written = write_file(path, bytes);
    if (!written) std::fprintf(stderr, "%s\n", to_text(written.error().diagnostics.back()).c_str());
    return written.has_value();
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: gonio-author-profiles FOLDER\n", stderr);
        return 2;
    }
    const std::string folder = argv[1];
    for (const Luminaire& luminaire : luminaires()) {
        const Table table = table_of(luminaire);
        const std::string path = folder + '/' + luminaire.name;
        if (!write(path + ".ies", write_ies(ies_of(luminaire, table)))) return 3;
        if (!write(path + ".ldt", write_ldt(ldt_of(luminaire, table)))) return 3;
    }
    return 0;
}
