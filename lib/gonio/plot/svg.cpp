#include <gonio/base/markup.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/plot/svg_path.hpp>

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace gonio {

namespace {

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        if (const std::string_view entity = markup_entity(c); !entity.empty())
            out += entity;
        else // XML 1.0 allows no control characters except tab and line ends, not even escaped.
            out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out;
}

const char* to_text(TextAnchor anchor) {
    return anchor == TextAnchor::start ? "start" : anchor == TextAnchor::middle ? "middle" : "end";
}

// "#ccc", or "#d55e00" if three digits are not enough.
std::string hex(Ink ink) {
    const auto is_short = [](std::uint8_t channel) { return channel % 17 == 0; };
    if (is_short(ink.r) && is_short(ink.g) && is_short(ink.b))
        return fmt::format("#{:x}{:x}{:x}", ink.r / 17, ink.g / 17, ink.b / 17);
    return fmt::format("#{:02x}{:02x}{:02x}", ink.r, ink.g, ink.b);
}

std::string paint(std::string_view attribute, Ink ink) {
    std::string text = fmt::format(R"({}="{}")", attribute, hex(ink));
    if (ink.opacity < 1.0) text += fmt::format(R"( {}-opacity="{}")", attribute, svg_number(ink.opacity));
    return text;
}

std::string style_of(const Pen& pen) {
    std::string text = paint("stroke", pen.ink);
    if (pen.width_px != 1.0) text += fmt::format(R"( stroke-width="{}")", svg_number(pen.width_px));
    if (pen.dash_px[0] > 0.0)
        text += fmt::format(R"( stroke-dasharray="{} {}")", svg_number(pen.dash_px[0]), svg_number(pen.dash_px[1]));
    return text;
}

class Writer {
public:
    Writer(const Drawing& drawing, const SvgOptions& options) : options_(options) {
        text_ = fmt::format(
            R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}{3}" height="{1}{3}" viewBox="0 0 {0} {1}" )"
            R"(font-family="DejaVu Sans, Verdana, Arial, sans-serif">)"
            "\n<title>{2}</title>\n",
            drawing.width_px(), drawing.height_px(), escaped(drawing.title()), options.unit);
        rectangle({0, 0}, drawing.width_px(), drawing.height_px(), R"( fill="#fff")");
        for (const DrawingStep& step : drawing.steps())
            std::visit(*this, step);
        text_ += "</svg>\n";
    }

    std::string take() { return std::move(text_); }

    void operator()(const FilledPath& step) { path(step.path, paint("fill", step.ink), true); }

    void operator()(const StrokedPath& step) {
        const auto& parts = step.path.parts();
        if (parts.size() == 1 && parts[0].points.size() == 2 && !parts[0].closed) {
            const PagePoint from = parts[0].points[0];
            const PagePoint to = parts[0].points[1];
            append("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", svg_number(from.x), svg_number(from.y),
                   svg_number(to.x), svg_number(to.y), style_of(step.pen));
            return;
        }
        path(step.path, R"(fill="none" stroke-linejoin="round" )" + style_of(step.pen), false);
    }

    void operator()(const FilledRectangle& step) {
        rectangle(step.corner, step.width, step.height, " " + paint("fill", step.ink));
    }

    void operator()(const FilledCircle& step) {
        append("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", svg_number(step.center.x), svg_number(step.center.y),
               svg_number(step.radius), paint("fill", step.ink));
    }

    void operator()(const WrittenText& step) {
        const TextStyle& style = step.style;
        std::string more;
        if (hex(style.ink) != "#000" || style.ink.opacity < 1.0) more += " " + paint("fill", style.ink);
        if (style.bold) more += R"( font-weight="bold")";
        if (style.rim_px > 0.0)
            more += fmt::format(R"( {} stroke-width="{}" paint-order="stroke")", paint("stroke", style.rim),
                                svg_number(2.0 * style.rim_px));
        append("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\"{}>{}</text>\n", svg_number(step.at.x),
               svg_number(step.at.y), to_text(style.anchor), svg_number(style.size_px), more, escaped(step.text));
    }

    void operator()(const ClipBegin& step) {
        append("<clipPath id=\"{}clip{}\">", options_.id_prefix, ++clips_);
        rectangle(step.corner, step.width, step.height, "");
        append("</clipPath>\n<g clip-path=\"url(#{}clip{})\">\n", options_.id_prefix, clips_);
    }

    void operator()(const ClipEnd& /*step*/) { text_ += "</g>\n"; }

private:
    template<class... Values>
    void append(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    }

    void rectangle(PagePoint corner, double width, double height, std::string_view style) {
        append("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n", svg_number(corner.x), svg_number(corner.y),
               svg_number(width), svg_number(height), style);
    }

    void path(const PagePath& path, std::string_view style, bool is_filled) {
        text_ += "<path d=\"";
        if (options_.short_paths) {
            text_ += is_filled ? plot_detail::short_outline(path) : plot_detail::short_line(path);
            append("\" {}/>\n", style);
            return;
        }
        for (const PagePath::Part& part : path.parts()) {
            char command = 'M';
            for (const PagePoint point : part.points) {
                append("{}{} {}", command, svg_number(point.x), svg_number(point.y));
                command = 'L';
            }
            if (part.closed) text_ += 'Z';
        }
        append("\" {}/>\n", style);
    }

    const SvgOptions& options_;
    std::string text_;
    int clips_ = 0;
};

} // namespace

std::string svg_number(double value) {
    std::string text = fmt::format("{:.2f}", value);
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string to_svg(const Drawing& drawing, const SvgOptions& options) {
    return Writer(drawing, options).take();
}

} // namespace gonio
