#include <gonio/base/amount_range.hpp>
#include <gonio/base/codes/web.hpp>
#include <gonio/profile/tm33_light.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/transform.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace gonio {

namespace {

struct Table {
    Symmetry stored = Symmetry::none;
    std::vector<double> planes_deg; // or H
    std::vector<double> gammas_deg; // or V
    std::vector<double> candela;    // [plane][gamma], before `factor`
    Photometry photometry = Photometry::c;
};

void warn(Diagnostics& diagnostics, Location location, WebCode code, std::string message, std::string hint = {}) {
    diagnostics.push_back(
        {std::string(code->code), code->severity, std::move(location), std::move(message), std::move(hint)});
}

void append_column(std::vector<double>& to, const std::vector<double>& from, std::size_t plane, std::size_t rows) {
    const auto first = from.begin() + static_cast<std::ptrdiff_t>(plane * rows);
    to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(rows));
}

// Drops planes and γ rows with the same angle as the one before; keeps the first of each pair.
Table without_duplicates(const Table& table) {
    const auto repeats = [](const std::vector<double>& angles, std::size_t i) {
        return i > 0 && angles[i] == angles[i - 1];
    };
    Table out;
    out.stored = table.stored;
    out.photometry = table.photometry;
    const std::size_t rows = table.gammas_deg.size();
    for (std::size_t j = 0; j < rows; ++j)
        if (!repeats(table.gammas_deg, j)) out.gammas_deg.push_back(table.gammas_deg[j]);
    for (std::size_t i = 0; i < table.planes_deg.size(); ++i) {
        if (repeats(table.planes_deg, i)) continue;
        out.planes_deg.push_back(table.planes_deg[i]);
        for (std::size_t j = 0; j < rows; ++j)
            if (!repeats(table.gammas_deg, j)) out.candela.push_back(table.candela[i * rows + j]);
    }
    return out;
}

bool repeats_an_angle(const Table& table) {
    const auto repeats = [](const std::vector<double>& angles) {
        return std::adjacent_find(angles.begin(), angles.end()) != angles.end();
    };
    return repeats(table.planes_deg) || repeats(table.gammas_deg);
}

// A full table lists C0 and 360°, but many writers omit the last plane. Only a gap of one step is treated as that.
void close_the_circle(Table& table, const Profile& profile, Diagnostics& diagnostics) {
    const std::size_t n = table.planes_deg.size();
    if (table.photometry != Photometry::c || table.stored != Symmetry::none || n < 2) return;
    const double span = table.planes_deg.back() - table.planes_deg.front();
    if (span >= 360.0 - 1e-9) return;
    double widest = 0.0;
    for (std::size_t i = 1; i < n; ++i)
        widest = std::max(widest, table.planes_deg[i] - table.planes_deg[i - 1]);
    const double gap = 360.0 - span;
    if (gap <= widest * (1.0 + 1e-6)) {
        table.planes_deg.push_back(table.planes_deg.front() + 360.0);
        table.candela.reserve(table.candela.size() + table.gammas_deg.size()); // avoids growing to twice the size
        append_column(table.candela, table.candela, 0, table.gammas_deg.size());
        if (std::holds_alternative<IesFile>(profile.file))
            warn(diagnostics, location_of(profile, ProfileField::last_horizontal), "WEB0101",
                 fmt::format("no C-plane at {}°: closed with the plane at {}°", table.planes_deg.back(),
                             table.planes_deg.front()));
    } else {
        warn(diagnostics, location_of(profile, ProfileField::first_horizontal), "WEB0102",
             fmt::format("C-planes cover only {}° to {}°: dark elsewhere", table.planes_deg.front(),
                         table.planes_deg.back()));
    }
}

bool near_deg(double a, double b) {
    return std::abs(a - b) <= 1e-6;
}

// Moves `end` to the whole degree that it misses by rounding, unless that would put it on or past its `neighbour`.
void take_whole_degree(double& end, double neighbour) {
    const double whole = std::round(end);
    const bool stays_apart = end == neighbour || (end < neighbour ? whole < neighbour : whole > neighbour);
    if (near_deg(end, whole) && stays_apart) end = whole;
}

// The symmetry implied by the first and last plane; planes that miss its ends by rounding are moved there.
Symmetry take_symmetry_of_ies_planes(std::vector<double>& planes) {
    if (planes.size() == 1) return Symmetry::axial;
    take_whole_degree(planes.front(), planes[1]);
    take_whole_degree(planes.back(), planes[planes.size() - 2]);
    if (near_deg(planes.front(), 0.0) && near_deg(planes.back(), 90.0)) return Symmetry::quadrant;
    if (near_deg(planes.front(), 0.0) && near_deg(planes.back(), 180.0)) return Symmetry::bilateral_0_180;
    if (near_deg(planes.front(), 90.0) && near_deg(planes.back(), 270.0)) return Symmetry::bilateral_90_270;
    return Symmetry::none;
}

// Types A and B: angles that start at 0 represent both sides (LM-63: H from 0 is symmetric about the vertical plane;
// the same is assumed for V, because its lower half is not stored anywhere).
Symmetry take_symmetry_of_types_a_b(Table& table) {
    // Only the nearest of several angles next to 0 is moved: together they would become one.
    for (std::vector<double>* angles : {&table.planes_deg, &table.gammas_deg}) {
        const auto nearest = std::min_element(angles->begin(), angles->end(),
                                              [](double a, double b) { return std::abs(a) < std::abs(b); });
        if (nearest != angles->end() && near_deg(*nearest, 0.0)) *nearest = 0.0;
    }
    const bool across = table.planes_deg.size() > 1 && table.planes_deg.front() == 0.0;
    const bool along = table.gammas_deg.size() > 1 && table.gammas_deg.front() == 0.0;
    if (across && along) return Symmetry::quadrant;
    if (across) return Symmetry::bilateral_90_270;
    return along ? Symmetry::bilateral_0_180 : Symmetry::none;
}

// TILT's factor at a mounting tilt: linear between the listed angles, constant beyond the ends.
double tilt_factor(const IesTilt& tilt, double tilt_deg) {
    if (tilt.angles_deg.empty() || tilt.factors.size() != tilt.angles_deg.size()) return 1.0;
    const auto above = std::upper_bound(tilt.angles_deg.begin(), tilt.angles_deg.end(), tilt_deg);
    if (above == tilt.angles_deg.begin()) return tilt.factors.front();
    if (above == tilt.angles_deg.end()) return tilt.factors.back();
    const auto i = static_cast<std::size_t>(above - tilt.angles_deg.begin());
    const double weight = (tilt_deg - tilt.angles_deg[i - 1]) / (tilt.angles_deg[i] - tilt.angles_deg[i - 1]);
    return tilt.factors[i - 1] + weight * (tilt.factors[i] - tilt.factors[i - 1]);
}

// In later editions the twelfth number is reserved, or tells how the file was generated.
bool field_12_is_factor(const IesFile& file) {
    return file.version == IesVersion::lm63_1986 || file.version == IesVersion::lm63_1991;
}

// In all overloads, `candela` is the file's table, which the caller copied or moved from it.
Result<std::pair<Table, double>> table_of(const IesFile& file, std::vector<double> candela, const Profile& profile,
                                          const ResolveOptions& options, Diagnostics& diagnostics) {
    Table table{Symmetry::none, file.horizontal_deg, file.vertical_deg, std::move(candela), file.photometry};
    table.stored = table.photometry == Photometry::c ? take_symmetry_of_ies_planes(table.planes_deg)
                                                     : take_symmetry_of_types_a_b(table);
    if (table.photometry != Photometry::c && (table.planes_deg.size() < 2 || table.gammas_deg.size() < 2))
        warn(diagnostics, location_of(profile, ProfileField::first_horizontal), "WEB0107",
             fmt::format("{} horizontal and {} vertical angles of a type {} table cover no solid angle: dark",
                         table.planes_deg.size(), table.gammas_deg.size(),
                         file.photometry == Photometry::a ? 'A' : 'B'));
    if (table.stored == Symmetry::axial && table.planes_deg.front() != 0.0)
        warn(diagnostics, location_of(profile, ProfileField::first_horizontal), "WEB0103",
             fmt::format("the only C-plane is at {}°: used for every C", table.planes_deg.front()));

    double factor = file.candela_multiplier * file.ballast_factor * tilt_factor(file.tilt, options.tilt_deg);
    if (field_12_is_factor(file)) {
        factor *= file.field_12;
    } else if (file.field_12 != 1.0 && file.version != IesVersion::lm63_2019) {
        warn(diagnostics, location_of(profile, ProfileField::field_12), "WEB0104",
             fmt::format("the 12th field is {}, but {} reserves it as 1: not applied", file.field_12,
                         to_text(file.version)),
             "if the luminaire is too bright or too dark, this is why");
    }
    return std::pair{std::move(table), factor};
}

// The requested lamp set, which must exist.
const LdtLampSet& lamps_of(const LdtFile& file, const ResolveOptions& options) {
    return file.lamp_sets[static_cast<std::size_t>(options.lamp_set) - 1];
}

// Isym 3: the stored planes are Mc1 = 3Mc/4 + 1 to Mc2 = Mc1 + Mc/2 (Stockmar 1990), that is, C270 through C0 to C90.
// Their mirror images in the C90–C270 plane are C270 through C180 to C90: the web's planes in reverse order.
void take_planes_from_c270(const LdtFile& file, std::size_t stored, Table& table) {
    const std::vector<double> candela = std::exchange(table.candela, {});
    table.candela.reserve(candela.size());
    const std::size_t rows = file.gammas_deg.size();
    const std::size_t count = file.planes_deg.size();
    std::size_t first = 0;
    while (first + 1 < count && file.planes_deg[first] < 270.0 - 1e-6)
        ++first;
    for (std::size_t i = stored; i-- > 0;) {
        const double c = file.planes_deg[(first + i) % count];
        table.planes_deg.push_back(std::fmod(540.0 - c, 360.0));
        append_column(table.candela, candela, i, rows);
    }
}

Result<std::pair<Table, double>> table_of(const LdtFile& file, std::vector<double> candela, const Profile& profile,
                                          const ResolveOptions& options, Diagnostics& diagnostics) {
    if (options.lamp_set < 1 || static_cast<std::size_t>(options.lamp_set) > file.lamp_sets.size())
        return fail("USE0106",
                    fmt::format("there is no lamp set {}: the file has {}", options.lamp_set, file.lamp_sets.size()),
                    {}, profile.source);
    const LdtLampSet& lamps = lamps_of(file, options);

    Table table;
    table.gammas_deg = file.gammas_deg;
    table.candela = std::move(candela);
    const std::size_t stored = table.candela.size() / std::max<std::size_t>(1, file.gammas_deg.size());
    switch (file.symmetry) {
    case 1:
        table.stored = Symmetry::axial;
        break;
    case 2:
        table.stored = Symmetry::bilateral_0_180;
        break;
    case 3:
        table.stored = Symmetry::bilateral_90_270;
        break;
    case 4:
        table.stored = Symmetry::quadrant;
        break;
    default:
        table.stored = Symmetry::none;
        break;
    }
    if (table.stored == Symmetry::none && stored == 1) {
        warn(diagnostics, location_of(profile, ProfileField::first_horizontal), "WEB0109",
             "symmetry 0 with one C-plane: used for every C", "symmetry 1 states a round light");
        table.stored = Symmetry::axial;
    }
    if (table.stored == Symmetry::axial) {
        table.planes_deg = {0.0};
    } else if (stored > file.planes_deg.size()) {
        return fail(Failure::malformed,
                    fmt::format("symmetry {} stores {} planes, but only {} are listed", file.symmetry, stored,
                                file.planes_deg.size()),
                    {}, profile.source);
    } else if (table.stored == Symmetry::bilateral_90_270) {
        take_planes_from_c270(file, stored, table);
    } else {
        table.planes_deg.assign(file.planes_deg.begin(), file.planes_deg.begin() + static_cast<std::ptrdiff_t>(stored));
    }
    return std::pair{std::move(table), lamps.flux_lm / 1000.0 * file.conversion_factor};
}

// TM-33 stores the same data in a different form.
Result<std::pair<Table, double>> table_of(const Tm33File& file, const Profile& profile, const ResolveOptions& options,
                                          Diagnostics& diagnostics) {
    Result<IesFile> light = lm63_of(file);
    if (light) {
        std::vector<double> candela = std::exchange(light->candela, {});
        return table_of(*light, std::move(candela), profile, options, diagnostics);
    }
    for (Diagnostic& diagnostic : light.error().diagnostics)
        diagnostic.location.file = profile.source;
    return pass_on(light);
}

// The rotation of a file that uses the other convention; a multiple of 90°, which is exact for every goniometer.
double azimuth_turn_deg(const Profile& profile, AzimuthConvention wanted) {
    const bool eulumdat = std::holds_alternative<LdtFile>(profile.file);
    if (wanted == AzimuthConvention::eulumdat && !eulumdat) return 90.0;
    if (wanted == AzimuthConvention::lm63 && eulumdat) return -90.0;
    return 0.0;
}

// The table of LM-63 or EULUMDAT; TM-33 has several, which are added elsewhere.
template<class AnyProfile>
auto* candela_of(AnyProfile& profile) {
    if (auto* const ies = std::get_if<IesFile>(&profile.file)) return &ies->candela;
    auto* const ldt = std::get_if<LdtFile>(&profile.file);
    return ldt != nullptr ? &ldt->candela_per_klm : nullptr;
}

// The field with the greatest factor by which the table was multiplied, or the table if there is none. A reader rejects
// values out of range, so a value that is out of range after resolving was caused by a factor.
ProfileField greatest_factor(const Profile& profile, const ResolveOptions& options) {
    ProfileField field = ProfileField::intensity;
    double greatest = 1.0;
    const auto consider = [&](ProfileField of, double factor) {
        if (std::abs(factor) <= greatest) return;
        greatest = std::abs(factor);
        field = of;
    };
    if (const auto* const ies = std::get_if<IesFile>(&profile.file)) {
        consider(ProfileField::multiplier, ies->candela_multiplier);
        consider(ProfileField::ballast_factor, ies->ballast_factor);
        if (field_12_is_factor(*ies)) consider(ProfileField::field_12, ies->field_12);
    } else if (const auto* const ldt = std::get_if<LdtFile>(&profile.file)) {
        consider(ProfileField::multiplier, ldt->conversion_factor);
        consider(ProfileField::lamp_flux, lamps_of(*ldt, options).flux_lm / 1000.0);
    } else {
        const Result<IesFile> light = lm63_of(std::get<Tm33File>(profile.file));
        if (light) consider(ProfileField::multiplier, light->candela_multiplier);
    }
    return field;
}

Unexpected beyond_range(const Profile& profile, const ResolveOptions& options, double intensity_cd, double factor) {
    const CodeOf<web_codes> code = "WEB0108";
    const ProfileField field = greatest_factor(profile, options);
    Diagnostic error;
    error.code = code->code;
    error.location = field == ProfileField::lamp_flux ? location_of_lamps(profile, field, options.lamp_set)
                                                      : location_of(profile, field);
    error.message = factor == 1.0 ? fmt::format("an intensity of {} cd is above {} cd", intensity_cd, greatest_amount)
                                  : fmt::format("the factor {} makes {} cd of the table, above {} cd", factor,
                                                intensity_cd, greatest_amount);
    return Unexpected(Error{Failure::malformed, {std::move(error)}});
}

struct TableRange {
    double lowest = 0.0;   // and 0
    double greatest = 0.0; // magnitude
};

// Multiplies in one pass, in which four comparisons go on at a time: none waits for the one before. Factor 1 is exact.
TableRange multiply(std::vector<double>& table, double factor) {
    std::array<TableRange, 4> ranges;
    const auto take = [&](TableRange& range, double& cd) {
        cd *= factor;
        const double magnitude = std::abs(cd);
        range.lowest = cd < range.lowest ? cd : range.lowest;
        range.greatest = magnitude > range.greatest ? magnitude : range.greatest;
    };
    std::size_t i = 0;
    for (; i + ranges.size() <= table.size(); i += ranges.size()) {
        take(ranges[0], table[i]);
        take(ranges[1], table[i + 1]);
        take(ranges[2], table[i + 2]);
        take(ranges[3], table[i + 3]);
    }
    for (; i < table.size(); ++i)
        take(ranges[0], table[i]);
    TableRange all;
    for (const TableRange& range : ranges)
        all = {std::min(all.lowest, range.lowest), std::max(all.greatest, range.greatest)};
    return all;
}

Result<ResolvedWeb> resolve(const Profile& profile, std::vector<double> candela, const ResolveOptions& options) {
    Diagnostics diagnostics;
    const auto* ies = std::get_if<IesFile>(&profile.file);
    const auto* tm33 = std::get_if<Tm33File>(&profile.file);
    auto read = ies != nullptr ? table_of(*ies, std::move(candela), profile, options, diagnostics)
                : tm33 != nullptr
                    ? table_of(*tm33, profile, options, diagnostics)
                    : table_of(std::get<LdtFile>(profile.file), std::move(candela), profile, options, diagnostics);
    if (!read) return pass_on(read);
    auto& [raw, factor] = *read;
    Table table = repeats_an_angle(raw) ? without_duplicates(raw) : std::move(raw);
    close_the_circle(table, profile, diagnostics);

    const auto [lowest, greatest] = multiply(table.candela, factor);
    if (!in_amount_range(greatest)) return beyond_range(profile, options, greatest, factor);
    if (lowest < 0.0)
        warn(diagnostics, location_of(profile, ProfileField::negative_intensity), "WEB0105",
             fmt::format("{} intensities are negative: kept as they are",
                         std::count_if(table.candela.begin(), table.candela.end(), [](double cd) { return cd < 0.0; })),
             "stray light was subtracted from the measurement; textures and pictures clamp them to 0");
    if (!options.as_candela)
        if (const std::string unit = radiometric_unit(profile); !unit.empty())
            warn(diagnostics, location_of(profile, ProfileField::intensity), "WEB0110",
                 fmt::format("the file states that its intensities are in {}, not in candela", unit),
                 "--as-candela takes the numbers as candela");
    if (greatest == 0.0)
        warn(diagnostics, location_of(profile, ProfileField::intensity), "WEB0106",
             "every intensity is 0: this luminaire emits no light");

    Result<Web> web = Web::create(table.photometry, table.stored, std::move(table.planes_deg),
                                  std::move(table.gammas_deg), std::move(table.candela));
    if (!web) {
        for (Diagnostic& diagnostic : web.error().diagnostics)
            diagnostic.location.file = profile.source;
        return pass_on(web);
    }
    const double turn = azimuth_turn_deg(profile, options.azimuth);
    if (turn != 0.0) *web = rotated(*web, turn).web;
    return ResolvedWeb{std::move(*web), std::move(diagnostics)};
}

} // namespace

Result<ResolvedWeb> resolve_web(const Profile& profile, const ResolveOptions& options) {
    const std::vector<double>* const candela = candela_of(profile);
    return resolve(profile, candela != nullptr ? *candela : std::vector<double>(), options);
}

Result<ResolvedWeb> resolve_web(Profile&& profile, const ResolveOptions& options) {
    std::vector<double>* const candela = candela_of(profile);
    return resolve(profile, candela != nullptr ? std::exchange(*candela, {}) : std::vector<double>(), options);
}

std::optional<double> declared_flux_lm(const Profile& profile, const ResolveOptions& options) {
    if (const auto* ies = std::get_if<IesFile>(&profile.file)) {
        if (ies->lumens_per_lamp <= 0.0) return std::nullopt;
        return ies->lumens_per_lamp * ies->lamp_count;
    }
    if (const auto* tm33 = std::get_if<Tm33File>(&profile.file)) return declared_flux_lm(*tm33);
    const auto& ldt = std::get<LdtFile>(profile.file);
    if (options.lamp_set < 1 || static_cast<std::size_t>(options.lamp_set) > ldt.lamp_sets.size()) return std::nullopt;
    const LdtLampSet& lamps = ldt.lamp_sets[static_cast<std::size_t>(options.lamp_set) - 1];
    if (lamps.lamp_count < 0) return std::nullopt;
    return lamps.flux_lm;
}

} // namespace gonio
