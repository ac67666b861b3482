#include <gonio/base/codes/profile.hpp>
#include <gonio/base/codes/web.hpp>
#include <gonio/web/plausibility.hpp>
#include <gonio/web/repetitions.hpp>

#include <algorithm>
#include <array>

namespace gonio {

namespace {

// A diagnostic of resolving that repeats one of the reader, which has a location.
struct Repetition {
    WebCode again;
    ProfileCode said;
};
constexpr std::array repetitions{
    Repetition{"WEB0101", "IES0309"}, Repetition{"WEB0101", "TM30304"}, Repetition{"WEB0102", "IES0306"},
    Repetition{"WEB0103", "IES0308"}, Repetition{"WEB0104", "IES0213"}, Repetition{"WEB0105", "IES0401"},
    Repetition{"WEB0105", "LDT0401"}, Repetition{"WEB0105", "TM30401"}, Repetition{"WEB0106", "IES0402"},
    Repetition{"WEB0106", "LDT0402"}, Repetition{"WEB0106", "TM30402"},
};

} // namespace

Diagnostics report_of(Diagnostics read, const Profile& profile, const ResolvedWeb& resolved,
                      const ResolveOptions& options) {
    const Diagnostics implausible = check_plausibility(profile, resolved.web, options);
    read.insert(read.end(), resolved.diagnostics.begin(), resolved.diagnostics.end());
    read.insert(read.end(), implausible.begin(), implausible.end());
    drop_repetitions(read);
    return read;
}

void drop_repetitions(Diagnostics& diagnostics) {
    for (const Repetition& repetition : repetitions) {
        const bool is_said = std::any_of(diagnostics.begin(), diagnostics.end(),
                                         [&](const Diagnostic& d) { return d.code == repetition.said->code; });
        if (is_said) std::erase_if(diagnostics, [&](const Diagnostic& d) { return d.code == repetition.again->code; });
    }
}

} // namespace gonio
