// The readers behind read_profile, one for each format. Internal.
//
// They read `bytes` from `begin` up to `end` (the text without byte order mark and without anything after Ctrl-Z) and
// report anything odd to the Report; its offsets count from the start of `bytes`.
#pragma once

#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/reader_report.hpp>
#include <gonio/profile/scanner.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gonio::profile_detail {

struct TextRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

enum class Utf16 { no, little_endian, big_endian };

Utf16 utf16_of(std::string_view bytes);

// The text in `bytes`: without marks, Ctrl-Z and NUL padding at its ends. Fails if it is not text.
Result<TextRange> find_text(std::string_view bytes, Report& report);

// Whether what begins like this is taken for a file of another kind or for a byte order mark; writers put a blank
// before text that does.
bool begins_as_other_file(std::string_view bytes);

Result<IesFile> parse_ies(TextRange text, Report& report, const ReadBeside& read_beside);
Result<LdtFile> parse_ldt(TextRange text, Report& report);
Result<Tm33File> parse_tm33(TextRange text, Report& report);

// Whether an outermost element of that name is TM-33's, or that of a closely related document.
bool is_tm33_root(std::string_view name);

// Reads the text after TILT=INCLUDE and in the file of TILT=<name>: geometry, count, angles, factors. `numbers` stops
// after the last factor; `end` is where the text ends.
Result<IesTilt> parse_tilt(NumberScanner& numbers, std::size_t end, Report& report);

// The factors of TILT=<name>; the name is at `offset`. Empty if the file is not available, which is reported.
Result<IesTilt> read_tilt_beside(std::string_view name, std::size_t offset, const ReadBeside& read_beside,
                                 Report& report);

// Reports that the last token read by `numbers` is not a number, or not a finite one.
Unexpected not_a_number(const NumberScanner& numbers, Token token, Report& report);

// Places in the file, for reports made after the whole file was read.
struct TablePlaces {
    std::size_t header = 0; // first number after TILT
    std::size_t shape = 0;  // width of the luminous opening
    std::size_t vertical = 0;
    std::size_t last_vertical = 0;
    std::size_t horizontal = 0;
    std::size_t last_horizontal = 0;
    std::size_t candela = 0;
    std::size_t first_negative = no_place;
    double peak = 0.0; // the largest magnitude in the table
};

// Marks the places in a readable table that are needed when its light is known.
inline void mark_table(const TablePlaces& places, Report& report) {
    report.mark(ProfileField::first_vertical, places.vertical);
    report.mark(ProfileField::last_vertical, places.last_vertical);
    report.mark(ProfileField::first_horizontal, places.horizontal);
    report.mark(ProfileField::last_horizontal, places.last_horizontal);
    report.mark(ProfileField::intensity, places.candela);
    report.mark(ProfileField::negative_intensity, places.first_negative);
}

struct LdtPlaces : TablePlaces {
    std::size_t light_output_ratio = 0;
    std::size_t conversion_factor = 0;
    std::size_t tilt = 0;
    std::size_t direct_ratios = 0;
};

// Reports anything odd about a table that could be read: ranges, missing planes, poles that disagree, no light.
void check_ies(const IesFile& file, const TablePlaces& places, Report& report);
void check_ldt(const LdtFile& file, const LdtPlaces& places, Report& report);

// The shape that the signs of the dimensions encode in the file's edition; nothing if it has no such code.
std::optional<OpeningShape> ies_opening_shape(const IesFile& file);

// By the table of LM-63-1995, which files of other editions use too.
std::optional<OpeningShape> opening_shape_of_1995(const IesFile& file);

// The places of an emitter's luminous intensity and its symmetry.
struct Tm33Places {
    std::size_t table = no_place;
    std::size_t symmetry = no_place;
    std::size_t multiplier = no_place;
};

// Planes and poles are checked for type C only.
void check_tm33_intensity(const Tm33Emitter& emitter, bool of_type_c, const Tm33Places& places, Report& report);

// The results for a table of `planes` rows that the checks need.
struct Poles {
    // The spread of the planes' values over the peak.
    double at_nadir = 0.0;
    double at_zenith = 0.0;
    bool all_zero = true;

    // Goniometers differ by less from plane to plane.
    bool differ() const { return std::max(at_nadir, at_zenith) > 0.01; }
    // "the planes differ by 3.1 % of the peak at nadir"
    std::string difference() const;
};

// `gammas_deg` are type C angles; a pole is checked only if the table reaches it. `peak` is the largest magnitude.
Poles look_at_poles(const std::vector<double>& gammas_deg, const std::vector<double>& table, double peak);

} // namespace gonio::profile_detail
