// GLDF: a luminaire as a manufacturer publishes it, an archive of product.xml, photometric files, spectra, geometry,
// pictures.
//
// What product.xml says about light is read: files, photometries, spectra, light sources, emitters, variants. Files are
// found in the folder of their content type ("ldc/eulumdat": ldc/); addresses on the network are never opened. The
// archive is hostile: gonio/base/archive.hpp. Texts are cut to 256 bytes. What departs from the schema is a diagnostic
// of the family GLD, and with `strict` an error.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/read.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

class Archive;

// A file that product.xml names.
struct GldfFile {
    std::string id;
    std::string content_type; // "ldc/eulumdat"
    std::string written;      // the name, or the address, as written
    std::string entry;        // in the archive; empty: not there
    bool is_address = false;  // on the network
};

// A light distribution, or only descriptive values.
struct GldfPhotometry {
    std::string id;
    std::optional<std::size_t> file; // of Gldf::files, if it is there
};

// A spectrum: a file, or intensities over wavelengths.
struct GldfSpectrum {
    std::string id;
    std::optional<std::size_t> file;
    std::vector<double> wavelengths_nm; // as written
    std::vector<double> intensities;
};

// Light that leaves an emitter. An emitter has several where it shines in another way in an emergency.
struct GldfLight {
    std::string kind;                      // "fixed", "changeable", "multi-channel"
    std::string name;                      // may be empty
    std::string emergency;                 // as written: "None", "Combined", "EmergencyOnly"; may be empty
    std::optional<std::size_t> photometry; // of Gldf::photometries
    std::optional<double> flux_lm;         // of the emitter, as stated; of a changeable one, of all its lamps
    std::optional<double> emergency_flux_lm;
    std::optional<double> cct_k; // of its light source
    std::optional<double> cri;
    std::optional<double> input_w;       // of its light sources or its equipment
    std::optional<std::size_t> spectrum; // of Gldf::spectra
    bool is_turned = false;              // it has a rotation other than 0
    glm::dvec3 rotation_deg{0.0};        // about X, Y and Z, as written
    Location location;
};

// What shines in a luminaire.
struct GldfEmitter {
    std::string id;
    std::vector<GldfLight> lights; // sensors are left out
};

// A luminaire of the product's range.
struct GldfVariant {
    std::string id;
    std::string name;
    std::string number;
    std::vector<std::size_t> emitters; // of Gldf::emitters, in the order of the file; repeated as often as it has them
    Location location;
};

// What a GLDF says.
struct Gldf {
    std::string source;
    std::string version;      // "1.0-rc.3"; empty: not stated
    std::string manufacturer; // may be empty, as the texts below
    std::string generator;
    std::string name;
    std::string number;
    std::vector<GldfFile> files;
    std::vector<GldfPhotometry> photometries;
    std::vector<GldfSpectrum> spectra;
    std::vector<GldfEmitter> emitters;
    std::vector<GldfVariant> variants;
    Diagnostics diagnostics;
};

// Whether the bytes are an archive with a product.xml. False for a broken archive.
bool is_gldf(std::string_view bytes);

// Fails (malformed, unsupported) on a broken archive or document, and with `strict` on departures from the schema.
Result<Gldf> read_gldf(std::string_view bytes, const std::string& source, bool strict = false);
Result<Gldf> read_gldf(const Archive& archive, bool strict = false); // of one that is open

// The variant of that identifier, else of that name; the first where the text is empty, and null if there is none.
// Fails (usage) on a name that the GLDF does not have.
Result<const GldfVariant*> choose_variant(const Gldf& gldf, const std::string& name);

// Reads the files in the folder of an entry of the archive, which must outlive it: factors of TILT.
ReadBeside reader_in(const Archive& archive, const std::string& entry);

// One photometric file, and what names it.
struct GldfProfile {
    std::string name; // "lamp.gldf/ldc/lamp.ldt"
    std::string bytes;
    Diagnostics diagnostics; // of the document, and whether the file is one of several or not the first light's
};

// The photometric file of an emitter of a variant or of the whole product, by identifier or name. With neither, that of
// the first light of the first variant, or of the next light that has a file. Fails as read_gldf() does, (usage) on a
// name that the GLDF does not have, and (malformed) if the first light of what was asked for has no photometric file.
Result<GldfProfile> gldf_profile(const Archive& archive, const GldfChoice& choice = {}, bool strict = false);

// What a written GLDF says besides its profile.
struct GldfProduct {
    std::string manufacturer;
    std::string name;
    std::string number;
    std::string file;     // of the profile: "lamp.ldt"; its ending decides the content type
    double flux_lm = 0.0; // of the luminaire, stated in whole lumens
    std::optional<double> cct_k;
    std::optional<double> cri;
    std::optional<double> input_w;
};

// A minimal GLDF: the profile, one emitter, one variant. The same input gives the same bytes: instead of the time it
// has the date of this version of gonio, and its identifier is made of the content. Texts must be UTF-8; those that are
// empty are written as "-", since the schema wants some.
std::string write_gldf(std::string_view profile, const GldfProduct& product);

} // namespace gonio
#pragma GCC visibility pop
