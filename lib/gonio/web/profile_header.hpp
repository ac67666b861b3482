// ProfileHeader: the data of a photometric file beside its table, independent of the format.
//
// The texts are LM-63 keywords, which every format's fields map to: EULUMDAT's company is MANUFAC, the luminaire's name
// LUMINAIRE, its number LUMCAT, the report's number TEST, date and user ISSUEDATE (DATE before 2002), the lamps' type
// LAMP, and TM-33's elements likewise, what has none being a Comment "[KEYWORD] text"; colour temperature and colour
// rendering, for which LM-63 has no keyword, are the users' keywords _CCT and _CRI. EULUMDAT and LM-63 both list a
// length and a width of the luminous opening and differ in which of them lies along C0: sizes keep their names, as
// azimuths are rotated only on request.
#pragma once

#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/resolve.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

struct ProfileHeader {
    std::string source;               // names the input in messages
    std::vector<IesKeyword> keywords; // in the file's order
    int lamp_count = 1;
    std::optional<double> lamp_flux_lm; // of all lamps together; nothing in absolute photometry
    double input_watts = 0.0;
    LuminousOpening opening;

    double length_m = 0.0; // of the housing, which LM-63 does not store; 0, 0, 0: as the luminous opening
    double width_m = 0.0;
    double height_m = 0.0;

    // Of EULUMDAT alone.
    std::optional<int> type_indicator; // derived from the light where it is not given
    double tilt_deg = 0.0;             // during the measurement
    std::string file_name;
    bool has_ratios = false; // direct ratios other than 0, which only EULUMDAT keeps

    // What the web already contains or cannot contain: reported when a file is made from it.
    bool tilt_applied = false;         // a TILT table was multiplied in
    double file_generation_type = 1.0; // LM-63-2019
    std::size_t other_lamp_sets = 0;   // alternatives to the one the web was resolved with
    std::size_t emitters = 1;          // of TM-33, whose tables were added up
    std::size_t spectra = 0;           // of TM-33
};

// The header of a file whose web is resolved with `options`. A lamp set that the file does not have counts as the
// first.
ProfileHeader header_of(const Profile& profile, const ResolveOptions& options = {});

// Whether two keyword names are the same; case does not matter.
bool same_keyword(std::string_view a, std::string_view b);

// The text of the first keyword of that name, in any case; empty if there is none.
std::string_view keyword_text(const ProfileHeader& header, std::string_view name);

// Adds the keyword, or replaces the text of the first one of that name.
void set_keyword(ProfileHeader& header, std::string_view name, std::string_view text);

} // namespace gonio
