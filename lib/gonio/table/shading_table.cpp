#include <gonio/base/named.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/ibl/split_sum.hpp>
#include <gonio/shading/brdf_kulla_conty.hpp>
#include <gonio/shading/ggx.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/ltc_lobe.hpp>
#include <gonio/table/shading_table.hpp>
#include <gonio/table/texel_fit.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

constexpr std::array dfg_channels{TableChannel{"scale", "A: the factor of F0"},
                                  TableChannel{"bias", "B: the factor of F90"}};
constexpr std::array kulla_conty_channels{
    TableChannel{"albedo", "E: the share that facets which reflect all light give back by a single scattering"},
    TableChannel{"mean_albedo", "the mean of E over uniform light; the same in all columns of a row"}};
constexpr TableChannel along_channel{"along", "of the inverse matrix: along the mirrored direction"};
constexpr TableChannel raised_channel{"raised",
                                      "of the inverse matrix: how the lobe leans away from the mirrored direction"};
constexpr TableChannel across_channel{"across", "of the inverse matrix: across the plane of the view"};
constexpr TableChannel slant_channel{"slant", "of the inverse matrix: its lower left number"};
constexpr TableChannel albedo_channel{"albedo", "what the lobe reflects of uniform light for F = 1"};
constexpr TableChannel grazing_channel{"grazing", "what the lobe reflects of uniform light for F = (1 - l.h)^5"};
// `raised` goes from 1e-9 to 0.9. At grazing views the matrix' first number is little else: in even steps of 1/255 a
// smooth surface would have none of it, or several times too much.
constexpr std::array ltc_ggx_channels{along_channel,  TableChannel{raised_channel.name, raised_channel.says, true},
                                      across_channel, slant_channel,
                                      albedo_channel, grazing_channel};
constexpr std::array ltc_disney_channels{along_channel, raised_channel, across_channel, slant_channel, albedo_channel};
// Of the authors' matrix, (m00 0 m02; 0 1 0; m20 0 m22). Their x is towards the eye.
constexpr std::array ltc_heitz_channels{
    TableChannel{"m00", "of the inverse matrix over its middle number, with x towards the eye: upper left"},
    TableChannel{"m20", "of the same: lower left"},
    TableChannel{"m02", "of the same: upper right"},
    TableChannel{"m22", "of the same: lower right"},
    TableChannel{"magnitude", "what the lobe reflects of uniform light for F = 1"},
    TableChannel{"fresnel", "what the lobe reflects of uniform light for F = (1 - l.h)^5"},
    TableChannel{"zero", "0, as their authors have it", false, false},
    TableChannel{
        "sphere",
        "the form factor above the horizon of a sphere, over its whole form factor, which is row/(height - 1); the "
        "cosine of its direction is 2 column/(width - 1) - 1",
        false, false}};

constexpr std::array both_axes{TableAxes::linear, TableAxes::root};
constexpr std::array root_axes{TableAxes::root};
constexpr std::array heitz_axes{TableAxes::heitz};

constexpr std::string_view value_error = "greatest |lookup - quadrature| of both channels";
constexpr std::string_view lobe_error = "greatest error of the reflected luminance under any uniform light, as a share "
                                        "of what the lobe reflects of uniform "
                                        "light from everywhere, for F = 1";

constexpr std::array infos{
    TableInfo{"dfg", TableKind::dfg, "scale and bias of the split sum: F0 scale + F90 bias", dfg_channels, both_axes,
              32, value_error},
    TableInfo{"kulla-conty", TableKind::kulla_conty, "directional albedo of GGX for F = 1, and its mean",
              kulla_conty_channels, both_axes, 32, value_error},
    TableInfo{"ltc-ggx", TableKind::ltc_ggx, "GGX as a linearly transformed cosine, with two albedos", ltc_ggx_channels,
              root_axes, 32, lobe_error},
    TableInfo{"ltc-disney", TableKind::ltc_disney, "the renormalised Disney diffuse as a linearly transformed cosine",
              ltc_disney_channels, root_axes, 32, lobe_error},
    TableInfo{"ltc-heitz", TableKind::ltc_heitz,
              "the lobe of ltc-ggx as LTC_1 and LTC_2 of Heitz and others (2016) and three.js", ltc_heitz_channels,
              heitz_axes, 64, lobe_error},
};
static_assert(in_enum_order(infos, &TableInfo::kind, TableKind::ltc_heitz));

// At n·v = 0 the integrals are those of their limit.
constexpr double least_n_dot_v = 1e-6;
// With the matrix as such, which is singular there, the last row is slightly above; and m00 is a normal half.
constexpr double least_n_dot_v_of_matrix = 1e-4;
constexpr double least_m00 = 0x1p-14;

// The four numbers of the matrix, and the albedo.
std::array<double, 5> numbers_of(const shading::LtcEntry& e) {
    return {static_cast<double>(e.along), static_cast<double>(e.raised), static_cast<double>(e.across),
            static_cast<double>(e.slant), static_cast<double>(e.albedo)};
}

// The weights of four neighbours about a place between the middle two: E. Catmull and R. Rom, "A class of local
// interpolating splines", 1974.
std::array<double, 4> cubic_weights(double t) {
    return {0.5 * t * (t * (2.0 - t) - 1.0), 0.5 * (t * t * (3.0 * t - 5.0) + 2.0),
            0.5 * t * (t * (4.0 - 3.0 * t) + 1.0), 0.5 * t * t * (t - 1.0)};
}

// The fitted entries at √(n·v) = y and roughness x, both in [0, 1]. Beyond the outermost entries their neighbours are
// continued in a straight line.
std::array<double, 5> fitted(const shading::LtcEntry* table, std::size_t size, double x, double y) {
    const auto last = static_cast<double>(size - 1);
    const auto place = [&](double at) { return std::min(static_cast<std::size_t>(at * last), size - 2); };
    const std::size_t column = place(x);
    const std::size_t row = place(y);
    const std::array across = cubic_weights(x * last - static_cast<double>(column));
    const std::array down = cubic_weights(y * last - static_cast<double>(row));
    const auto in_line = [size](std::size_t first, std::size_t k, const auto& at) {
        using Numbers = decltype(at(first));
        const auto beyond = [](const Numbers& edge, const Numbers& inner) {
            Numbers made{};
            for (std::size_t f = 0; f < made.size(); ++f)
                made[f] = 2.0 * edge[f] - inner[f];
            return made;
        };
        if (k == 0 && first == 0) return beyond(at(0), at(1));
        if (first + k > size) return beyond(at(size - 1), at(size - 2));
        return at(first + k - 1);
    };
    std::array<double, 5> sum{};
    for (std::size_t j = 0; j < 4; ++j) {
        const auto of_row = [&](std::size_t r) {
            std::array<double, 5> line{};
            for (std::size_t i = 0; i < 4; ++i) {
                const std::array found =
                    in_line(column, i, [&](std::size_t c) { return numbers_of(table[r * size + c]); });
                for (std::size_t f = 0; f < line.size(); ++f)
                    line[f] += across[i] * found[f];
            }
            return line;
        };
        const std::array line = in_line(row, j, of_row);
        for (std::size_t f = 0; f < sum.size(); ++f)
            sum[f] += down[j] * line[f];
    }
    return sum;
}

// The form factor, above the horizon, of a sphere whose direction has this cosine and whose whole form factor is
// `whole`, in [0, 1], as a share of the latter.
double cut_sphere(double cosine, double whole) {
    const double sine = std::sqrt(whole); // of its angular radius
    if (std::fabs(cosine) >= sine) return std::max(cosine, 0.0);
    return shading::irradiance_straddling_cap(sine, std::sqrt(1.0 - whole), cosine) / (std::numbers::pi * whole);
}

// Of one axis, in [0, 1]: the place of a texel or of a node of the polynomial.
double place_of(TableForm form, int index, int count) {
    if (form == TableForm::chebyshev) return 0.5 - 0.5 * std::cos(std::numbers::pi * (index + 0.5) / count);
    return static_cast<double>(index) / (count - 1);
}

// Replaces values at the nodes of Chebyshev's polynomials by coefficients, along one axis of `count` steps of `stride`.
void to_coefficients(std::vector<double>& values, std::size_t count, std::size_t stride, std::size_t first) {
    std::vector<double> found(count);
    for (std::size_t k = 0; k < count; ++k) {
        double sum = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            // T_k at the node: cos(k(π − π(i + ½)/count)), for ascending nodes
            const double turn =
                std::numbers::pi * (static_cast<double>(count - 1 - i) + 0.5) / static_cast<double>(count);
            sum += values[first + i * stride] * std::cos(static_cast<double>(k) * turn);
        }
        found[k] = sum * (k == 0 ? 1.0 : 2.0) / static_cast<double>(count);
    }
    for (std::size_t k = 0; k < count; ++k)
        values[first + k * stride] = found[k];
}

// Where a pose is on the axes of columns and of rows, in [0, 1].
std::array<double, 2> coordinates(TableAxes axes, double mu, double roughness) {
    if (axes == TableAxes::heitz) return {roughness, std::sqrt(1.0 - mu)};
    return {axes == TableAxes::linear ? mu : std::sqrt(mu), roughness};
}

struct Pose {
    double mu;
    double roughness;
};
Pose pose_at(TableAxes axes, double x, double y) {
    if (axes == TableAxes::heitz) return {1.0 - y * y, x};
    return {axes == TableAxes::linear ? x : x * x, y};
}

// dfg and kulla-conty: the texels whose lookups are nearest. Clipped to [0, 1], since all of these are shares of light.
void fit_texels(ShadingTable& table, unsigned threads) {
    constexpr std::size_t count = 2;
    const auto columns = static_cast<std::size_t>(table.width);
    const auto rows = static_cast<std::size_t>(table.height);
    const std::vector<FitPlace> across = fit_places(table.axes, table.width);
    const std::vector<FitPlace> down = fit_places(table.axes, table.height);
    // By channel, column and place of roughness.
    std::vector<double> lines(count * columns * down.size());
    parallel_for(down.size(), threads, [&](std::size_t j) {
        const double roughness = down[j].at;
        std::array<std::vector<double>, count> values{};
        for (const FitPlace& place : across) {
            const double mu = pose_at(table.axes, place.at, roughness).mu;
            const SplitSum sum = split_sum(std::max(mu, least_n_dot_v), roughness);
            values[0].push_back(table.kind == TableKind::dfg ? sum.scale : sum.albedo());
            values[1].push_back(sum.bias);
        }
        // The mean is the same in the whole row.
        const double mean = table.kind == TableKind::kulla_conty ? mean_albedo(roughness) : 0.0;
        for (std::size_t c = 0; c < count; ++c) {
            const std::vector<double> texels = c == 1 && table.kind == TableKind::kulla_conty
                                                   ? std::vector<double>(columns, mean)
                                                   : fitted_texels(table.axes, table.width, across, values[c]);
            for (std::size_t column = 0; column < columns; ++column)
                lines[(c * columns + column) * down.size() + j] = texels[column];
        }
    });
    table.values.resize(columns * rows * count);
    for (std::size_t c = 0; c < count; ++c)
        for (std::size_t column = 0; column < columns; ++column) {
            const std::vector<double> texels =
                fitted_texels(table.axes, table.height, down,
                              std::span(lines).subspan((c * columns + column) * down.size(), down.size()));
            for (std::size_t row = 0; row < rows; ++row)
                table.values[(row * columns + column) * count + c] =
                    static_cast<float>(std::clamp(texels[row], 0.0, 1.0));
        }
}

} // namespace

std::span<const TableInfo> table_infos() {
    return infos;
}

const TableInfo& info_of(TableKind kind) {
    return infos.at(static_cast<std::size_t>(kind));
}

std::string_view to_text(TableAxes axes) {
    switch (axes) {
    case TableAxes::linear:
        return "linear";
    case TableAxes::root:
        return "root";
    case TableAxes::heitz:
        break;
    }
    return "heitz";
}

std::string_view to_text(TableForm form) {
    return form == TableForm::bilinear ? "bilinear" : "chebyshev";
}

TableValues table_values(TableKind kind, double n_dot_v, double roughness) {
    const double mu = std::clamp(n_dot_v, least_n_dot_v, 1.0);
    const double r = std::clamp(roughness, 0.0, 1.0);
    switch (kind) {
    case TableKind::dfg: {
        const SplitSum sum = split_sum(mu, r);
        return {sum.scale, sum.bias};
    }
    case TableKind::kulla_conty:
        return {split_sum(mu, r).albedo(), mean_albedo(r)};
    case TableKind::ltc_ggx: {
        const auto [along, raised, across, slant, albedo] =
            fitted(&shading::ltc_ggx_table[0], shading::ltc_ggx_size, r, std::sqrt(mu));
        const SplitSum sum = split_sum(mu, r);
        return {along, raised, across, slant, sum.albedo(), sum.bias};
    }
    case TableKind::ltc_disney: {
        const auto [along, raised, across, slant, albedo] =
            fitted(&shading::ltc_diffuse_table[0], shading::ltc_diffuse_size, r, std::sqrt(mu));
        return {along, raised, across, slant, albedo};
    }
    case TableKind::ltc_heitz: {
        const double seen = std::max(mu, least_n_dot_v_of_matrix);
        const TableValues of = table_values(TableKind::ltc_ggx, seen, r);
        const auto lobe =
            shading::detail::lobe_from(of[0], of[1], of[2], of[3], of[4], of[5],
                                       std::max(r * r, shading::minimum_alpha), seen, shading::sine_of_cosine(seen));
        return {std::max(lobe.m00 / lobe.m11, least_m00),
                -lobe.m20 / lobe.m11,
                -lobe.m02 / lobe.m11,
                lobe.m22 / lobe.m11,
                of[4],
                of[5],
                0.0,
                cut_sphere(2.0 * r - 1.0, std::sqrt(1.0 - std::clamp(n_dot_v, 0.0, 1.0)))};
    }
    }
    return {};
}

TableValues ShadingTable::lookup(double n_dot_v, double roughness) const {
    const double mu = std::clamp(n_dot_v, 0.0, 1.0);
    const double r = std::clamp(roughness, 0.0, 1.0);
    const auto [x, y] = coordinates(axes, mu, r);
    const std::size_t count = channels();
    const auto columns = static_cast<std::size_t>(width);
    const auto rows = static_cast<std::size_t>(height);
    TableValues result{};
    if (form == TableForm::chebyshev) {
        std::vector<double> line(columns);
        std::vector<double> sums(rows);
        for (std::size_t c = 0; c < count; ++c) {
            for (std::size_t j = 0; j < rows; ++j) {
                for (std::size_t i = 0; i < columns; ++i)
                    line[i] = static_cast<double>(values[(j * columns + i) * count + c]);
                sums[j] = shading::detail::chebyshev_series(line.data(), columns, 2.0 * x - 1.0);
            }
            result[c] = shading::detail::chebyshev_series(sums.data(), rows, 2.0 * y - 1.0);
        }
        return result;
    }
    const Between across = between(axes, x, width);
    const Between down = between(axes, y, height);
    for (std::size_t c = 0; c < count; ++c) {
        const auto at = [&](std::size_t column, std::size_t row) {
            return static_cast<double>(values[(row * columns + column) * count + c]);
        };
        const auto in_row = [&](std::size_t row) {
            return (1.0 - across.share) * at(across.first, row) + across.share * at(across.second, row);
        };
        const double found = (1.0 - down.share) * in_row(down.first) + down.share * in_row(down.second);
        result[c] = holds_root(c) ? found * found : found;
    }
    return result;
}

Result<ShadingTable> make_shading_table(TableKind kind, TableForm form, TableAxes axes, int width, int height,
                                        unsigned threads) {
    if (std::min(width, height) < least_table_size || std::max(width, height) > most_table_size)
        return fail("USE0106",
                    fmt::format("a {} {} to {} {} a side, not {} x {}",
                                form == TableForm::bilinear ? "table has" : "polynomial has", least_table_size,
                                most_table_size, form == TableForm::bilinear ? "texels" : "terms", width, height),
                    form == TableForm::bilinear ? "for example 16x16" : "for example 10x10");
    const TableInfo& info = info_of(kind);
    if (form == TableForm::chebyshev && !info.has_polynomials())
        return fail("USE0107", fmt::format("{} has no polynomial", info.name),
                    "there are polynomials of dfg, kulla-conty and ltc-disney");
    const bool has_axes = std::find(info.axes.begin(), info.axes.end(), axes) != info.axes.end();
    if (!has_axes || (axes == TableAxes::linear && form == TableForm::chebyshev))
        return fail(
            "USE0107",
            fmt::format("{} has no {} axes", has_axes ? std::string_view("a polynomial") : info.name, to_text(axes)),
            has_axes ? "use --axes root; dfg and kulla-conty have linear axes in the form bilinear"
                     : fmt::format("use --axes {}; 'gonio list tables' shows those of each table",
                                   to_text(info.axes.front())));
    ShadingTable table{kind, axes, form, width, height, {}};
    if (form == TableForm::bilinear && !info.is_lobe()) {
        fit_texels(table, threads);
        return table;
    }
    const std::size_t count = table.channels();
    const auto columns = static_cast<std::size_t>(width);
    const auto rows = static_cast<std::size_t>(height);
    std::vector<double> values(columns * rows * count);
    parallel_for(rows, threads, [&](std::size_t row) {
        const double y = place_of(form, static_cast<int>(row), height);
        for (std::size_t column = 0; column < columns; ++column) {
            const auto [mu, roughness] = pose_at(axes, place_of(form, static_cast<int>(column), width), y);
            // The mean is the same in the whole row, and takes as long as 24 of its texels.
            if (kind == TableKind::kulla_conty && column > 0) {
                values[(row * columns + column) * count] = split_sum(std::max(mu, least_n_dot_v), roughness).albedo();
                values[(row * columns + column) * count + 1] = values[row * columns * count + 1];
                continue;
            }
            const TableValues found = table_values(kind, mu, roughness);
            std::copy_n(found.begin(), count,
                        values.begin() + static_cast<std::ptrdiff_t>((row * columns + column) * count));
        }
    });
    if (form == TableForm::chebyshev)
        for (std::size_t c = 0; c < count; ++c) {
            for (std::size_t row = 0; row < rows; ++row)
                to_coefficients(values, columns, count, row * columns * count + c);
            for (std::size_t column = 0; column < columns; ++column)
                to_coefficients(values, rows, columns * count, column * count + c);
        }
    table.values.reserve(values.size());
    for (const double value : values)
        table.values.push_back(static_cast<float>(value));
    return table;
}

} // namespace gonio
