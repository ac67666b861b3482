// Textures of a luminaire: the layouts, and the plain look-up table that other programs bake, compared by flux and by
// the difference from the web in any direction when the texture is filtered as a renderer filters it.
#include <gonio/bake/bake.hpp>
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/suites/suites.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio::measure::detail {

namespace {

// All have about the same number of texels: this number if quick, otherwise sixteen times as many.
struct Subject {
    const char* name;
    std::optional<Layout> layout; // empty: the web's value at the centre of each texel of a latlong texture
    int width;
    int height;
};

constexpr std::array subjects{Subject{"lookup", std::nullopt, 64, 32},
                              Subject{"latlong", Layout::latlong, 64, 32},
                              Subject{"octahedral", Layout::octahedral, 45, 45},
                              Subject{"octahedral-equal-area", Layout::octahedral_equal_area, 45, 45},
                              Subject{"cube-strip", Layout::cube_strip, 108, 18},
                              Subject{"panorama", Layout::panorama, 64, 32}};

constexpr std::array codes{std::pair{"float", TexelType::float32}, std::pair{"half", TexelType::half}};

struct Baked {
    Image image;
    std::vector<PlacedChart> charts;
    double cd_per_unit = 1.0;
    double flux_lm = 0.0;
};

Baked look_up(const Web& web, int width, int height) {
    Baked baked{Image(width, height, 1), charts_of(Layout::latlong, width, height, {}).value(), 1.0, 0.0};
    for (int j = 0; j < height; ++j) {
        const double top = std::numbers::pi * j / height;
        const double bottom = std::numbers::pi * (j + 1) / height;
        const double solid_angle = 2.0 * std::numbers::pi / width * (std::cos(top) - std::cos(bottom));
        for (int i = 0; i < width; ++i) {
            const double cd = web.candela((i + 0.5) / width * 360.0, (j + 0.5) / height * 180.0);
            *baked.image.at(i, j) = static_cast<float>(cd);
            baked.flux_lm += solid_angle * cd;
        }
    }
    return baked;
}

Baked bake(const Web& web, const Subject& subject, int times, TexelType type) {
    const int width = subject.width * times;
    const int height = subject.height * times;
    if (!subject.layout) return look_up(web, width, height);
    BakeOptions options;
    options.layout = *subject.layout;
    options.width = width;
    options.height = height;
    options.texel_type = type;
    options.threads = 1;
    options.skip = false; // does the work for each texel, whatever the web's symmetry
    Texture texture = bake_texture(web, options).value();
    return {std::move(texture.image), charts_of(*subject.layout, width, height, {}).value(), texture.cd_per_unit,
            texture.texture_flux.value};
}

// Bilinear between texel centres within one chart; wraps around where the chart does, clamps at its edges elsewhere.
double sample(const Baked& baked, const glm::dvec3& direction) {
    for (const PlacedChart& placed : baked.charts) {
        const std::optional<glm::dvec2> at = placed.chart->locate(direction);
        if (!at) continue;
        const double x = at->x * placed.width - 0.5;
        const double y = std::clamp(at->y * placed.height - 0.5, 0.0, placed.height - 1.0);
        const double left = std::floor(x);
        const double top = std::min(std::floor(y), placed.height - 1.0);
        const auto column = [&](double i) {
            const auto c = static_cast<int>(i);
            if (placed.chart->wraps()) return placed.x + (c + placed.width) % placed.width;
            return placed.x + std::clamp(c, 0, placed.width - 1);
        };
        const auto row = [&](double j) { return placed.y + std::clamp(static_cast<int>(j), 0, placed.height - 1); };
        const auto texel = [&](double i, double j) { return static_cast<double>(*baked.image.at(column(i), row(j))); };
        const double s = x - left;
        const double t = y - top;
        return baked.cd_per_unit * ((1.0 - t) * ((1.0 - s) * texel(left, top) + s * texel(left + 1.0, top)) +
                                    t * ((1.0 - s) * texel(left, top + 1.0) + s * texel(left + 1.0, top + 1.0)));
    }
    return 0.0;
}

std::shared_ptr<const Web> street() {
    return std::make_shared<const Web>(authored(parse_authored("street").value(), {}).value());
}

enum class Question { intensity, flux };

Result<Contest> of_question(Question question, const SuiteOptions& options) {
    const bool by_flux = question == Question::flux;
    Contest contest{{"bake", by_flux ? "flux of the texture" : "intensity in any direction", "all",
                     by_flux ? "relative to the flux" : "relative to the peak intensity", "texel",
                     by_flux ? "the exact integral of the web" : "the web's interpolant in double", "latlong"},
                    0,
                    {}};
    const std::shared_ptr<const Web> web = street();
    const int times = options.quick ? 1 : 4;
    const double peak_cd = gonio::peak(*web).intensity.value;
    const double flux_lm = gonio::flux(*web).value;
    Random random(options.seed);
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < (options.quick ? 2000 : 20000); ++i) {
        const hostile::Vec d = hostile::random_direction(random);
        directions.emplace_back(d.x, d.y, d.z);
    }
    for (const Subject& subject : subjects)
        for (const auto& [code, type] : codes) {
            if (!subject.layout && type != TexelType::float32) continue;
            const auto work = [web, &subject, times, kind = type] { (void)bake(*web, subject, times, kind); };
            const auto errors = [=, &subject, kind = type] {
                const Baked baked = bake(*web, subject, times, kind);
                if (by_flux) return std::vector<double>{std::fabs(baked.flux_lm / flux_lm - 1.0)};
                std::vector<double> off;
                for (const glm::dvec3& d : directions)
                    off.push_back(std::fabs(sample(baked, d) - web->candela(d)) / peak_cd);
                return off;
            };
            const auto columns = static_cast<std::size_t>(subject.width) * static_cast<std::size_t>(times);
            const auto rows = static_cast<std::size_t>(subject.height) * static_cast<std::size_t>(times);
            contest.contestants.push_back({subject.name, code, {work, columns * rows}, errors});
        }
    return contest;
}

} // namespace

std::vector<std::string> bake_methods() {
    std::vector<std::string> names;
    add_names(subjects, names);
    return names;
}

std::vector<ContestMaker> bake_contests(const SuiteOptions& options) {
    return {{"intensity in any direction", "all", [options] { return of_question(Question::intensity, options); }},
            {"flux of the texture", "all", [options] { return of_question(Question::flux, options); }}};
}

} // namespace gonio::measure::detail
