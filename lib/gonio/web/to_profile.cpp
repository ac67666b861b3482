#include <gonio/base/charconv.hpp>
#include <gonio/base/decimal.hpp>
#include <gonio/profile/write.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/greatest_difference.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/make_profile.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/plane_rows.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/to_profile.hpp>
#include <gonio/web/web_rows.hpp>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using web_detail::IesRequest;
using web_detail::Losses;

constexpr std::array<std::pair<ProfileTarget, const char*>, 7> target_names{{{ProfileTarget::lm63, "ies"},
                                                                             {ProfileTarget::lm63_1995, "lm-63-1995"},
                                                                             {ProfileTarget::lm63_2002, "lm-63-2002"},
                                                                             {ProfileTarget::lm63_2019, "lm-63-2019"},
                                                                             {ProfileTarget::portable, "portable"},
                                                                             {ProfileTarget::eulumdat, "ldt"},
                                                                             {ProfileTarget::tm33, "tm33"}}};

IesRequest request_of(ProfileTarget target) {
    switch (target) {
    case ProfileTarget::lm63_1995:
        return {IesVersion::lm63_1995, false};
    case ProfileTarget::lm63_2019:
        return {IesVersion::lm63_2019, false};
    case ProfileTarget::portable:
        return {IesVersion::lm63_2002, true};
    case ProfileTarget::lm63:
    case ProfileTarget::lm63_2002:
    case ProfileTarget::eulumdat:
    case ProfileTarget::tm33:
        break;
    }
    return {IesVersion::lm63_2002, false};
}

bool is_default(const ResolveOptions& options) {
    return options == ResolveOptions{};
}

// Converts TILT=<file> to TILT=INCLUDE: the file beside the source may not exist beside the output.
void include_tilt(MadeProfile& made) {
    auto* ies = std::get_if<IesFile>(&made.profile.file);
    if (ies == nullptr || ies->tilt.angles_deg.empty() || ies->tilt_keyword == "INCLUDE") return;
    Losses losses(made.profile.source);
    losses.add("WEB0217", fmt::format("the factors of TILT={} are written as TILT=INCLUDE", ies->tilt_keyword));
    Diagnostics said = losses.take();
    made.diagnostics.insert(made.diagnostics.end(), said.begin(), said.end());
    ies->tilt_keyword = "INCLUDE";
}

// A single plane without symmetry is written as what it is read as: a round light (WEB0109).
void state_symmetry(MadeProfile& made) {
    auto* const ldt = std::get_if<LdtFile>(&made.profile.file);
    if (ldt != nullptr && ldt->symmetry == 0 && ldt->planes_deg.size() == 1) ldt->symmetry = 1;
}

// LM-63 of one edition to another edition or to TM-33: the factors are kept apart from the table.
Result<MadeProfile> with_factors_apart(const IesFile& file, const Profile& profile, ProfileTarget target) {
    Profile bare = profile;
    auto& table = std::get<IesFile>(bare.file);
    table.candela_multiplier = 1.0;
    table.ballast_factor = 1.0;
    table.field_12 = 1.0;
    table.tilt = {};
    Result<ResolvedWeb> resolved = resolve_web(bare);
    if (!resolved) return pass_on(resolved);
    ProfileHeader header = header_of(profile);
    header.tilt_applied = false;
    Result<MadeProfile> made = to_profile(resolved->web, header, target);
    if (!made) return pass_on(made);
    const bool field_12_is_factor = file.version == IesVersion::lm63_1986 || file.version == IesVersion::lm63_1991;
    const double ballast_factor = file.ballast_factor * (field_12_is_factor ? file.field_12 : 1.0);
    if (target == ProfileTarget::tm33) {
        Tm33Emitter& emitter = std::get<Tm33File>(made->profile.file).emitters.front();
        if (file.candela_multiplier != 1.0) emitter.intensity->multiplier = file.candela_multiplier;
        if (ballast_factor != 1.0) emitter.ballast_factor = ballast_factor;
        emitter.tilt = file.tilt;
        const Result<ResolvedWeb> whole = resolve_web(profile);
        if (whole) emitter.luminous_flux_lm = flux(whole->web).value;
        return web_detail::with_numbers_in_range(std::move(*made));
    }
    auto& out = std::get<IesFile>(made->profile.file);
    out.lamp_count = file.lamp_count;
    out.lumens_per_lamp = file.lumens_per_lamp;
    out.candela_multiplier = file.candela_multiplier;
    out.ballast_factor = ballast_factor;
    out.tilt_keyword = file.tilt_keyword;
    out.tilt = file.tilt;
    include_tilt(*made);
    // The name of a file that could not be read is kept if the edition allows one.
    if (out.tilt.angles_deg.empty() && out.version == IesVersion::lm63_2019) out.tilt_keyword = "NONE";
    return web_detail::with_numbers_in_range(std::move(*made));
}

void report_resampling(const ResampledWeb& resampled, const Web& web, Losses& losses) {
    const double bright = std::abs(peak(web).intensity.value);
    const auto of_peak = [&](Candelas error) { return bright > 0.0 ? error.value / bright : 0.0; };
    std::string message =
        fmt::format("type {} resampled to {} by {} angles of type C: off by up to {:.2g} of the peak at C {:.4g}, "
                    "gamma {:.4g}, flux by {:.2g} lm",
                    web.photometry() == Photometry::a ? 'A' : 'B', resampled.web.planes_deg().size(),
                    resampled.web.gammas_deg().size(), of_peak(resampled.max_error), resampled.max_error_c_deg,
                    resampled.max_error_gamma_deg, resampled.flux_error.value);
    if (resampled.jump_error.value > resampled.max_error.value)
        message += fmt::format("; {:.2g} where the table's own values jump", of_peak(resampled.jump_error));
    losses.add("WEB0205", std::move(message));
}

// Whether the light, turned by 90° about its axis, differs somewhere by more than 1 % of its peak.
bool changes_when_turned(const Web& web) {
    if (web.stored_symmetry() == Symmetry::axial) return false;
    const double least = 0.01 * peak(web).intensity.value;
    const std::vector<double> gammas_deg = even_angles(0.0, 180.0, 72);
    web_detail::WebRows rows(web, gammas_deg);
    web_detail::WebRows turned(web, gammas_deg);
    for (int c = 0; c < 360; c += 5) {
        const std::span<const double> here = rows.exact(c);
        const std::span<const double> there = turned.exact(c + 90.0);
        for (std::size_t j = 0; j < gammas_deg.size(); ++j)
            if (std::abs(here[j] - there[j]) > least) return true;
    }
    return false;
}

// C was kept, though the source's standard and the target's count it from different sides of the luminaire.
void report_azimuth(const Web& web, const ProfileHeader& header, ProfileTarget target, Losses& losses) {
    const bool to_eulumdat = target == ProfileTarget::eulumdat;
    const AzimuthConvention wanted = to_eulumdat ? AzimuthConvention::eulumdat : AzimuthConvention::lm63;
    if (header.azimuth == AzimuthConvention::as_written || header.azimuth == wanted || !changes_when_turned(web))
        return;
    losses.add("WEB0220",
               fmt::format("C0 stays C0, but {} puts it {} the luminaire", to_eulumdat ? "EULUMDAT" : "LM-63",
                           to_eulumdat ? "across" : "along"),
               fmt::format("add --azimuth {} to turn it by 90°", to_eulumdat ? "eulumdat" : "ies"));
}

} // namespace

double web_detail::rounded_to(double value, int digits) {
    if (const std::optional<Decimal> decimal = nearest_decimal(std::abs(value), digits))
        return std::copysign(decimal->value(), value);
    std::array<char, 64> text{};
    const auto [end, error] =
        to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
    double rounded = value;
    if (error == std::errc()) from_chars(text.data(), end, rounded);
    return rounded;
}

void web_detail::report_other_losses(const ProfileHeader& header, bool keeps_generation_type, Losses& losses) {
    if (header.tilt_applied) losses.add("WEB0202", "the TILT table was applied for one tilt and is left out");
    if (header.other_lamp_sets > 0)
        losses.add("WEB0203", fmt::format("{} other lamp sets left out", header.other_lamp_sets),
                   "--lamp-set selects another");
    if (header.spectra > 0)
        losses.add("WEB0204",
                   fmt::format("{} {} left out", header.spectra, header.spectra == 1 ? "spectrum" : "spectra"));
    if (header.emitters > 1)
        losses.add("WEB0218", fmt::format("{} emitters added up, with the description of the first", header.emitters));
    if (header.file_generation_type != 1.0 && !keeps_generation_type)
        losses.add("WEB0211", fmt::format("file generation type {} left out", header.file_generation_type));
}

const char* to_text(ProfileTarget target) {
    for (const auto& [known, name] : target_names)
        if (known == target) return name;
    return "";
}

std::optional<ProfileTarget> find_profile_target(std::string_view name) {
    for (const auto& [target, known] : target_names)
        if (name == known) return target;
    return std::nullopt;
}

std::optional<ProfileTarget> target_of(const Profile& profile) {
    const auto* ies = std::get_if<IesFile>(&profile.file);
    if (std::holds_alternative<LdtFile>(profile.file)) return ProfileTarget::eulumdat;
    if (ies == nullptr) return ProfileTarget::tm33;
    switch (ies->version) {
    case IesVersion::lm63_1995:
        return ProfileTarget::lm63_1995;
    case IesVersion::lm63_2002:
        return ProfileTarget::lm63_2002;
    case IesVersion::lm63_2019:
        return ProfileTarget::lm63_2019;
    case IesVersion::lm63_1986:
    case IesVersion::lm63_1991:
        break;
    }
    return std::nullopt;
}

Result<MadeProfile> to_profile(const Web& web, const ProfileHeader& header, ProfileTarget target) {
    Losses losses(header.source);
    MadeProfile made;
    made.profile.source = header.source;
    const bool type_c_alone = target == ProfileTarget::eulumdat || target == ProfileTarget::portable;
    std::optional<Web> of_type_c;
    if (type_c_alone && web.photometry() != Photometry::c) {
        Result<ResampledWeb> resampled = resampled_to_c(web);
        if (!resampled) return pass_on(resampled);
        report_resampling(*resampled, web, losses);
        of_type_c = std::move(resampled->web);
    }
    const Web& written = of_type_c ? *of_type_c : web;
    if (target == ProfileTarget::eulumdat)
        made.profile.file = web_detail::make_ldt(written, header, losses);
    else if (target == ProfileTarget::tm33)
        made.profile.file = web_detail::make_tm33(written, header, losses);
    else
        made.profile.file = web_detail::make_ies(written, header, request_of(target), losses);
    report_azimuth(written, header, target, losses);
    made.diagnostics = losses.take();
    return web_detail::with_numbers_in_range(std::move(made));
}

Result<MadeProfile> convert_profile(const Profile& profile, ProfileTarget target, const ResolveOptions& options) {
    const auto* ies = std::get_if<IesFile>(&profile.file);
    if (target == ProfileTarget::lm63 && ies != nullptr && !is_default(options))
        return convert_profile(profile, target_of(profile).value_or(ProfileTarget::lm63_2002), options);
    if (is_default(options)) {
        if (target_of(profile) == target || (target == ProfileTarget::lm63 && ies != nullptr)) {
            MadeProfile kept{profile, {}};
            kept.profile.diagnostics.clear();
            include_tilt(kept);
            state_symmetry(kept);
            return kept;
        }
        if (ies != nullptr && target != ProfileTarget::eulumdat && target != ProfileTarget::portable)
            return with_factors_apart(*ies, profile, target);
    }
    Result<ResolvedWeb> resolved = resolve_web(profile, options);
    if (!resolved) return pass_on(resolved);
    return to_profile(resolved->web, header_of(profile, options), target);
}

Result<MadeProfile> convert_compacted(const Profile& profile, ProfileTarget target, double tolerance,
                                      const ResolveOptions& options) {
    Result<ResolvedWeb> resolved = resolve_web(profile, options);
    if (!resolved) return pass_on(resolved);
    const Web& web = resolved->web;
    const Web compact = compacted(web, tolerance);
    if (compact.stored_symmetry() == web.stored_symmetry()) return convert_profile(profile, target, options);
    if (target == ProfileTarget::lm63) target = target_of(profile).value_or(ProfileTarget::lm63_2002);
    Result<MadeProfile> made = to_profile(compact, header_of(profile, options), target);
    if (!made) return made;
    Losses losses(profile.source);
    losses.add("WEB0219", fmt::format("symmetry {} stored as {}: {} by {} angles instead of {} by {}",
                                      to_text(web.stored_symmetry()), to_text(compact.stored_symmetry()),
                                      compact.horizontal_deg().size(), compact.vertical_deg().size(),
                                      web.horizontal_deg().size(), web.vertical_deg().size()));
    Diagnostics said = losses.take();
    made->diagnostics.insert(made->diagnostics.begin(), said.begin(), said.end());
    return made;
}

ConversionError conversion_error(const Web& source, const Web& made) {
    ConversionError error;
    const double bright = std::abs(peak(source).intensity.value);
    if (source.photometry() != made.photometry()) {
        const WebDifference found = web_detail::greatest_difference(source, made);
        return {found.greatest, bright > 0.0 ? found.greatest.value / bright : 0.0, found.c_deg, found.gamma_deg};
    }
    double greatest = -1.0;
    std::vector<double> before;
    std::vector<double> after;
    for (const Web* const web : {&source, &made}) {
        const std::span<const double> vertical_deg = web->vertical_deg();
        const web_detail::PlaneRows of_source(source, vertical_deg);
        const web_detail::PlaneRows of_made(made, vertical_deg);
        for (const double h : web->horizontal_deg()) {
            before.clear();
            after.clear();
            of_source.append(h, before);
            of_made.append(h, after);
            for (std::size_t j = 0; j < vertical_deg.size(); ++j) {
                const double off = std::abs(before[j] - after[j]);
                if (off <= greatest) continue;
                greatest = off;
                GoniometerAngles at{h, vertical_deg[j]};
                if (source.photometry() != Photometry::c)
                    at = angles_of(Photometry::c, direction_of(source.photometry(), at));
                error = {Candelas(off), 0.0, at.horizontal_deg, at.vertical_deg};
            }
        }
    }
    error.relative = bright > 0.0 ? greatest / bright : 0.0;
    return error;
}

std::string write_profile(const Profile& profile, ProfileTarget target) {
    const auto* ies = std::get_if<IesFile>(&profile.file);
    return ies != nullptr && target == ProfileTarget::portable ? write_ies(*ies, 132) : write_profile(profile);
}

} // namespace gonio
