#include <gonio/profile/number_text.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/write.hpp>

#include <string_view>

namespace gonio {

namespace {

class Lines {
public:
    void add(std::string_view line) {
        text_ += line;
        text_ += "\r\n";
    }

    void add(double value) {
        number_.append(text_, value);
        text_ += "\r\n";
    }

    void add(int value) { add(static_cast<double>(value)); }

    void add(const std::vector<double>& values) {
        for (const double value : values)
            add(value);
    }

    std::string take() { return std::move(text_); }

private:
    std::string text_;
    profile_detail::NumberText number_;
};

} // namespace

std::string write_ldt(const LdtFile& file) {
    Lines lines;
    const bool hidden = profile_detail::begins_as_other_file(file.company);
    lines.add(hidden ? ' ' + file.company : file.company);
    lines.add(file.type_indicator);
    lines.add(file.symmetry);
    lines.add(file.plane_count);
    lines.add(file.plane_step_deg);
    lines.add(file.gamma_count);
    lines.add(file.gamma_step_deg);
    lines.add(file.report_number);
    lines.add(file.luminaire_name);
    lines.add(file.luminaire_number);
    lines.add(file.file_name);
    lines.add(file.date_user);
    for (const double value : {file.length_mm, file.width_mm, file.height_mm, file.luminous_length_mm,
                               file.luminous_width_mm, file.luminous_height_c0_mm, file.luminous_height_c90_mm,
                               file.luminous_height_c180_mm, file.luminous_height_c270_mm, file.downward_flux_percent,
                               file.light_output_ratio_percent, file.conversion_factor, file.tilt_deg})
        lines.add(value);
    lines.add(static_cast<double>(file.lamp_sets.size()));
    for (const LdtLampSet& set : file.lamp_sets) {
        lines.add(set.lamp_count);
        lines.add(set.lamp_type);
        lines.add(set.flux_lm);
        lines.add(set.color_temperature);
        lines.add(set.color_rendering);
        lines.add(set.input_watts);
    }
    lines.add(file.direct_ratios);
    lines.add(file.planes_deg);
    lines.add(file.gammas_deg);
    lines.add(file.candela_per_klm);
    return lines.take();
}

} // namespace gonio
