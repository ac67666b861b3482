// The parts of to_profile, one for each format. Internal to the web room.
#pragma once

#include <gonio/base/codes/web.hpp>
#include <gonio/base/diagnostics.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/grid.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/to_profile.hpp>
#include <gonio/web/web.hpp>

#include <string>

namespace gonio::web_detail {

// Everything that was lost or changed while a file was made.
class Losses {
public:
    explicit Losses(std::string source) : source_(std::move(source)) {}

    // For the whole file.
    void add(WebCode code, std::string message, std::string hint = {}) {
        add_at({source_, 0, 0}, code, std::move(message), std::move(hint));
    }

    void add_at(Location location, WebCode code, std::string message, std::string hint = {}) {
        Diagnostic diagnostic;
        diagnostic.code = code->code;
        diagnostic.severity = code->severity;
        diagnostic.location = std::move(location);
        diagnostic.message = std::move(message);
        diagnostic.hint = std::move(hint);
        diagnostics_.push_back(std::move(diagnostic));
    }

    Diagnostics take() { return std::move(diagnostics_); }

private:
    std::string source_;
    Diagnostics diagnostics_;
};

// The nearest number with that many significant digits, so that a value multiplied by a factor and divided again is not
// written with sixteen digits.
double rounded_to(double value, int digits);

// Reports header data that no target except its own format can store; the same for every target.
void report_other_losses(const ProfileHeader& header, bool keeps_generation_type, Losses& losses);

// Which planes of a type C web a format allows.
enum class Lm63Planes {
    full_turn,   // one, or all of them
    half_from_0, // and symmetric planes over 0° to 90° and 0° to 180°
    any_half     // and over 90° to 270°
};

// The table of a web as LM-63 and TM-33 list it: planes from 0°, closed at 360° if they cover a full turn; vertical
// angles begin and end where the formats require.
Grid lm63_grid(const Web& web, Lm63Planes allowed, Losses& losses);

struct IesRequest {
    IesVersion version = IesVersion::lm63_2002;
    bool portable = false;
};

// The portable dialect needs a web of type C.
IesFile make_ies(const Web& web, const ProfileHeader& header, IesRequest request, Losses& losses);

// The web must be of type C.
LdtFile make_ldt(const Web& web, const ProfileHeader& header, Losses& losses);

Tm33File make_tm33(const Web& web, const ProfileHeader& header, Losses& losses);

// Returns `made`. Fails (malformed) if a number in it is above greatest_amount, which readers reject: a web in range
// may be the product of factors that are out of range, or be divided by a flux close to 0.
Result<MadeProfile> with_numbers_in_range(MadeProfile made);

} // namespace gonio::web_detail
