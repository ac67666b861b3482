#include <gonio/plot/svg.hpp>

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace gonio {

namespace {

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            // XML 1.0 knows no other control characters than tab and line ends, not even escaped.
            out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

const char* to_text(TextAnchor anchor) {
    return anchor == TextAnchor::start ? "start" : anchor == TextAnchor::middle ? "middle" : "end";
}

} // namespace

std::string svg_number(double value) {
    std::string text = fmt::format("{:.2f}", value);
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

SvgPath& SvgPath::move_to(SvgPoint point) {
    data_ += "M" + svg_number(point.x) + " " + svg_number(point.y);
    return *this;
}

SvgPath& SvgPath::line_to(SvgPoint point) {
    data_ += "L" + svg_number(point.x) + " " + svg_number(point.y);
    return *this;
}

SvgPath& SvgPath::close() {
    data_ += "Z";
    return *this;
}

Svg::Svg(int width, int height, std::string_view title) {
    text_ = fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" )"
                        R"(font-family="DejaVu Sans, Verdana, Arial, sans-serif">)"
                        "\n<title>{2}</title>\n",
                        width, height, escaped(title));
    rectangle({0, 0}, width, height, R"(fill="#fff")");
}

void Svg::line(SvgPoint from, SvgPoint to, std::string_view style) {
    fmt::format_to(std::back_inserter(text_), "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n",
                   svg_number(from.x), svg_number(from.y), svg_number(to.x), svg_number(to.y), style);
}

void Svg::circle(SvgPoint center, double radius, std::string_view style) {
    fmt::format_to(std::back_inserter(text_), "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", svg_number(center.x),
                   svg_number(center.y), svg_number(radius), style);
}

void Svg::rectangle(SvgPoint corner, double width, double height, std::string_view style) {
    fmt::format_to(std::back_inserter(text_), "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{}/>\n",
                   svg_number(corner.x), svg_number(corner.y), svg_number(width), svg_number(height),
                   style.empty() ? "" : " ", style);
}

void Svg::path(const SvgPath& path, std::string_view style) {
    if (!path.empty()) fmt::format_to(std::back_inserter(text_), "<path d=\"{}\" {}/>\n", path.data(), style);
}

void Svg::text(SvgPoint at, std::string_view text, TextAnchor anchor, double size_px, std::string_view style) {
    fmt::format_to(std::back_inserter(text_),
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\"{}{}>{}</text>\n", svg_number(at.x),
                   svg_number(at.y), to_text(anchor), svg_number(size_px), style.empty() ? "" : " ", style,
                   escaped(text));
}

void Svg::label(SvgPoint at, std::string_view text, TextAnchor anchor, double size_px) {
    this->text(at, text, anchor, size_px, R"(fill="#333" stroke="#fff" stroke-width="3" paint-order="stroke")");
}

void Svg::begin_clip(SvgPoint corner, double width, double height) {
    ++clips_;
    fmt::format_to(std::back_inserter(text_), "<clipPath id=\"clip{}\">", clips_);
    rectangle(corner, width, height, "");
    text_ += fmt::format("</clipPath>\n<g clip-path=\"url(#clip{})\">\n", clips_);
}

void Svg::end_clip() {
    text_ += "</g>\n";
}

std::string Svg::finish() {
    return std::move(text_) + "</svg>\n";
}

} // namespace gonio
