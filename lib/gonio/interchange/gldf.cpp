// GLDF: the emitters of a variant as lights, all at the luminaire's origin: where they are inside is in its geometry,
// which is not read. A fixed emitter has the flux that product.xml states; a changeable one has its lamps', times the
// light output ratio of its photometry; both keep the distribution of the photometric file. The colour is that of the
// spectrum, else of the colour temperature.
#include <gonio/base/archive.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/profile/gldf.hpp>
#include <gonio/profile/write.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>

#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace gonio::interchange_detail {

namespace {

// A photometric file of the archive, measured.
struct Measured {
    std::size_t profile = 0; // of FoundScene::profiles
    double flux_lm = 0.0;
    std::optional<double> lamps_lm; // that it declares
    std::string reason;             // why it cannot be used
};

struct ColorOfSpectrum {
    glm::dvec3 color{1.0};
    bool is_clipped = false;
    std::string reason; // why it has none
};

class GldfLights {
public:
    GldfLights(const Gldf& gldf, const Archive& archive, const SceneReadOptions& options)
        : gldf_(gldf), archive_(archive), options_(options) {}

    Result<FoundScene> read() {
        scene_.generator = gldf_.generator;
        scene_.diagnostics = gldf_.diagnostics;
        Result<std::vector<std::size_t>> emitters = emitters_of_variant();
        if (!emitters) return pass_on(emitters);
        for (const std::size_t emitter : *emitters)
            for (const GldfLight& light : gldf_.emitters[emitter].lights) {
                add(gldf_.emitters[emitter], light);
                if (scene_.lights.size() > limit("scene-lights").value)
                    return scene_error("SCN0108", {gldf_.source, 0, 0},
                                       fmt::format("more than {}", to_text(limit("scene-lights"))));
            }
        if (scene_.lights.size() > 1)
            warn(scene_, "SCN0201", {gldf_.source, 0, 0},
                 "where the emitters are is in the geometry, which is not read: all are at the origin");
        return std::move(scene_);
    }

private:
    Result<std::vector<std::size_t>> emitters_of_variant() {
        const Result<const GldfVariant*> variant = choose_variant(gldf_, options_.variant);
        if (!variant) return Unexpected(variant.error());
        if (!options_.variant.empty()) return (*variant)->emitters;
        std::vector<std::size_t> all(gldf_.emitters.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        if (gldf_.variants.empty()) return all;
        const GldfVariant& first = gldf_.variants.front();
        if (gldf_.variants.size() > 1)
            warn(scene_, "SCN0201", first.location,
                 fmt::format("variant '{}' is taken, the first of {}", shown_text(first.id, 60), gldf_.variants.size()),
                 "--variant names another");
        return first.emitters;
    }

    const Measured& measured(std::size_t file) {
        const auto [at, is_new] = measured_.try_emplace(gldf_.files[file].entry);
        Measured& made = at->second;
        if (!is_new) return made;
        const auto because = [&](const Error& error) {
            made.reason = error.diagnostics.empty() ? "cannot be read" : error.diagnostics.back().message;
        };
        const ArchiveEntry& entry = *archive_.find(gldf_.files[file].entry);
        if (entry.size > limit("profile-bytes").value) {
            made.reason = fmt::format("it is larger than {}", to_text(limit("profile-bytes")));
            return made;
        }
        Result<std::string> bytes = archive_.read(entry);
        if (!bytes) return because(bytes.error()), made;
        if (is_archive(*bytes)) {
            made.reason = "it is an archive, not a photometric file";
            return made;
        }
        ReadOptions beside;
        beside.read_beside = reader_in(archive_, entry.name);
        Result<Profile> profile = read_profile(*bytes, archive_.name_of(entry), beside);
        if (!profile) return because(profile.error()), made;
        const Result<ResolvedWeb> resolved = resolve_web(*profile);
        if (!resolved) return because(resolved.error()), made;
        made.flux_lm = flux(resolved->web).value;
        made.lamps_lm = declared_flux_lm(*profile);
        made.profile = scene_.profiles.size();
        FoundProfile found;
        found.name = plain_name(without_extension(file_name(gldf_.files[file].entry)));
        found.ending = profile_ending(*profile);
        found.bytes = write_with_tilt_factors(*profile).value_or(std::move(*bytes));
        scene_.profiles.push_back(std::move(found));
        return made;
    }

    void add(const GldfEmitter& emitter, const GldfLight& of) {
        FoundLight light;
        light.name = of.name.empty() ? emitter.id : of.name;
        light.place = "emitter " + std::string(cut_text(emitter.id, 100));
        light.location = of.location;
        light.kind = of.kind;
        light.stated_amount = of.flux_lm.value_or(0.0);
        light.stated = of.flux_lm ? fmt::format("{} lm", rounded(*of.flux_lm)) : std::string("no flux");
        if (of.cct_k) light.stated += fmt::format(", {} K", rounded(*of.cct_k));
        if (of.is_turned) light.stated += fmt::format(", turned by {}°", numbers_text(of.rotation_deg));
        if (take_profile(light, of)) {
            glm::dmat4 turned(1.0);
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                glm::dvec3 about(0.0);
                about[axis] = 1.0;
                turned = glm::rotate(glm::dmat4(1.0), of.rotation_deg[axis] * std::numbers::pi / 180.0, about) * turned;
            }
            place_light(light, turned, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, 'z', 1.0);
            if (of.is_turned) remark(light, "SCN0201", "its rotation is applied about X first, then about Y and Z");
        }
        if (of.cct_k && *of.cct_k > 0.0) light.temperature = Kelvin(*of.cct_k);
        if (!of.spectrum || !take_spectrum(light, *of.spectrum))
            if (light.temperature) light.color = blackbody_color(light, *of.cct_k);
        if (light.shape && of.emergency == "EmergencyOnly") {
            light.shape.reset();
            remark(light, "SCN0204", "it shines in an emergency only");
        }
        scene_.lights.push_back(std::move(light));
    }

    // The colour of a spectrum; false where it has none, which is said.
    bool take_spectrum(FoundLight& light, std::size_t index) {
        const std::optional<std::size_t> file = gldf_.spectra[index].file;
        const auto [at, is_new] = colors_.try_emplace(file ? gldf_.files[*file].entry : fmt::format(":{}", index));
        ColorOfSpectrum& made = at->second;
        if (is_new) {
            Result<Spectrum> spectrum = spectrum_of(gldf_.spectra[index]);
            Diagnostics clipped;
            Result<glm::dvec3> color =
                spectrum ? light_color_of(*spectrum, &clipped) : Result<glm::dvec3>(pass_on(spectrum));
            made.is_clipped = !clipped.empty();
            if (color)
                made.color = *color;
            else
                made.reason =
                    color.error().diagnostics.empty() ? "it cannot be read" : color.error().diagnostics.back().message;
        }
        if (!made.reason.empty()) {
            remark(light, "SCN0202", fmt::format("its spectrum is left out: {}", made.reason));
            return false;
        }
        if (made.is_clipped) remark(light, "SCN0202", "the colour of its spectrum lies outside Rec.709: clipped to it");
        light.color = made.color;
        return true;
    }

    // As a file has it, or product.xml, by the same rules.
    Result<Spectrum> spectrum_of(const GldfSpectrum& of) {
        std::string text;
        std::string name = gldf_.source + "/product.xml";
        if (of.file) {
            name = gldf_.source + "/" + gldf_.files[*of.file].entry;
            const ArchiveEntry& entry = *archive_.find(gldf_.files[*of.file].entry);
            if (entry.size > limit("spectrum-bytes").value)
                return fail("FIL0104", fmt::format("larger than {}", to_text(limit("spectrum-bytes"))));
            Result<std::string> bytes = archive_.read(entry);
            if (!bytes) return pass_on(bytes);
            text = std::move(*bytes);
        } else {
            for (std::size_t i = 0; i < of.wavelengths_nm.size(); ++i)
                text += fmt::format("{},{}\n", shortest(of.wavelengths_nm[i]), shortest(of.intensities[i]));
        }
        return parse_spectrum_csv(text, name);
    }

    // The distribution and the amount.
    bool take_profile(FoundLight& light, const GldfLight& of) {
        if (!of.photometry || !gldf_.photometries[*of.photometry].file) {
            only_list(
                light,
                of.photometry
                    ? "its photometry has no file that can be read: descriptive values are not a light distribution"
                    : "it has no photometry");
            return false;
        }
        const std::size_t file = *gldf_.photometries[*of.photometry].file;
        const Measured& profile = measured(file);
        if (!profile.reason.empty()) {
            remark(light, "SCN0107",
                   fmt::format("the profile '{}' is not usable: {}", gldf_.files[file].entry, profile.reason));
            return false;
        }
        ProfileShape shape;
        shape.file = gldf_.files[file].entry;
        light.shape = shape;
        light.profile = profile.profile;
        if (of.kind != "changeable") {
            if (!of.flux_lm) return true;
            light.intensity = amount(*of.flux_lm, "lm");
            if (is_off(*of.flux_lm, profile.flux_lm))
                remark(light, "SCN0201",
                       fmt::format("it states {} lm, and its photometry has {} lm: what it states is taken",
                                   rounded(*of.flux_lm), rounded(profile.flux_lm)));
        } else if (of.flux_lm && profile.lamps_lm && *profile.lamps_lm > 0.0) {
            light.intensity = amount(profile.flux_lm * (*of.flux_lm / *profile.lamps_lm), "lm");
        } else if (of.flux_lm) {
            remark(light, "SCN0201", "its photometry is absolute, so the flux of the lamps is not applied");
        } else {
            remark(light, "SCN0201", "it has no lamps: the photometry is taken as measured");
        }
        return true;
    }

    static bool is_off(double stated, double found) {
        return std::abs(stated - found) > 0.01 * std::max(stated, found);
    }

    const Gldf& gldf_;
    const Archive& archive_;
    const SceneReadOptions& options_;
    FoundScene scene_;
    std::map<std::string, Measured> measured_;      // by entry of the archive
    std::map<std::string, ColorOfSpectrum> colors_; // by entry, or by the number of a spectrum in product.xml
};

} // namespace

Result<FoundScene> read_gldf_lights(std::string_view bytes, const std::string& source,
                                    const SceneReadOptions& options) {
    Result<Archive> archive = Archive::open(bytes, source);
    if (!archive) return pass_on(archive);
    const Result<Gldf> gldf = read_gldf(*archive);
    if (!gldf) return Unexpected(gldf.error());
    return GldfLights(*gldf, *archive, options).read();
}

} // namespace gonio::interchange_detail
