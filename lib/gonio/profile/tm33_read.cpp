// TM-33 and related formats: XML, identified by the names of elements.
#include <gonio/base/limits.hpp>
#include <gonio/base/xml_depth.hpp>
#include <gonio/profile/detail/tm33_fields.hpp>
#include <gonio/profile/detail/tm33_table.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/tm33_light.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace gonio::profile_detail {

namespace {

std::string_view trimmed_text(pugi::xml_node node) {
    std::string_view text = node.child_value();
    const auto is_space = [](char c) { return is_blank(c) || c == '\n' || c == '\r'; };
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    return text;
}

bool has_elements(pugi::xml_node node) {
    for (const pugi::xml_node child : node.children())
        if (child.type() == pugi::node_element) return true;
    return false;
}

// Appends to a std::string: pugixml's interface for writing without a stream.
struct StringWriter final : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

class Tm33Parser {
public:
    Tm33Parser(TextRange text, Report& report)
        : report_(report), begin_(text.begin), buffer_(report.bytes().substr(text.begin, text.end - text.begin)) {}

    Result<Tm33File> parse() {
        if (Result<void> read = read_xml(); !read) return pass_on(read);
        const pugi::xml_node root = document_.document_element();
        file_.root = local_name(root.name());
        read_version(root);
        if (const pugi::xml_node header = child_named(root, "Header"))
            for (const pugi::xml_node child : header.children())
                if (child.type() == pugi::node_element && !has_elements(child))
                    file_.header.push_back({std::string(local_name(child.name())), std::string(trimmed_text(child))});
        for (const auto& [paths, member] : luminaire_numbers)
            file_.*member = number_in(first_of(root, paths));
        if (const pugi::xml_node type = first_of(root, goniometer_paths)) file_.goniometer = trimmed_text(type);
        for (const pugi::xml_node child : root.children()) {
            if (child.type() != pugi::node_element || local_name(child.name()) != "Emitter") continue;
            if (Result<void> read = read_emitter(child); !read) return pass_on(read);
        }
        if (file_.emitters.empty()) return report_.fail("TM30105", place(root), "the document describes no emitter");
        check_required(root);
        const bool of_type_c = photometry_of(file_) == Photometry::c;
        for (std::size_t i = 0; i < file_.emitters.size(); ++i)
            check_tm33_intensity(file_.emitters[i], of_type_c, intensity_places_[i], report_);
        if (std::none_of(file_.emitters.begin(), file_.emitters.end(), [](const auto& e) { return !!e.intensity; }))
            report_.add("TM30404", place(root), "no emitter has a luminous intensity");
        if (report_.has_error()) return report_.failure();
        StringWriter skeleton;
        document_.save(skeleton, "", pugi::format_raw | pugi::format_no_declaration, pugi::encoding_utf8);
        file_.document = std::move(skeleton.text);
        return std::move(file_);
    }

private:
    Result<void> read_xml() {
        constexpr unsigned how =
            pugi::parse_default | pugi::parse_comments | pugi::parse_pi | pugi::parse_ws_pcdata_single;
        const pugi::xml_parse_result parsed =
            document_.load_buffer_inplace(buffer_.data(), buffer_.size(), how, pugi::encoding_utf8);
        if (!parsed)
            return report_.fail("TM30101",
                                begin_ + static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)),
                                fmt::format("this is not well-formed XML: {}", parsed.description()));
        const std::string_view root = local_name(document_.document_element().name());
        if (!is_tm33_root(root))
            return report_.fail(
                "TM30102", place(document_.document_element()),
                fmt::format("the root element is {}, which is not from TM-33", quoted(root.substr(0, 40))));
        return check_depth();
    }

    Result<void> check_depth() {
        if (const pugi::xml_node deep = first_too_deep(document_))
            return report_.fail("TM30107", place(deep),
                                fmt::format("elements nested deeper than {}", to_text(limit("xml-depth"))));
        return {};
    }

    [[nodiscard]] std::size_t place(pugi::xml_node node) const {
        const std::ptrdiff_t offset = node.offset_debug();
        if (offset < 0) return no_place;
        return begin_ + static_cast<std::size_t>(offset) - (node.type() == pugi::node_element && offset > 0 ? 1 : 0);
    }

    // The place of a name, a text or an attribute's value, which lie in the buffer; for an element without text, the
    // place of the element.
    [[nodiscard]] std::size_t place(const char* text, pugi::xml_node node) const {
        const char* const first = buffer_.data();
        if (std::less<>()(text, first) || !std::less<>()(text, first + buffer_.size())) return place(node);
        const auto offset = static_cast<std::size_t>(text - first);
        return begin_ + (offset > 0 && text[-1] == '<' ? offset - 1 : offset); // for an element's name, the element
    }

    void read_version(pugi::xml_node root) {
        const pugi::xml_node element = child_named(root, "Version");
        const pugi::xml_attribute attribute = root.attribute("version");
        file_.version = element ? std::string(trimmed_text(element)) : std::string(attribute.value());
        if (file_.version != "1.0" && file_.version != "1.1")
            report_.add("TM30104", element ? place(element) : place(root),
                        file_.version.empty()
                            ? std::string("no version is given")
                            : fmt::format("version {}, known are 1.0 and 1.1", quoted(file_.version.substr(0, 40))));
        if (file_.root == "LuminaireOpticalData")
            report_.add("TM30106", place(root), "the root element is not that of an edition of TM-33");
    }

    std::optional<double> number_in(pugi::xml_node element) {
        if (!element) return std::nullopt;
        const std::string_view text = trimmed_text(element);
        const std::optional<double> value = plain_number(text);
        if (!value)
            report_.add("TM30201", place(text.data(), element),
                        text.empty() ? fmt::format("{} is empty", local_name(element.name()))
                                     : fmt::format("{} is not a number for {}", quoted(text.substr(0, 40)),
                                                   local_name(element.name())));
        return value;
    }

    std::optional<bool> truth_in(pugi::xml_node element) {
        if (!element) return std::nullopt;
        const std::optional<bool> value = truth_of(element.child_value());
        if (!value)
            report_.add("TM30202", place(element.child_value(), element),
                        fmt::format("{} is neither true nor false", quoted(trimmed_text(element).substr(0, 40))));
        return value;
    }

    Result<void> read_emitter(pugi::xml_node element) {
        Tm33Emitter emitter;
        for (const auto& [paths, member] : emitter_texts)
            emitter.*member = trimmed_text(first_of(element, paths));
        for (const auto& [paths, member] : emitter_numbers)
            emitter.*member = number_in(first_of(element, paths));
        if (emitter.quantity && (*emitter.quantity < 1.0 || *emitter.quantity > 1e6))
            report_.add("TM30209", place(child_named(element, "Quantity")),
                        fmt::format("a quantity of {}", *emitter.quantity));
        read_tilt(child_named(element, "TiltAngles"), emitter.tilt);
        for (const pugi::xml_node area : element_at(element, "EmissionAreas/BottomFace").children())
            if (local_name(area.name()) == "BottomArea")
                emitter.bottom_areas.push_back({number_in(child_named(area, "Length")).value_or(0.0),
                                                number_in(child_named(area, "Width")).value_or(0.0),
                                                truth_in(child_named(area, "Circular")).value_or(false)});
        Tm33Places places;
        if (const pugi::xml_node intensity = intensity_element(element))
            if (Result<void> read = read_intensity(intensity, emitter, places); !read) return read;
        for (const pugi::xml_node spectrum : spectrum_elements(element))
            if (Result<void> read = read_spectrum(spectrum, emitter.spectra.emplace_back()); !read) return read;
        if (file_.emitters.empty()) mark_first(element, places);
        file_.emitters.push_back(std::move(emitter));
        intensity_places_.push_back(places);
        return {};
    }

    void mark_first(pugi::xml_node emitter, const Tm33Places& places) {
        report_.mark(ProfileField::intensity, places.table);
        report_.mark(ProfileField::multiplier, places.multiplier);
        const auto mark = [&](ProfileField field, std::optional<double> Tm33Emitter::*member) {
            for (const auto& [paths, other] : emitter_numbers)
                if (other == member)
                    if (const pugi::xml_node element = first_of(emitter, paths)) report_.mark(field, place(element));
        };
        mark(ProfileField::lamp_flux, &Tm33Emitter::rated_lumens);
        mark(ProfileField::input_watts, &Tm33Emitter::input_watts);
        mark(ProfileField::color_temperature, &Tm33Emitter::cct_k);
        mark(ProfileField::color_rendering, &Tm33Emitter::cri_ra);
    }

    void read_tilt(pugi::xml_node element, IesTilt& tilt) {
        for (const pugi::xml_node child : element.children()) {
            if (local_name(child.name()) != "Tilt") continue;
            const std::optional<double> angle = plain_number(child.attribute("angle").value());
            const std::optional<double> factor = number_in(child);
            if (!angle || !factor || (!tilt.angles_deg.empty() && *angle <= tilt.angles_deg.back())) {
                report_.add("TM30212", place(child), "a tilt without an ascending angle and a factor, left out");
                continue;
            }
            tilt.angles_deg.push_back(*angle);
            tilt.factors.push_back(*factor);
        }
    }

    Result<void> read_intensity(pugi::xml_node element, Tm33Emitter& emitter, Tm33Places& places) {
        Tm33Intensity intensity;
        places.table = place(element);
        intensity.absolute = truth_in(child_named(element, "AbsolutePhotometry"));
        intensity.multiplier = number_in(child_named(element, "Multiplier"));
        if (intensity.multiplier) places.multiplier = place(child_named(element, "Multiplier"));
        if (intensity.multiplier && *intensity.multiplier <= 0.0)
            return report_.fail("TM30208", place(child_named(element, "Multiplier")),
                                fmt::format("multiplier {}", *intensity.multiplier));
        if (const pugi::xml_node symmetry = first_of(element, Paths{"Symm", "SymmType"})) {
            places.symmetry = place(symmetry);
            intensity.symmetry = symmetry_named(symmetry.child_value());
            if (!intensity.symmetry)
                report_.add("TM30210", places.symmetry,
                            fmt::format("{} is not a symmetry", quoted(trimmed_text(symmetry).substr(0, 40))));
        }
        intensity.photometry_type = trimmed_text(child_named(element, "PhotometryType"));
        PointTable table = read_points(element);
        if (table.problem != PointTable::Problem::none) return bad_table(table, element);
        if (table.values.empty()) {
            report_.add("TM30405", places.table, "the luminous intensity has no points");
            return {};
        }
        check_count(element, "NumberMeasured", table.points);
        check_count(element, "NumberHorz", table.horizontal_deg.size());
        check_count(element, "NumberVert", table.vertical_deg.size());
        intensity.horizontal_deg = std::move(table.horizontal_deg);
        intensity.vertical_deg = std::move(table.vertical_deg);
        intensity.candela = std::move(table.values);
        if (table.plain) leave_one(element, is_intensity_point);
        emitter.intensity = std::move(intensity);
        return {};
    }

    Unexpected bad_table(const PointTable& table, pugi::xml_node element) {
        const std::size_t offset = place(table.where, element);
        using Problem = PointTable::Problem;
        switch (table.problem) {
        case Problem::angle_missing:
            return report_.fail("TM30206", offset, "a point without its two angles", "write h and v");
        case Problem::not_finite:
            return report_.fail("TM30211", offset, quoted(table.text) + " is not a finite number up to 1e30");
        case Problem::duplicate:
            return report_.fail("TM30205", offset, "a second point at the same angles");
        case Problem::incomplete:
            return report_.fail("TM30204", offset,
                                fmt::format("{} points, {} horizontal and {} vertical angles need {}", table.points,
                                            table.horizontal_deg.size(), table.vertical_deg.size(),
                                            table.horizontal_deg.size() * table.vertical_deg.size()));
        default:
            return report_.fail("TM30207", offset,
                                table.text.empty() ? std::string("a point of the table is empty")
                                                   : "expected a number, found " + quoted(table.text));
        }
    }

    void check_count(pugi::xml_node element, std::string_view name, std::size_t found) {
        const pugi::xml_node count = child_named(element, name);
        const std::optional<double> announced = number_in(count);
        if (announced && *announced != static_cast<double>(found))
            report_.add("TM30203", place(count), fmt::format("{} {} announced, {} found", name, *announced, found));
    }

    // Removes the points from the document except for an empty element that marks their place.
    static void leave_one(pugi::xml_node parent, bool (*is_point)(pugi::xml_node)) {
        pugi::xml_node mark;
        for (pugi::xml_node node = parent.first_child(); node;) {
            const pugi::xml_node next = node.next_sibling();
            if (is_point(node)) {
                if (!mark) {
                    mark = parent.insert_child_before(pugi::node_element, node);
                    mark.set_name(node.name());
                }
                parent.remove_child(node);
            }
            node = next;
        }
    }

    Result<void> read_spectrum(pugi::xml_node element, Tm33Spectrum& spectrum) {
        spectrum.emitter_name = trimmed_text(child_named(element, "EmitterName"));
        spectrum.multiplier = number_in(child_named(element, "Multiplier"));
        spectrum.normalized = truth_in(child_named(element, "Normalized"));
        pugi::xml_node wavelengths = child_named(element, "Wavelengths");
        pugi::xml_node values = child_named(element, "Values");
        if (wavelengths && values) {
            if (Result<void> read = read_list(wavelengths, spectrum.wavelengths_nm); !read) return read;
            if (Result<void> read = read_list(values, spectrum.power); !read) return read;
            if (spectrum.power.size() != spectrum.wavelengths_nm.size())
                return report_.fail(
                    "TM30213", place(values),
                    fmt::format("{} wavelengths, {} values", spectrum.wavelengths_nm.size(), spectrum.power.size()));
            wavelengths.remove_children();
            values.remove_children();
        } else {
            bool plain = true;
            for (const pugi::xml_node point : element.children()) {
                if (!is_spectrum_point(point)) continue;
                const std::optional<double> nm = plain_number(point.attribute("w").value());
                const std::optional<double> power = plain_number(point.child_value());
                if (!nm || !power)
                    return report_.fail("TM30207", place(point), "a point of the spectrum is not a pair of numbers");
                spectrum.wavelengths_nm.push_back(*nm);
                spectrum.power.push_back(*power);
                plain = plain && !point.first_attribute().next_attribute() && !has_elements(point) &&
                        !point.first_child().next_sibling();
            }
            if (plain) leave_one(element, is_spectrum_point);
            if (const pugi::xml_node count = child_named(element, "NumberWavelength"))
                check_count(element, local_name(count.name()), spectrum.power.size());
        }
        const std::vector<double>& nm = spectrum.wavelengths_nm;
        if (std::adjacent_find(nm.begin(), nm.end(), [](double a, double b) { return b <= a; }) != nm.end())
            report_.add("TM30303", place(element), "the wavelengths do not ascend");
        return {};
    }

    Result<void> read_list(pugi::xml_node element, std::vector<double>& list) {
        const std::string_view text = element.child_value();
        NumberScanner numbers(text, 0, text.size());
        for (;;) {
            double value = 0.0;
            const Token token = numbers.next(value);
            if (token == Token::end) return {};
            if (token != Token::number)
                return report_.fail("TM30207", place(text.data() + numbers.token_offset(), element),
                                    "expected a number, found " + quoted(numbers.token()));
            list.push_back(value);
        }
    }

    // Checks for elements that the schema requires; the dialect without a schema is not checked.
    void check_required(pugi::xml_node root) {
        if (file_.root == "LuminaireOpticalData") return;
        std::string missing;
        const auto need = [&](pugi::xml_node parent, const char* path) {
            if (!element_at(parent, path)) missing += (missing.empty() ? "" : ", ") + std::string(path);
        };
        for (const char* const path :
             {"Header/Description", "Header/Laboratory", "Header/ReportNumber", "Header/ReportDate"})
            need(root, path);
        const pugi::xml_node emitter = child_named(root, "Emitter");
        for (const char* const path : {"Quantity", "Description", "InputWattage"})
            need(emitter, path);
        if (!missing.empty())
            report_.add("TM30103", place(root), fmt::format("required by {}: {}", edition(file_), missing));
    }

    Report& report_;
    std::size_t begin_;  // start of the buffer within the bytes
    std::string buffer_; // parsed in place: every name and text points into it
    pugi::xml_document document_;
    Tm33File file_;
    std::vector<Tm33Places> intensity_places_; // per emitter
};

} // namespace

bool is_tm33_root(std::string_view name) {
    return name == "IESTM33-22" || name == "IESTM33" || name == "IESTM33-18" || name == "LuminaireOpticalData" ||
           name == "ATLA_S001" || name == "ATLA_S001_A";
}

Result<Tm33File> parse_tm33(TextRange text, Report& report) {
    return Tm33Parser(text, report).parse();
}

} // namespace gonio::profile_detail
