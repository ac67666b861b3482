#include "profile_output.hpp"

#include <gonio/base/kind_text.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "output.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonio::cli {

Result<ProfileTarget> profile_target(const Arguments& arguments, const std::string& output) {
    const auto named = arguments.value("--to");
    const auto dialect = arguments.value("--dialect");
    const std::string extension = to_lower(extension_of(output));
    const std::string format = named ? to_lower(*named) : extension == "xml" ? std::string("tm33") : extension;
    static constexpr std::array formats{ProfileTarget::lm63, ProfileTarget::eulumdat, ProfileTarget::tm33};
    const auto format_of = [](std::string_view name) {
        const std::optional<ProfileTarget> found = find_profile_target(name);
        return found ? std::find(formats.begin(), formats.end(), *found) : formats.end();
    };
    const auto* const target = format_of(format);
    const bool known = target != formats.end();
    if (named && !known) return unknown_name("format", *named, std::array<std::string_view, 3>{"ies", "ldt", "tm33"});
    if (dialect) {
        const std::optional<ProfileTarget> edition = find_profile_target(*dialect);
        if (!edition || format_of(*dialect) != formats.end())
            return unknown_name("dialect", *dialect,
                                std::array<std::string_view, 4>{"lm-63-1995", "lm-63-2002", "lm-63-2019", "portable"});
        if (known && *target != ProfileTarget::lm63)
            return fail("USE0107", fmt::format("--dialect {} is for IES, but the output is {}", *dialect, format));
        return *edition;
    }
    if (!known)
        return fail("USE0104",
                    output == "-" ? std::string("stdout has no file name to show the format")
                                  : fmt::format("the name '{}' does not show a format", output),
                    "end it in .ies, .ldt or .xml, or add --to");
    return *target;
}

Result<ProfileOutput> profile_output(const Arguments& arguments) {
    const auto file = arguments.value("--output");
    if (!file) return fail("USE0104", "no output is given", "use -o FILE, ending in .ies, .ldt or .xml");
    const Result<ProfileTarget> target = profile_target(arguments, *file);
    if (!target) return Unexpected(target.error());
    return ProfileOutput{*file, *target};
}

Result<WrittenProfile> write_luminaire(const Luminaire& luminaire, const ProfileOutput& output) {
    Result<MadeProfile> made = to_profile(luminaire.web, luminaire.header, output.target);
    if (!made) return pass_on(made);
    const std::string bytes = write_profile(made->profile, output.target);
    Result<Profile> again = read_profile(bytes, output.file);
    Result<ResolvedWeb> web = again ? resolve_web(std::move(*again)) : Result<ResolvedWeb>(pass_on(again));
    if (!web) {
        const std::string reason = web.error().diagnostics.empty() ? "" : web.error().diagnostics.back().message;
        return fail(Failure::internal, fmt::format("the new profile cannot be read back: {}", reason));
    }
    if (Result<void> written = write_output(output.file, bytes); !written) return pass_on(written);
    WrittenProfile result;
    result.flux_lm = flux(web->web).value;
    result.peak_cd = peak(web->web).intensity.value;
    result.max_error_cd = difference(luminaire.web, web->web).greatest.value;
    result.diagnostics = std::move(made->diagnostics);
    return result;
}

} // namespace gonio::cli
