// The readers behind read_profile, one for each format. Internal.
//
// They read `bytes` from `begin` up to `end` (the text without byte order mark and without what follows Ctrl-Z) and
// say what is odd to the Report, whose offsets count from the start of `bytes`.
#pragma once

#include <gonio/profile/profile.hpp>
#include <gonio/profile/report.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio::profile_detail {

struct TextRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

Result<IesFile> parse_ies(TextRange text, Report& report);
Result<LdtFile> parse_ldt(TextRange text, Report& report);

// Where things stand in the file, for what is said after the whole of it was read.
struct TablePlaces {
    std::size_t header = 0; // first number behind TILT
    std::size_t shape = 0;  // width of the luminous opening
    std::size_t vertical = 0;
    std::size_t last_vertical = 0;
    std::size_t horizontal = 0;
    std::size_t last_horizontal = 0;
    std::size_t candela = 0;
    std::size_t first_negative = no_place;
};

// Says what is odd about a table that could be read: ranges, missing planes, poles that disagree, no light.
void check_ies(const IesFile& file, const TablePlaces& places, Report& report);
void check_ldt(const LdtFile& file, const TablePlaces& places, Report& report);

// What both checks ask of a table of `planes` rows.
struct Poles {
    bool nadir_differs = false;
    bool zenith_differs = false;
    bool all_zero = true;
};

// `gammas_deg` are type C angles; a pole is looked at only where the table reaches it.
Poles look_at_poles(const std::vector<double>& gammas_deg, const std::vector<double>& table);

} // namespace gonio::profile_detail
