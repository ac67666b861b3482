#include <gonio/base/named.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/detail/cie_tables.hpp>
#include <gonio/color/kernels.hpp>
#include <gonio/color/locus.hpp>
#include <gonio/color/named_methods.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/rgb_space.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace gonio {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const RgbSpace& rec709() {
    static const RgbSpace& space = *find_rgb_space("rec709");
    return space;
}

glm::dvec3 xyz_of_rec709(const glm::dvec3& rgb) {
    return rec709().to_xyz * rgb;
}

// A colour clipped to Rec.709 and scaled to a greatest channel of 1.
glm::dvec3 cut_to_max(const glm::dvec3& xyz) {
    const glm::dvec3 rgb = glm::max(rec709().from_xyz * xyz, glm::dvec3(0.0));
    return xyz_of_rec709(rgb / std::max({rgb.x, rgb.y, rgb.z}));
}

// --- chromaticities ---

glm::dvec3 krystek(Kelvin temperature) {
    const color::UvPrimeOf<double> at = color::krystek_uv_prime(temperature.value);
    return to_xyz(Uv{at.u, at.v / 1.5});
}

glm::dvec3 kang(Kelvin temperature) {
    const double T = temperature.value;
    const double t = 1e3 / T;
    const double x = T <= 4000.0 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                                 : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
    const double y = T <= 2222.0   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                     : T <= 4000.0 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                   : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    return to_xyz(Xy{x, y});
}

glm::dvec3 fit(Kelvin temperature) {
    return to_xyz(fast_uv({temperature, 0.0}));
}

// The same in float, as the kernels compute it; uses the scalar kernels, so that the result is the same on every
// machine.
glm::dvec3 fit_float(Kelvin temperature) {
    const auto T = static_cast<float>(temperature.value);
    std::array<float, 3> rgb{};
    float* const out[3] = {&rgb[0], &rgb[1], &rgb[2]};
    static const color::RgbConstants space = color::rgb_constants(rec709());
    color::kernels(simd::InstructionSet::scalar).planckian_rgb(&T, 1, space, out);
    return xyz_of_rec709({rgb[0], rgb[1], rgb[2]});
}

// OSL's blackbody(): 5 nm, 380–780 nm, c2 of ITS-90 (without its observer's rounding to four decimals and its table's
// error).
glm::dvec3 osl(Kelvin temperature) {
    glm::dvec3 xyz(0.0);
    for (int nm = 380; nm <= 780; nm += 5) {
        const auto& row = detail::observer[static_cast<std::size_t>(nm - detail::observer_first_nm)];
        const double power =
            std::pow(560.0 / nm, 5) / std::expm1(c2_its90_meter_kelvin * 1e9 / (nm * temperature.value));
        xyz += power * glm::dvec3(row[0], row[1], row[2]);
    }
    return xyz / xyz.y;
}

// --- programs ---

glm::dvec3 filament(Kelvin temperature) {
    return cut_to_max(krystek(temperature));
}

glm::dvec3 unreal(Kelvin temperature) {
    return krystek(Kelvin(std::clamp(temperature.value, 1000.0, 15000.0)));
}

glm::dvec3 materialx(Kelvin temperature) {
    const glm::dvec3 rgb = rec709().from_xyz * kang(Kelvin(std::clamp(temperature.value, 800.0, 25000.0)));
    return xyz_of_rec709(glm::max(rgb, glm::dvec3(0.0)));
}

// Seven pieces: r and g are a/T + bT + c, b a cubic (Cycles' kernel tables).
glm::dvec3 blender(Kelvin temperature) {
    struct Piece {
        double from;
        std::array<double, 3> r;
        std::array<double, 3> g;
        std::array<double, 4> b;
    };
    static constexpr std::array pieces{
        Piece{800.0,
              {1.61919106e3, -2.05010916e-3, 5.02995757},
              {-4.88999748e2, 6.04330754e-4, -7.55807526e-2},
              {5.96945309e-11, -4.85742887e-8, -9.70622247e-5, -4.07936148e-3}},
        Piece{965.0,
              {2.48845471e3, -1.11330907e-3, 3.22621544},
              {-7.55994277e2, 3.16730098e-4, 4.78306139e-1},
              {2.40430366e-11, 5.55021075e-8, -1.98503712e-4, 2.89312858e-2}},
        Piece{1167.0,
              {3.34143193e3, -4.86551192e-4, 1.76486769},
              {-1.02363977e3, 1.20223470e-4, 9.36662319e-1},
              {-1.40949732e-11, 1.89878968e-7, -3.56632824e-4, 9.10767778e-2}},
        Piece{1449.0,
              {4.09461742e3, -1.27446582e-4, 7.25731635e-1},
              {-1.26571316e3, 4.87340896e-6, 1.27054498},
              {-3.61460868e-11, 2.84822009e-7, -4.93211319e-4, 1.56723440e-1}},
        Piece{1902.0,
              {4.67028036e3, 2.91258199e-5, 1.26703442e-1},
              {-1.42529332e3, -4.01150431e-5, 1.43972784},
              {-1.97075738e-11, 1.75359352e-7, -2.50542825e-4, -2.22783266e-2}},
        Piece{3315.0,
              {4.59509185e3, 2.87495649e-5, 1.50345020e-1},
              {-1.17554822e3, -2.16378048e-5, 1.30408023},
              {-1.61997957e-13, -1.64216008e-8, 3.86216271e-4, -7.38077418e-1}},
        Piece{6365.0,
              {3.78717450e3, 9.35907826e-6, 3.99075871e-1},
              {-5.00799571e2, -4.59832026e-6, 1.09098763},
              {6.72650283e-13, -2.73078809e-8, 4.24098264e-4, -7.52335691e-1}},
    };
    const double T = std::clamp(temperature.value, 800.0, 12000.0);
    std::size_t i = pieces.size() - 1;
    while (i > 0 && T < pieces[i].from)
        --i;
    const Piece& p = pieces[i];
    const glm::dvec3 rgb(p.r[0] / T + p.r[1] * T + p.r[2], p.g[0] / T + p.g[1] * T + p.g[2],
                         ((p.b[0] * T + p.b[1]) * T + p.b[2]) * T + p.b[3]);
    return xyz_of_rec709(glm::max(rgb, glm::dvec3(0.0)));
}

// Knots of 500 K from 1000 K, interpolated by a Catmull–Rom spline (UsdLux; the knots from J. Walker's specrend).
glm::dvec3 usd(Kelvin temperature) {
    static const std::array<glm::dvec3, 19> knots{{{1.0, 0.027490, 0.0},
                                                   {1.0, 0.149664, 0.0},
                                                   {1.0, 0.256644, 0.008095},
                                                   {1.0, 0.372033, 0.067450},
                                                   {1.0, 0.476725, 0.153601},
                                                   {1.0, 0.570376, 0.259196},
                                                   {1.0, 0.653480, 0.377155},
                                                   {1.0, 0.726878, 0.501606},
                                                   {1.0, 0.791543, 0.628050},
                                                   {1.0, 0.848462, 0.753228},
                                                   {1.0, 0.898581, 0.874905},
                                                   {1.0, 0.942771, 0.991642},
                                                   {0.906947, 0.890456, 1.0},
                                                   {0.828247, 0.841838, 1.0},
                                                   {0.765791, 0.801896, 1.0},
                                                   {0.715255, 0.768579, 1.0},
                                                   {0.673683, 0.740423, 1.0},
                                                   {0.638992, 0.716359, 1.0},
                                                   {0.609681, 0.695588, 1.0}}};
    const double place = (std::clamp(temperature.value, 1000.0, 10000.0) - 1000.0) / 500.0;
    const auto i = std::min(static_cast<std::size_t>(place), knots.size() - 2);
    const double f = place - static_cast<double>(i);
    const glm::dvec3& p0 = knots[i > 0 ? i - 1 : 0];
    const glm::dvec3& p1 = knots[i];
    const glm::dvec3& p2 = knots[i + 1];
    const glm::dvec3& p3 = knots[std::min(i + 2, knots.size() - 1)];
    const glm::dvec3 slope1 = 0.5 * (p2 - p0);
    const glm::dvec3 slope2 = 0.5 * (p3 - p1);
    const glm::dvec3 rgb =
        p1 + f * (slope1 + f * (3.0 * (p2 - p1) - 2.0 * slope1 - slope2 + f * (2.0 * (p1 - p2) + slope1 + slope2)));
    const double luma = glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
    return xyz_of_rec709(glm::max(rgb / luma, glm::dvec3(0.0)));
}

// Encoded values from 0 to 255, decoded to linear light.
glm::dvec3 decoded(double r, double g, double b) {
    const auto channel = [](double value) { return decode_srgb(std::clamp(value, 0.0, 255.0) / 255.0); };
    return xyz_of_rec709({channel(r), channel(g), channel(b)});
}

glm::dvec3 helland(Kelvin temperature) {
    const double h = std::clamp(temperature.value, 1000.0, 40000.0) / 100.0;
    if (h <= 66.0)
        return decoded(255.0, 99.4708025861 * std::log(h) - 161.1195681661,
                       h <= 19.0 ? 0.0 : 138.5177312231 * std::log(h - 10.0) - 305.0447927307);
    return decoded(329.698727446 * std::pow(h - 60.0, -0.1332047592),
                   288.1221695283 * std::pow(h - 60.0, -0.0755148492), 255.0);
}

glm::dvec3 bartlett(Kelvin temperature) {
    const double h = std::clamp(temperature.value, 1000.0, 40000.0) / 100.0;
    const auto curve = [](double x, double a, double b, double c) { return a + b * x + c * std::log(x); };
    // Rounded to bytes, as the package returns them.
    if (h < 66.0)
        return decoded(
            255.0, std::round(curve(h - 2.0, -155.25485562709179, -0.44596950469579133, 104.49216199393888)),
            h <= 20.0 ? 0.0 : std::round(curve(h - 10.0, -254.76935184120902, 0.8274096064007395, 115.67994401066147)));
    return decoded(std::round(curve(h - 55.0, 351.97690566805693, 0.114206453784165, -40.25366309332127)),
                   std::round(curve(h - 50.0, 325.4494125711974, 0.07943456536662342, -28.0852963507957)), 255.0);
}

// Robertson (1968): isotemperature lines by mired, with u, v and slope; the row at 325 mired is corrected for its
// misprint.
struct IsotemperatureLine {
    double mired, u, v, slope;
};
constexpr std::array lines{
    IsotemperatureLine{0, 0.18006, 0.26352, -0.24341},   IsotemperatureLine{10, 0.18066, 0.26589, -0.25479},
    IsotemperatureLine{20, 0.18133, 0.26846, -0.26876},  IsotemperatureLine{30, 0.18208, 0.27119, -0.28539},
    IsotemperatureLine{40, 0.18293, 0.27407, -0.30470},  IsotemperatureLine{50, 0.18388, 0.27709, -0.32675},
    IsotemperatureLine{60, 0.18494, 0.28021, -0.35156},  IsotemperatureLine{70, 0.18611, 0.28342, -0.37915},
    IsotemperatureLine{80, 0.18740, 0.28668, -0.40955},  IsotemperatureLine{90, 0.18880, 0.28997, -0.44278},
    IsotemperatureLine{100, 0.19032, 0.29326, -0.47888}, IsotemperatureLine{125, 0.19462, 0.30141, -0.58204},
    IsotemperatureLine{150, 0.19962, 0.30921, -0.70471}, IsotemperatureLine{175, 0.20525, 0.31647, -0.84901},
    IsotemperatureLine{200, 0.21142, 0.32312, -1.0182},  IsotemperatureLine{225, 0.21807, 0.32909, -1.2168},
    IsotemperatureLine{250, 0.22511, 0.33439, -1.4512},  IsotemperatureLine{275, 0.23247, 0.33904, -1.7298},
    IsotemperatureLine{300, 0.24010, 0.34308, -2.0637},  IsotemperatureLine{325, 0.24792, 0.34655, -2.4681},
    IsotemperatureLine{350, 0.25591, 0.34951, -2.9641},  IsotemperatureLine{375, 0.26400, 0.35200, -3.5814},
    IsotemperatureLine{400, 0.27218, 0.35407, -4.3633},  IsotemperatureLine{425, 0.28039, 0.35577, -5.3762},
    IsotemperatureLine{450, 0.28863, 0.35714, -6.7262},  IsotemperatureLine{475, 0.29685, 0.35823, -8.5955},
    IsotemperatureLine{500, 0.30505, 0.35907, -11.324},  IsotemperatureLine{525, 0.31320, 0.35968, -15.628},
    IsotemperatureLine{550, 0.32129, 0.36011, -23.325},  IsotemperatureLine{575, 0.32931, 0.36038, -40.770},
    IsotemperatureLine{600, 0.33724, 0.36051, -116.45},
};

glm::dvec3 robertson(Kelvin temperature) {
    const double mired = std::clamp(1e6 / temperature.value, 0.0, 600.0);
    std::size_t i = 1;
    while (i + 1 < lines.size() && lines[i].mired < mired)
        ++i;
    const double f = (mired - lines[i - 1].mired) / (lines[i].mired - lines[i - 1].mired);
    return to_xyz(
        Uv{lines[i - 1].u + f * (lines[i].u - lines[i - 1].u), lines[i - 1].v + f * (lines[i].v - lines[i - 1].v)});
}

constexpr Kelvin forever{std::numeric_limits<double>::infinity()};

constexpr std::array methods{
    ColorMethod{"fit", Kelvin(800), forever, false, "gonio's rational functions, double", fit},
    ColorMethod{"fit-float", Kelvin(800), Kelvin(1e6), false, "the same, float: the batch kernels", fit_float},
    ColorMethod{"krystek", Kelvin(1000), Kelvin(15000), false, "Krystek 1985", krystek},
    ColorMethod{"kang", Kelvin(1667), Kelvin(25000), false, "Kang et al. 2002", kang},
    ColorMethod{"robertson", Kelvin(1667), forever, true, "Robertson 1968, linear in mired; Blender's white balance",
                robertson},
    ColorMethod{"osl", Kelvin(800), forever, false, "Open Shading Language: sum of 5 nm, 380–780 nm", osl},
    ColorMethod{"blender", Kelvin(800), Kelvin(12000), true, "Cycles' fit, cut to Rec.709", blender},
    ColorMethod{"usd", Kelvin(1000), Kelvin(10000), true, "UsdLux: spline through 19 knots, cut to Rec.709", usd},
    ColorMethod{"unreal", Kelvin(1000), Kelvin(15000), true, "Krystek, clamped", unreal},
    ColorMethod{"filament", Kelvin(1000), Kelvin(15000), false, "Krystek, cut to Rec.709, max = 1; Godot too",
                filament},
    ColorMethod{"materialx", Kelvin(800), Kelvin(25000), true, "Kang, cut to Rec.709 (GLSL of 2026)", materialx},
    ColorMethod{"helland", Kelvin(1000), Kelvin(40000), true, "Helland 2012, sRGB; three.js", helland},
    ColorMethod{"bartlett", Kelvin(1000), Kelvin(40000), true, "Bartlett 2015, sRGB; npm color-temperature", bartlett},
};

// --- chromaticity → temperature ---

double cct_fit(Uv at) {
    return fast_cct(at).temperature.value;
}

double mccamy(Uv at) {
    const Xy xy = to_xy(at);
    const double n = (xy.x - 0.3320) / (0.1858 - xy.y);
    return ((449.0 * n + 3525.0) * n + 6823.3) * n + 5520.33;
}

double hernandez(Uv at) {
    const Xy xy = to_xy(at);
    const double n = (xy.x - 0.3366) / (xy.y - 0.1735);
    const double low = -949.86315 + 6253.80338 * std::exp(-n / 0.92159) + 28.70599 * std::exp(-n / 0.20039) +
                       0.00004 * std::exp(-n / 0.07125);
    if (low <= 50000.0) return low;
    const double m = (xy.x - 0.3356) / (xy.y - 0.1691);
    return 36284.48953 + 0.00228 * std::exp(-m / 0.07861) + 5.4535e-36 * std::exp(-m / 0.01543);
}

double cct_robertson(Uv at) {
    double before = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double distance =
            ((at.v - lines[i].v) - lines[i].slope * (at.u - lines[i].u)) / std::hypot(1.0, lines[i].slope);
        if (i > 0 && distance <= 0.0 && before > 0.0) {
            const double f = before / (before - distance);
            return 1e6 / (lines[i - 1].mired + f * (lines[i].mired - lines[i - 1].mired));
        }
        before = distance;
    }
    return nan;
}

constexpr std::array inverses{
    CctMethod{"fit", Kelvin(800), Kelvin(1e6), "Newton on gonio's rational functions", cct_fit},
    CctMethod{"robertson", Kelvin(1667), forever, "Robertson 1968, 31 isotemperature lines", cct_robertson},
    CctMethod{"mccamy", Kelvin(2856), Kelvin(6500), "McCamy 1992", mccamy},
    CctMethod{"hernandez", Kelvin(3000), Kelvin(1e6), "Hernández-Andrés, Lee and Romero 1999", hernandez},
};

template<class Method>
Result<std::vector<const Method*>> parse(std::string_view list, std::span<const Method> known, std::string_view what) {
    std::vector<const Method*> found;
    if (list == "all") {
        for (const Method& method : known)
            found.push_back(&method);
        return found;
    }
    for (bool more = true; more;) {
        const std::size_t comma = list.find(',');
        Result<const Method*> method = find_named(what, list.substr(0, comma), known);
        if (!method) return pass_on(method);
        found.push_back(*method);
        more = comma != std::string_view::npos;
        if (more) list.remove_prefix(comma + 1);
    }
    return found;
}

} // namespace

std::span<const ColorMethod> color_methods() {
    return methods;
}

std::span<const CctMethod> cct_methods() {
    return inverses;
}

Result<std::vector<const ColorMethod*>> parse_color_methods(std::string_view list) {
    return parse(list, color_methods(), "method");
}

Result<std::vector<const CctMethod*>> parse_cct_methods(std::string_view list) {
    return parse(list, cct_methods(), "method of the inverse");
}

ColorError error_of(const ColorMethod& method, Kelvin temperature) {
    ColorError error;
    error.in_range = temperature.value >= method.coolest.value && temperature.value <= method.hottest.value;
    const glm::dvec3 xyz = method.xyz(temperature);
    const Uv at = to_uv(xyz);
    error.at = at;
    error.delta_uv_prime = delta_uv_prime(at, to_uv(planckian_xyz(temperature)));
    error.luminance = xyz.y;
    const Result<Cct> cct = exact_cct(at);
    error.cct_k = cct ? cct->temperature.value : nan;
    error.duv = cct ? cct->duv : nan;
    return error;
}

} // namespace gonio
