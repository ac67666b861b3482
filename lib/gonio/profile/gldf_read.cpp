#include <gonio/base/archive.hpp>
#include <gonio/base/archive_xml.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/profile/gldf.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace gonio {

namespace {

constexpr std::string_view product_file = "product.xml";

// Identifiers, file names and texts are cut to this: each may be repeated for every light.
constexpr std::size_t longest_text = 256;

// Short, for messages.
std::string shown(std::string_view text) {
    return shown_text(text, 60);
}

std::string short_text(pugi::xml_node node) {
    return std::string(cut_text(text_in(node), longest_text));
}

using Ids = std::map<std::string, std::size_t, std::less<>>;

// What a light source states, whichever kind it is.
struct LightSource {
    std::optional<double> flux_lm;
    std::optional<double> cct_k;
    std::optional<double> cri;
    std::optional<double> input_w;
    std::optional<std::size_t> spectrum;
};

class GldfReader {
public:
    GldfReader(const Archive& archive, ArchiveXml& xml, bool strict) : archive_(archive), xml_(xml), strict_(strict) {}

    Result<Gldf> read() {
        const pugi::xml_node root = xml_.root();
        gldf_.source = archive_.source();
        const pugi::xml_node header = required(root, "Header");
        const pugi::xml_node general = required(root, "GeneralDefinitions");
        const pugi::xml_node product = required(root, "ProductDefinitions");
        read_header(header);
        read_files(general.child("Files"));
        read_photometries(general.child("Photometries"));
        read_spectra(general.child("Spectrums"));
        read_sources(general.child("LightSources"));
        read_equipment(general.child("Equipments"));
        read_emitters(general.child("Emitters"));
        const pugi::xml_node data = required(product, "ProductMetaData");
        gldf_.name = located(required(data, "Name"));
        gldf_.number = located(required(data, "ProductNumber"));
        read_variants(required(product, "Variants"));
        look_for_others();
        close_counts();
        if (has_error_) {
            // The reason of an Error is its last error.
            std::stable_partition(gldf_.diagnostics.begin(), gldf_.diagnostics.end(),
                                  [](const Diagnostic& d) { return d.severity != Severity::error; });
            return Unexpected(Error(Failure::malformed, std::move(gldf_.diagnostics)));
        }
        return std::move(gldf_);
    }

private:
    // A file of a million faults gives a few sentences: the first of each code, and how many more.
    void say(ArchiveCode code, pugi::xml_node at, std::string message) {
        constexpr std::size_t most = 8;
        std::size_t& count = counts_[code->code];
        if (++count > most) return;
        const Severity severity = strict_ ? code->strict_severity() : code->severity;
        has_error_ = has_error_ || severity == Severity::error;
        Diagnostic said;
        said.code = code->code;
        said.severity = severity;
        said.location = at ? xml_.place(at) : Location{archive_.source(), 0, 0};
        said.message = std::move(message);
        last_[code->code] = gldf_.diagnostics.size();
        gldf_.diagnostics.push_back(std::move(said));
    }

    void close_counts() {
        constexpr std::size_t most = 8;
        for (const auto& [code, count] : counts_)
            if (count > most) gldf_.diagnostics[last_[code]].message += fmt::format(" (and {} more)", count - most);
    }

    pugi::xml_node required(pugi::xml_node parent, const char* name) {
        const pugi::xml_node child = parent.child(name);
        if (parent && !child) say("GLD0201", parent, fmt::format("'{}' has no '{}'", parent.name(), name));
        return child;
    }

    std::string required_attribute(pugi::xml_node node, const char* name) {
        const std::string_view value = node.attribute(name).value();
        if (node && value.empty()) say("GLD0201", node, fmt::format("'{}' has no {}", shown(node.name()), name));
        if (value.size() <= longest_text) return std::string(value);
        say("GLD0204", node, fmt::format("{} is longer than {} bytes: '{}…'", name, longest_text, shown(value)));
        return {};
    }

    // Of texts in several languages: English, else the first.
    static std::string located(pugi::xml_node node) {
        std::string_view text = text_in(node);
        for (const pugi::xml_node locale : node.children("Locale")) {
            if (text.empty()) text = text_in(locale);
            if (starts_with_any_case(locale.attribute("language").value(), "en")) {
                text = text_in(locale);
                break;
            }
        }
        return std::string(cut_text(text, longest_text));
    }

    // A number of 0 or more; nothing if the element is missing or holds none.
    std::optional<double> number(pugi::xml_node node) {
        if (!node) return std::nullopt;
        const std::optional<double> value = parse_number(text_in(node));
        if (!value || !(*value >= 0.0) || !(*value <= 1e30)) {
            say("GLD0204", node,
                fmt::format("'{}' is '{}', not a number of 0 or more", node.name(), shown(text_in(node))));
            return std::nullopt;
        }
        return value;
    }

    // The identifier of an element, kept if it is new.
    std::string new_id(pugi::xml_node node, Ids& ids, std::size_t index) {
        std::string id = required_attribute(node, "id");
        if (!id.empty() && !ids.try_emplace(id, index).second)
            say("GLD0203", node, fmt::format("the identifier '{}' is given twice", shown(id)));
        return id;
    }

    std::optional<std::size_t> referred(pugi::xml_node node, const char* attribute, const Ids& ids,
                                        std::string_view what) {
        const std::string id = required_attribute(node, attribute);
        if (id.empty()) return std::nullopt;
        const auto found = ids.find(id);
        if (found != ids.end()) return found->second;
        say("GLD0202", node, fmt::format("there is no {} '{}'", what, shown(id)));
        return std::nullopt;
    }

    void read_header(pugi::xml_node header) {
        if (!header) return;
        gldf_.manufacturer = short_text(required(header, "Manufacturer"));
        gldf_.generator = short_text(required(header, "CreatedWithApplication"));
        if (!header.child("CreationTimeCode")) required(header, "GldfCreationTimeCode"); // the first release candidate
        const pugi::xml_node version = required(header, "FormatVersion");
        if (!version) return;
        // Release candidates wrote it as text first.
        if (version.attribute("major")) {
            gldf_.version = fmt::format("{}.{}", shown(version.attribute("major").value()),
                                        shown(version.attribute("minor").as_string("0")));
            if (const pugi::xml_attribute candidate = version.attribute("pre-release");
                candidate && std::string_view(candidate.value()) != "0")
                gldf_.version += fmt::format("-rc.{}", shown(candidate.value()));
        } else {
            gldf_.version = shown(text_in(version));
        }
        if (!gldf_.version.starts_with("1.0") && !gldf_.version.starts_with("0.9"))
            say("GLD0210", version, fmt::format("the version of GLDF is '{}'; gonio knows 1.0", gldf_.version));
    }

    // In the folder of the content type, else by its name alone.
    std::string entry_of(const GldfFile& file) const {
        const std::string folder = file.content_type.substr(0, file.content_type.find('/'));
        for (const std::string& name :
             {folder + "/" + file.written, folder == "document" ? "doc/" + file.written : std::string(), file.written})
            if (const ArchiveEntry* const entry = name.empty() ? nullptr : archive_.find(name)) return entry->name;
        return {};
    }

    void read_files(pugi::xml_node files) {
        for (const pugi::xml_node node : files.children("File")) {
            GldfFile file;
            file.id = new_id(node, file_ids_, gldf_.files.size());
            file.content_type = to_lower(required_attribute(node, "contentType"));
            const std::string_view written = text_in(node);
            file.written = cut_text(written, longest_text);
            const std::string type = required_attribute(node, "type");
            file.is_address = equals_any_case(type, "url") || file.written.find("://") != std::string::npos;
            const bool is_too_long = written.size() > longest_text;
            if (!type.empty() && !equals_any_case(type, "url") && !equals_any_case(type, "localFileName"))
                say("GLD0204", node,
                    fmt::format("the type of a file is '{}', neither localFileName nor url", shown(type)));
            if (file.is_address) {
                say("GLD0206", node, fmt::format("the file '{}' is an address on the network", shown(file.id)));
            } else if (is_too_long) {
                say("GLD0204", node,
                    fmt::format("a file name is longer than {} bytes: '{}…'", longest_text, shown(written)));
            } else {
                file.entry = entry_of(file);
                if (file.entry.empty())
                    say("GLD0205", node, fmt::format("the file '{}' is not in the archive", shown(file.written)));
                else
                    named_.insert(file.entry);
            }
            gldf_.files.push_back(std::move(file));
        }
    }

    // Of the element that names a file, if that is in the archive.
    std::optional<std::size_t> file_of(pugi::xml_node reference) {
        const std::optional<std::size_t> file = referred(reference, "fileId", file_ids_, "file");
        if (!file || gldf_.files[*file].entry.empty()) return std::nullopt;
        return file;
    }

    void read_photometries(pugi::xml_node all) {
        for (const pugi::xml_node node : all.children("Photometry")) {
            GldfPhotometry photometry;
            photometry.id = new_id(node, photometry_ids_, gldf_.photometries.size());
            if (const pugi::xml_node reference = node.child("PhotometryFileReference")) {
                photometry.file = file_of(reference);
                if (photometry.file && !gldf_.files[*photometry.file].content_type.starts_with("ldc")) {
                    say("GLD0204", reference,
                        fmt::format("the photometric file '{}' has the content type '{}', not ldc/…",
                                    shown(gldf_.files[*photometry.file].id),
                                    shown(gldf_.files[*photometry.file].content_type)));
                    photometry.file.reset();
                }
            } else if (!node.child("DescriptivePhotometry")) {
                say("GLD0201", node, "'Photometry' has neither a file nor descriptive values");
            }
            gldf_.photometries.push_back(std::move(photometry));
        }
    }

    void read_spectra(pugi::xml_node all) {
        for (const pugi::xml_node node : all.children("Spectrum")) {
            GldfSpectrum spectrum;
            spectrum.id = new_id(node, spectrum_ids_, gldf_.spectra.size());
            // A file beside intensities is where they come from.
            if (const pugi::xml_node reference = node.child("SpectrumFileReference");
                reference && !node.child("Intensity")) {
                spectrum.file = file_of(reference);
            } else {
                for (const pugi::xml_node one : node.children("Intensity")) {
                    const std::optional<double> wavelength = parse_number(one.attribute("wavelength").value());
                    const std::optional<double> intensity = parse_number(text_in(one));
                    if (!wavelength || !intensity || !(*wavelength > 0.0) || !(*intensity >= 0.0)) {
                        say("GLD0204", one, "an intensity of a spectrum is not a number over a wavelength");
                        continue;
                    }
                    spectrum.wavelengths_nm.push_back(*wavelength);
                    spectrum.intensities.push_back(*intensity);
                }
                if (spectrum.intensities.empty()) say("GLD0201", node, "'Spectrum' has neither a file nor intensities");
            }
            gldf_.spectra.push_back(std::move(spectrum));
        }
    }

    void read_sources(pugi::xml_node all) {
        for (const pugi::xml_node node : all.children()) {
            const std::string_view name = node.name();
            if (!name.ends_with("LightSource")) continue;
            new_id(node, source_ids_, sources_.size());
            LightSource source;
            source.flux_lm = number(node.child("RatedLuminousFlux"));
            source.input_w = number(node.child("RatedInputPower"));
            if (const pugi::xml_node color = node.child("ColorInformation")) {
                source.cct_k = number(color.child("CorrelatedColorTemperature"));
                source.cri = number(color.child("ColorRenderingIndex"));
            }
            if (const pugi::xml_node reference = node.child("SpectrumReference"))
                source.spectrum = referred(reference, "spectrumId", spectrum_ids_, "spectrum");
            sources_.push_back(source);
        }
    }

    // Of the light sources that a reference means: one where it does not say.
    double count_of(pugi::xml_node reference) {
        const pugi::xml_attribute written = reference.attribute("lightSourceCount");
        if (!written) return 1.0;
        const std::optional<double> count = parse_number(trimmed(written.value()));
        if (count && *count >= 1.0 && *count <= 1e6) return *count;
        say("GLD0204", reference,
            fmt::format("lightSourceCount is '{}', not a number from 1 to 1000000: 1 is taken",
                        shown(written.value())));
        return 1.0;
    }

    static LightSource several(const LightSource& source, double count) {
        LightSource together = source;
        if (together.flux_lm) together.flux_lm = *together.flux_lm * count;
        if (together.input_w) together.input_w = *together.input_w * count;
        return together;
    }

    // As one light source: its lamps together.
    void read_equipment(pugi::xml_node all) {
        for (const pugi::xml_node node : all.children("Equipment")) {
            new_id(node, equipment_ids_, equipment_.size());
            LightSource together;
            if (const pugi::xml_node reference = required(node, "LightSourceReference")) {
                const char* const attribute =
                    reference.attribute("changeableLightSourceId") ? "changeableLightSourceId" : "fixedLightSourceId";
                if (const auto source = referred(reference, attribute, source_ids_, "light source"))
                    together = several(sources_[*source], count_of(reference));
            }
            if (const auto input = number(node.child("RatedInputPower"))) together.input_w = input;
            equipment_.push_back(together);
        }
    }

    void read_rotation(pugi::xml_node node, GldfLight& light) {
        glm::length_t at = 0;
        for (const char* const axis : {"X", "Y", "Z"}) {
            const pugi::xml_node child = node.child(axis);
            const std::optional<double> value = parse_number(text_in(child));
            if (child && (!value || !(*value >= -3600.0 && *value <= 3600.0)))
                say("GLD0204", child, fmt::format("a rotation is '{}'", shown(text_in(child))));
            else
                light.rotation_deg[at] = value.value_or(0.0);
            light.is_turned = light.is_turned || light.rotation_deg[at] != 0.0;
            ++at;
        }
    }

    void read_emitters(pugi::xml_node all) {
        for (const pugi::xml_node node : all.children("Emitter")) {
            GldfEmitter emitter;
            emitter.id = new_id(node, emitter_ids_, gldf_.emitters.size());
            bool has_any = false;
            for (const pugi::xml_node child : node.children()) {
                const std::string_view name = child.name();
                has_any = has_any || child.type() == pugi::node_element;
                if (name == "FixedLightEmitter" || name == "ChangeableLightEmitter" ||
                    name == "MultiChannelLightEmitter")
                    emitter.lights.push_back(read_light(child));
            }
            if (!has_any) say("GLD0201", node, "'Emitter' has neither light nor a sensor");
            gldf_.emitters.push_back(std::move(emitter));
        }
    }

    GldfLight read_light(pugi::xml_node node) {
        const std::string_view name = node.name();
        GldfLight light;
        light.location = xml_.place(node);
        light.kind = name == "FixedLightEmitter"        ? "fixed"
                     : name == "ChangeableLightEmitter" ? "changeable"
                                                        : "multi-channel";
        light.name = located(node.child("Name"));
        light.emergency = shown(node.attribute("emergencyBehaviour").value());
        if (const pugi::xml_node rotation = node.child("Rotation")) read_rotation(rotation, light);
        // A light of several channels has its photometry in each of them; the first one's is as good as any.
        pugi::xml_node reference = node.child("PhotometryReference");
        if (!reference && light.kind == "multi-channel")
            reference = node.child("Channels").child("Channel").child("PhotometryReference");
        if (reference)
            light.photometry = referred(reference, "photometryId", photometry_ids_, "photometry");
        else
            say("GLD0201", node, fmt::format("'{}' has no 'PhotometryReference'", name));
        LightSource source;
        if (const pugi::xml_node equipment = node.child("EquipmentReference")) {
            if (const auto found = referred(equipment, "equipmentId", equipment_ids_, "equipment"))
                source = equipment_[*found];
        } else if (const pugi::xml_node lamps = node.child("LightSourceReference")) {
            const char* const attribute = lamps.attribute("fixedLightSourceId")          ? "fixedLightSourceId"
                                          : lamps.attribute("multiChannelLightSourceId") ? "multiChannelLightSourceId"
                                                                                         : "changeableLightSourceId";
            if (const auto found = referred(lamps, attribute, source_ids_, "light source"))
                source = several(sources_[*found], count_of(lamps));
        }
        light.flux_lm = light.kind == "changeable" ? source.flux_lm : number(node.child("RatedLuminousFlux"));
        light.emergency_flux_lm = number(node.child("EmergencyRatedLuminousFlux"));
        light.cct_k = source.cct_k;
        light.cri = source.cri;
        light.input_w = source.input_w;
        light.spectrum = source.spectrum;
        return light;
    }

    // References to emitters are anywhere in the geometry of a variant.
    void read_variants(pugi::xml_node all) {
        for (const pugi::xml_node node : all.children("Variant")) {
            GldfVariant variant;
            variant.id = new_id(node, variant_ids_, gldf_.variants.size());
            variant.location = xml_.place(node);
            variant.name = located(node.child("Name"));
            variant.number = located(node.child("ProductNumber"));
            bool names_any = false;
            const pugi::xml_node geometry = node.child("Geometry");
            for (pugi::xml_node at = geometry.first_child(); at;) {
                if (const pugi::xml_attribute id = at.attribute("emitterId"); id && *id.value() != '\0') {
                    names_any = true;
                    if (const auto emitter = referred(at, "emitterId", emitter_ids_, "emitter"))
                        variant.emitters.push_back(*emitter);
                }
                pugi::xml_node next = at.first_child();
                while (!next && at != geometry) {
                    next = at.next_sibling();
                    at = at.parent();
                }
                if (at == geometry && !next) break;
                at = next;
            }
            // Files of others often leave the emitters to the geometry.
            if (!names_any && !gldf_.emitters.empty()) {
                say("GLD0201", node, "'Variant' names no emitter: those of the whole file are taken");
                // Many variants of many emitters would be far more than the document has.
                constexpr std::size_t most = std::size_t{1} << 20U;
                for (std::size_t i = 0; i < gldf_.emitters.size() && given_ < most; ++i, ++given_)
                    variant.emitters.push_back(i);
            }
            gldf_.variants.push_back(std::move(variant));
        }
        if (all && gldf_.variants.empty()) say("GLD0201", all, "'Variants' has no 'Variant'");
    }

    void look_for_others() {
        for (const ArchiveEntry& entry : archive_.entries())
            if (!named_.contains(entry.name) && !equals_any_case(entry.name, product_file) &&
                !equals_any_case(entry.name, "meta-information.xml"))
                say("GLD0207", {},
                    fmt::format("'{}' is in the archive, but product.xml does not name it", shown(entry.name)));
    }

    const Archive& archive_;
    ArchiveXml& xml_;
    bool strict_;
    bool has_error_ = false;
    Gldf gldf_;
    Ids file_ids_;
    Ids photometry_ids_;
    Ids spectrum_ids_;
    Ids source_ids_;
    Ids equipment_ids_;
    Ids emitter_ids_;
    Ids variant_ids_;
    std::size_t given_ = 0; // emitters to variants that name none
    std::vector<LightSource> sources_;
    std::vector<LightSource> equipment_;
    std::set<std::string, std::less<>> named_; // entries of the archive
    std::map<std::string_view, std::size_t> counts_;
    std::map<std::string_view, std::size_t> last_;
};

// By identifier, else by name.
template<class Item, class NameOf>
Result<std::size_t> chosen(std::string_view what, const std::string& wanted, const std::vector<Item>& items,
                           const NameOf& name_of) {
    constexpr std::size_t most_names = 100;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].id == wanted) return i;
        if (names.size() < most_names) names.push_back(items[i].id);
    }
    for (std::size_t i = 0; i < items.size(); ++i)
        if (name_of(items[i]) == wanted) return i;
    return unknown_name(what, wanted, names);
}

// A light, where it is, and its photometric file.
struct LightAt {
    std::size_t emitter = 0;
    std::optional<std::size_t> file;
};

// Each emitter's once, however often a variant has it.
std::vector<LightAt> lights_of(const Gldf& gldf, const std::vector<std::size_t>& emitters) {
    std::vector<LightAt> lights;
    std::vector<bool> is_seen(gldf.emitters.size());
    for (const std::size_t emitter : emitters) {
        if (is_seen[emitter]) continue;
        is_seen[emitter] = true;
        for (const GldfLight& light : gldf.emitters[emitter].lights)
            lights.push_back(
                {emitter, light.photometry ? gldf.photometries[*light.photometry].file : std::optional<std::size_t>()});
    }
    return lights;
}

Diagnostic one_of_several(const std::string& source, std::string message) {
    const ArchiveCode code = "GLD0209";
    Diagnostic said;
    said.code = code->code;
    said.severity = code->severity;
    said.location = {source, 0, 0};
    said.message = std::move(message);
    said.hint = "'gonio info' lists variants and emitters; --variant and --emitter choose";
    return said;
}

} // namespace

bool is_gldf(std::string_view bytes) {
    if (!is_archive(bytes)) return false;
    const Result<Archive> archive = Archive::open(bytes, "");
    return archive && archive->find(product_file) != nullptr;
}

Result<Gldf> read_gldf(std::string_view bytes, const std::string& source, bool strict) {
    Result<Archive> archive = Archive::open(bytes, source);
    if (!archive) return pass_on(archive);
    return read_gldf(*archive, strict);
}

Result<Gldf> read_gldf(const Archive& archive, bool strict) {
    Result<std::unique_ptr<ArchiveXml>> xml = ArchiveXml::read(archive, product_file, "Root");
    if (!xml) return pass_on(xml);
    return GldfReader(archive, **xml, strict).read();
}

Result<const GldfVariant*> choose_variant(const Gldf& gldf, const std::string& name) {
    if (name.empty()) return gldf.variants.empty() ? nullptr : gldf.variants.data();
    Result<std::size_t> variant =
        chosen("variant", name, gldf.variants, [](const GldfVariant& one) { return std::string_view(one.name); });
    if (!variant) return pass_on(variant);
    return &gldf.variants[*variant];
}

ReadBeside reader_in(const Archive& archive, const std::string& entry) {
    return [&archive, folder = entry.substr(0, entry.rfind('/') + 1)](const std::string& name) -> Result<std::string> {
        const ArchiveEntry* const beside = archive.find(folder + name);
        if (beside == nullptr) return fail("FIL0101", "the archive has no such file", {}, name);
        if (beside->size > limit("tilt-bytes").value)
            return fail("FIL0104", fmt::format("larger than {}", to_text(limit("tilt-bytes"))),
                        std::string(limits_hint), name);
        return archive.read(*beside);
    };
}

Result<GldfProfile> gldf_profile(const Archive& archive, const GldfChoice& choice, bool strict) {
    const std::string& source = archive.source();
    Result<Gldf> gldf = read_gldf(archive, strict);
    if (!gldf) return pass_on(gldf);
    GldfProfile profile;
    profile.diagnostics = std::move(gldf->diagnostics);
    const Result<const GldfVariant*> variant = choose_variant(*gldf, choice.variant);
    if (!variant) return Unexpected(variant.error());
    std::vector<std::size_t> all(gldf->emitters.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const bool is_of_variant = *variant != nullptr && (choice.emitter.empty() || !choice.variant.empty());
    std::vector<std::size_t> emitters = is_of_variant ? (*variant)->emitters : all;
    std::string of;
    if (!choice.variant.empty()) of = fmt::format(" of variant '{}'", shown(choice.variant));
    if (!choice.emitter.empty()) {
        Result<std::size_t> emitter = chosen("emitter", choice.emitter, gldf->emitters, [](const GldfEmitter& one) {
            return one.lights.empty() ? std::string_view() : std::string_view(one.lights.front().name);
        });
        if (!emitter) return pass_on(emitter);
        if (std::find(emitters.begin(), emitters.end(), *emitter) == emitters.end())
            return fail("USE0103",
                        fmt::format("variant '{}' has no emitter '{}'", shown(choice.variant), shown(choice.emitter)));
        emitters = {*emitter};
        of += fmt::format(" of emitter '{}'", shown(choice.emitter));
    }
    const bool is_asked_for = !of.empty();
    std::vector<LightAt> lights = lights_of(*gldf, emitters);
    const auto has_file = [](const LightAt& light) { return light.file.has_value(); };
    // Another than what was asked for would be a wrong answer.
    if (is_asked_for && (lights.empty() || !has_file(lights.front())))
        return archive_error("GLD0101", {source, 0, 0},
                             lights.empty() ? fmt::format("the GLDF has no light{}", of)
                                            : fmt::format("the first light{} has no photometric file", of));
    const std::optional<std::size_t> first =
        lights.empty() ? std::optional<std::size_t>() : std::optional(lights.front().emitter);
    auto taken = std::find_if(lights.begin(), lights.end(), has_file);
    if (taken == lights.end()) {
        lights = lights_of(*gldf, all);
        taken = std::find_if(lights.begin(), lights.end(), has_file);
    }
    std::optional<std::size_t> index;
    if (taken != lights.end()) index = taken->file;
    // Photometries without an emitter are better than nothing.
    for (const GldfPhotometry& photometry : gldf->photometries)
        if (!index) index = photometry.file;
    if (!index) return archive_error("GLD0101", {source, 0, 0}, "the GLDF has no photometric file");
    const GldfFile& file = gldf->files[*index];
    if (first && (taken == lights.end() || taken->emitter != *first || taken != lights.begin()))
        profile.diagnostics.push_back(one_of_several(
            source, fmt::format("the first light of emitter '{}' has no photometric file: '{}'{} is taken",
                                shown(gldf->emitters[*first].id), shown(file.entry),
                                taken == lights.end()
                                    ? std::string()
                                    : fmt::format(" of emitter '{}'", shown(gldf->emitters[taken->emitter].id)))));
    const ArchiveEntry& entry = *archive.find(file.entry);
    if (entry.size > limit("profile-bytes").value)
        return fail("FIL0104", fmt::format("larger than {}", to_text(limit("profile-bytes"))), std::string(limits_hint),
                    archive.name_of(entry));
    Result<std::string> read = archive.read(entry);
    if (!read) return pass_on(read);
    profile.bytes = std::move(*read);
    profile.name = archive.name_of(entry);
    std::set<std::size_t> files;
    for (const LightAt& light : lights_of(*gldf, is_asked_for ? emitters : all))
        if (light.file) files.insert(*light.file);
    if (taken == lights.end())
        for (const GldfPhotometry& photometry : gldf->photometries)
            if (photometry.file) files.insert(*photometry.file);
    if (files.size() > 1)
        profile.diagnostics.push_back(one_of_several(
            source, fmt::format("'{}' is taken, one of {} photometric files{}", shown(file.entry), files.size(), of)));
    return profile;
}

} // namespace gonio
