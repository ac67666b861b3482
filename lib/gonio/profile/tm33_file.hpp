// ANSI/IES TM-33 (also ATLA S001, UNI 11733): luminaire optical data in XML.
//
// The data that gonio uses is in fields; everything else of the document (other quantities, foreign elements and
// attributes, comments) stays in `document` and is written back in its place. A field that differs from the document
// wins: writing puts it into its element, which is created at the schema's place if it is missing, and removed if the
// field is empty. Lengths in metres, angles in degrees, wavelengths in nanometres.
#pragma once

#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A factor on the whole table for each tilt of the lamp: TILT of LM-63, TiltAngles of TM-33.
struct IesTilt {
    int lamp_to_luminaire_geometry = 1; // 1, 2 or 3; LM-63 only
    std::vector<double> angles_deg;
    std::vector<double> factors;

    bool operator==(const IesTilt&) const = default;
};

// An element that holds text.
struct Tm33Text {
    std::string name; // of the element: "Manufacturer", "Comment"
    std::string text;

    bool operator==(const Tm33Text&) const = default;
};

// The stated symmetry; the planes in the table have priority.
enum class Tm33Symmetry { none, bilateral_0, bilateral_90, quadrant, full, arbitrary };

// The table of an emitter.
struct Tm33Intensity {
    std::optional<bool> absolute; // false: measured relative to the rated lumens of the emitter
    std::optional<Tm33Symmetry> symmetry;
    std::string photometry_type;      // of the programs' dialect; TM-33 states it once, as the goniometer
    std::optional<double> multiplier; // 1 if absent
    std::vector<double> horizontal_deg;
    std::vector<double> vertical_deg;
    std::vector<double> candela; // [horizontal][vertical], before the multiplier

    bool operator==(const Tm33Intensity&) const = default;
};

// The spectrum of an emitter.
struct Tm33Spectrum {
    std::string emitter_name;
    std::optional<double> multiplier; // 1 if absent
    std::optional<bool> normalized;
    std::vector<double> wavelengths_nm;
    std::vector<double> power; // same count as wavelengths; watts per nanometre, or relative

    bool operator==(const Tm33Spectrum&) const = default;
};

// A rectangle of the bottom face that emits light, or an ellipse in it.
struct Tm33Area {
    double length_m = 0.0;
    double width_m = 0.0;
    bool circular = false;

    bool operator==(const Tm33Area&) const = default;
};

// An emitter of a TM-33 document.
struct Tm33Emitter {
    std::string description;
    std::string catalog_number;
    std::optional<double> quantity;     // does not scale the intensity
    std::optional<double> rated_lumens; // of one
    std::optional<double> input_watts;
    std::optional<double> power_factor;
    std::optional<double> ballast_factor; // scales the intensity; 1 if absent
    std::optional<double> cct_k;
    std::optional<double> min_cct_k; // of a tunable emitter
    std::optional<double> max_cct_k;
    std::optional<double> duv;
    std::optional<double> cri_ra;
    std::optional<double> cri_r9;
    std::optional<double> tm30_rf;
    std::optional<double> tm30_rg;
    std::optional<double> sp_ratio;
    std::optional<double> luminous_flux_lm; // measured
    IesTilt tilt;
    std::optional<Tm33Intensity> intensity; // luminous; radiant and photon intensities stay in the document
    std::vector<Tm33Spectrum> spectra;
    std::vector<Tm33Area> bottom_areas;

    bool operator==(const Tm33Emitter&) const = default;
};

// A TM-33 document as written.
struct Tm33File {
    std::string root = "IESTM33-22"; // name of the outermost element, which identifies the edition
    std::string version = "1.1";
    std::vector<Tm33Text> header;   // in the file's order, repeats kept
    std::optional<double> length_m; // of the luminaire
    std::optional<double> width_m;
    std::optional<double> height_m;
    std::optional<double> emitter_count;
    std::string goniometer; // "IES_C", "CIE_C", …; empty: C
    std::vector<Tm33Emitter> emitters;
    std::string document; // the XML without the tables of intensity and spectra; empty: built from the fields

    bool operator==(const Tm33File&) const = default;
};

// "TM-33-18" or "TM-33-23", by the outermost element.
const char* edition(const Tm33File& file);

} // namespace gonio
#pragma GCC visibility pop
