#include <gonio/base/charconv.hpp>
#include <gonio/plot/stroke_font.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <unordered_map>
#include <utility>

namespace gonio {

namespace {

// A glyph on a grid on which capitals are 14 units high, small letters 10, and descenders reach −4. Strokes are
// separated by ';'. A stroke is a sequence of points "x,y" and arcs "@x,y,rx,ry,from,to" (centre, radii, degrees
// counter-clockwise from the right), each joined to the previous one.
struct Outline {
    char32_t code;
    double advance;
    const char* strokes;
};

constexpr double units_per_capital = 14.0;
constexpr double units_per_small = 10.0;

constexpr std::array outlines{
    Outline{U' ', 5.2, ""},
    Outline{U'!', 5, "2.5,14 2.5,4.5;2.5,.4"},
    Outline{U'"', 7, "2,14 2,9.8;5,14 5,9.8"},
    Outline{U'#', 13, "3.6,0 6,14;7.6,0 10,14;1.2,9.4 12,9.4;.8,4.6 11.6,4.6"},
    Outline{U'$', 11, "@5.6,10.5,3.8,3.5,35,270 @5.6,3.5,4.2,3.5,90,-150;5.6,16 5.6,-2"},
    Outline{U'%', 15, "@3.8,10.8,2.6,3.2,0,360;@11.2,3.2,2.6,3.2,0,360;11.6,14 3.4,0"},
    Outline{U'&', 13, "11.8,0 3.7,9.3 @5.6,11.2,2.6,2.8,222,-45 @5,3.9,3.7,3.9,115,300 11,7"},
    Outline{U'\'', 4, "2,14 2,9.8"},
    Outline{U'(', 6, "@9,5.5,7,11,130,230"},
    Outline{U')', 6, "@-3,5.5,7,11,50,-50"},
    Outline{U'*', 8, "4,14 4,7.4;1.2,12.4 6.8,9;6.8,12.4 1.2,9"},
    Outline{U'+', 12, "6,11 6,2;1.5,6.5 10.5,6.5"},
    Outline{U',', 5, "2.7,.6 1.6,-2.6"},
    Outline{U'-', 7, "1.2,5.4 5.8,5.4"},
    Outline{U'.', 5, "2.5,.4"},
    Outline{U'/', 7.2, "6.6,14.6 .6,-2"},
    Outline{U'0', 11, "@5.5,7,4,7,0,360"},
    Outline{U'1', 11, "2.6,11.2 6.2,14 6.2,0"},
    Outline{U'2', 11, "@5.5,10.2,3.8,3.8,165,-35 1.7,0 9.5,0"},
    Outline{U'3', 11, "@5.2,10.6,3.4,3.4,155,-90 @5.2,3.6,4,3.6,90,-150"},
    Outline{U'4', 11, "7.5,0 7.5,14 1.2,4 10,4"},
    Outline{U'5', 11, "9,14 3,14 2.4,7.6 @5.5,4.6,4.1,4.6,140,-150"},
    Outline{U'6', 11, "@9.3,4.4,7.8,9.6,100,180 @5.5,4.4,4,4.4,180,540"},
    Outline{U'7', 11, "1.6,14 9.6,14 4,0"},
    Outline{U'8', 11, "@5.5,10.6,3.4,3.4,-90,270 @5.5,3.6,4,3.6,90,450"},
    Outline{U'9', 11, "@1.7,9.6,7.8,9.6,-80,0 @5.5,9.6,4,4.4,0,360"},
    Outline{U':', 5, "2.5,8.4;2.5,.4"},
    Outline{U';', 5, "2.5,8.4;2.7,.6 1.6,-2.6"},
    Outline{U'<', 12, "10.3,11.4 1.6,6.5 10.3,1.6"},
    Outline{U'=', 12, "1.5,8.7 10.5,8.7;1.5,4.3 10.5,4.3"},
    Outline{U'>', 12, "1.7,11.4 10.4,6.5 1.7,1.6"},
    Outline{U'?', 9.5, "@4.7,10.6,3.4,3.4,165,-50 4.7,6 4.7,4.4;4.7,.4"},
    Outline{U'@', 16, "@8,5.4,2.8,3.4,0,360;10.8,8.8 10.8,4 @12.6,4,1.8,2,180,360 14.4,5.4 @8,5.4,6.4,7.8,0,305"},
    Outline{U'A', 12, ".8,0 6,14 11.2,0;2.7,4.8 9.3,4.8"},
    Outline{U'B', 11.5, "6,7.2 2,7.2 2,14 5.8,14 @5.8,10.6,3.5,3.4,90,-90 @6.2,3.6,4,3.6,90,-90 2,0 2,7.2"},
    Outline{U'C', 12, "@6.8,7,5.3,7,48,312"},
    Outline{U'D', 12.5, "2,0 2,14 5,14 @5,7,5.8,7,90,-90 2,0"},
    Outline{U'E', 10.5, "9.3,14 2,14 2,0 9.3,0;2,7.2 8.4,7.2"},
    Outline{U'F', 10, "9,14 2,14 2,0;2,7.2 8.2,7.2"},
    Outline{U'G', 12.5, "@6.8,7,5.3,7,48,315 10.9,2.4 10.9,6.6 7.2,6.6"},
    Outline{U'H', 12.5, "2,0 2,14;10.5,0 10.5,14;2,7.2 10.5,7.2"},
    Outline{U'I', 4.8, "2.4,0 2.4,14"},
    Outline{U'J', 8, "6,14 6,3.6 @3.1,3.6,2.9,3.6,0,-140"},
    Outline{U'K', 11.5, "2,0 2,14;10,14 2,5.6;4.9,8.6 10.6,0"},
    Outline{U'L', 10, "2,14 2,0 9.2,0"},
    Outline{U'M', 14.5, "2,0 2,14 7.25,3 12.5,14 12.5,0"},
    Outline{U'N', 12.5, "2,0 2,14 10.5,0 10.5,14"},
    Outline{U'O', 13, "@6.5,7,5.3,7,0,360"},
    Outline{U'P', 11, "2,0 2,14 6,14 @6,10.2,3.7,3.8,90,-90 2,6.4"},
    Outline{U'Q', 13, "@6.5,7,5.3,7,0,360;7.8,3.4 11.6,-1.4"},
    Outline{U'R', 11.5, "2,0 2,14 6,14 @6,10.2,3.7,3.8,90,-90 2,6.4;6,6.4 10.4,0"},
    Outline{U'S', 11, "@5.6,10.5,3.8,3.5,35,270 @5.6,3.5,4.2,3.5,90,-150"},
    Outline{U'T', 11, ".8,14 10.2,14;5.5,14 5.5,0"},
    Outline{U'U', 12.5, "2,14 2,5 @6.25,5,4.25,5,180,360 10.5,14"},
    Outline{U'V', 12, ".8,14 6,0 11.2,14"},
    Outline{U'W', 16, ".8,14 4.4,0 8,12 11.6,0 15.2,14"},
    Outline{U'X', 11.5, "1,14 10.5,0;10.5,14 1,0"},
    Outline{U'Y', 11.5, ".8,14 5.75,6.6 10.7,14;5.75,6.6 5.75,0"},
    Outline{U'Z', 11.5, "1.4,14 10,14 1.2,0 10.3,0"},
    Outline{U'[', 6, "5,15 2,15 2,-3 5,-3"},
    Outline{U'\\', 7.2, ".6,14.6 6.6,-2"},
    Outline{U']', 6, "1,15 4,15 4,-3 1,-3"},
    Outline{U'^', 12, "2,8 6,14 10,8"},
    Outline{U'_', 10, ".3,-2.6 9.7,-2.6"},
    Outline{U'`', 6, "1.6,14.4 4,11.6"},
    Outline{U'a', 10.5,
            "@5.1,6.9,3.5,3.1,150,0 8.6,0;8.6,5.8 4.8,5.8 @4.8,2.9,3.3,2.9,90,270 @4.8,3.8,3.8,3.8,270,350"},
    Outline{U'b', 11, "2,14 2,0;@5.8,5,3.8,5,0,360"},
    Outline{U'c', 9.5, "@5.4,5,3.9,5,50,310"},
    Outline{U'd', 11, "9,14 9,0;@5.2,5,3.8,5,0,360"},
    Outline{U'e', 10.5, "1.5,5.3 9.1,5.3 @5.3,5,3.85,5,2,310"},
    Outline{U'f', 6.5, "@5.6,11,2.4,3,75,180 3.2,0;1,10 5.9,10"},
    Outline{U'g', 11, "@5.2,5,3.8,5,0,360;9,10 9,-1 @5.4,-1,3.6,3.1,0,-150"},
    Outline{U'h', 10.5, "2,14 2,0;2,6 @5.3,6,3.3,4,180,0 8.6,0"},
    Outline{U'i', 4.5, "2.25,10 2.25,0;2.25,13.4"},
    Outline{U'j', 4.5, "2.5,10 2.5,-1.4 @.3,-1.4,2.2,2.6,0,-80;2.5,13.4"},
    Outline{U'k', 9.8, "2,14 2,0;8.6,10 2,3.8;4.4,6.1 9,0"},
    Outline{U'l', 4.5, "2.25,14 2.25,0"},
    Outline{U'm', 15.5, "2,10 2,0;2,6 @4.9,6,2.9,4,180,0 7.8,0;7.8,6 @10.7,6,2.9,4,180,0 13.6,0"},
    Outline{U'n', 10.5, "2,10 2,0;2,6 @5.3,6,3.3,4,180,0 8.6,0"},
    Outline{U'o', 10.5, "@5.25,5,3.9,5,0,360"},
    Outline{U'p', 11, "2,10 2,-4;@5.8,5,3.8,5,0,360"},
    Outline{U'q', 11, "9,10 9,-4;@5.2,5,3.8,5,0,360"},
    Outline{U'r', 7, "2,10 2,0;2,6 @5.4,6,3.4,4,180,75"},
    Outline{U's', 9, "@4.6,7.4,3,2.6,35,270 @4.5,2.4,3.3,2.4,90,-150"},
    Outline{U't', 7, "3,13 3,3 @5.5,3,2.5,3,180,285;.9,10 6,10"},
    Outline{U'u', 10.5, "2,10 2,4 @5.2,4,3.2,4,180,360;8.4,10 8.4,0"},
    Outline{U'v', 10, "1,10 5,0 9,10"},
    Outline{U'w', 13.5, "1,10 3.9,0 6.75,9 9.6,0 12.5,10"},
    Outline{U'x', 9.5, "1.2,10 8.3,0;8.3,10 1.2,0"},
    Outline{U'y', 10, "1,10 5,.3;9,10 3.8,-3.2 @2.2,-2.2,1.8,1.8,-35,-110"},
    Outline{U'z', 9.5, "1.4,10 8,10 1.2,0 8.3,0"},
    Outline{U'{', 8, "6.6,15 @6,12.8,2.2,2.2,90,180 3.8,8.4 1.8,6 3.8,3.6 3.8,-.8 @6,-.8,2.2,2.2,180,270"},
    Outline{U'|', 5, "2.5,15.5 2.5,-3.5"},
    Outline{U'}', 8, "1.4,15 @2,12.8,2.2,2.2,90,0 4.2,8.4 6.2,6 4.2,3.6 4.2,-.8 @2,-.8,2.2,2.2,0,-90"},
    Outline{U'~', 12, "1.6,5.2 @4,5.4,2.4,2,180,30 @8,7.6,2.4,2,210,360"},
    Outline{U'\u00a0', 5.2, ""},
    Outline{U'°', 7, "@3.5,11.4,2.3,2.6,0,360"},
    Outline{U'±', 12, "6,12 6,4;1.8,8 10.2,8;1.8,1 10.2,1"},
    Outline{U'²', 7, "@3.4,11.9,2.1,2.1,165,-35 1.3,6.6 5.8,6.6"},
    Outline{U'³', 7, "@3.2,12.2,1.9,1.8,155,-90 @3.2,8.5,2.2,1.9,90,-150"},
    Outline{U'µ', 10.8, "2,10 2,-4;2,4 @5.2,4,3.2,4,180,360;8.4,10 8.4,0"},
    Outline{U'·', 5, "2.5,6.4"},
    Outline{U'×', 12, "2.2,10.4 9.8,2.8;9.8,10.4 2.2,2.8"},
    Outline{U'ß', 10.8, "2,0 2,10.4 @5,10.4,3,3.6,180,-80 @5.2,3.6,4,3.6,80,-110"},
    Outline{U'Æ', 16, ".6,0 7,14 15,14;8.4,14 8.4,0 15,0;8.4,7.2 14.2,7.2;2.7,4.8 8.4,4.8"},
    Outline{U'æ', 16,
            "@4.9,6.9,3.3,3.1,150,0 8.2,3.4;8.2,5.8 4.6,5.8 @4.6,2.9,3.2,2.9,90,270 @4.8,3.4,3.4,3.4,270,360;"
            "8.2,5.3 14.8,5.3 @11.5,5,3.3,5,2,310"},
    Outline{U'Ø', 13, "@6.5,7,5.3,7,0,360;1.6,-.8 11.4,14.8"},
    Outline{U'ø', 10.5, "@5.25,5,3.9,5,0,360;1.4,-.8 9.1,10.8"},
    Outline{U'ı', 4.5, "2.25,10 2.25,0"},
    Outline{U'Φ', 13, "@6.5,7,5.2,4.2,0,360;6.5,14 6.5,0"},
    Outline{U'α', 11, "9.4,10 @5.2,5,3.8,5,20,340 9.8,0;8.7,6.7 8.7,3.3"},
    Outline{U'γ', 10, ".9,8.2 @2.4,8,1.6,2,165,20 5.3,.4;9.2,10 5.3,.4 4.5,-4 6.1,-4 5.3,.4"},
    Outline{U'π', 11, ".8,9.6 10.2,9.6;3.2,9.6 3.2,0;7.8,9.6 7.8,0"},
    Outline{U'–', 10, ".8,5.4 9.2,5.4"},
    Outline{U'—', 16, ".8,5.4 15.2,5.4"},
    Outline{U'‘', 4, "2.4,14 1.6,10.8"},
    Outline{U'’', 4, "2.4,14 1.6,10.8"},
    Outline{U'“', 7, "2.4,14 1.6,10.8;5.4,14 4.6,10.8"},
    Outline{U'”', 7, "2.4,14 1.6,10.8;5.4,14 4.6,10.8"},
    Outline{U'„', 7, "2.7,.6 1.6,-2.6;5.7,.6 4.6,-2.6"},
    Outline{U'…', 15, "2.5,.4;7.5,.4;12.5,.4"},
    Outline{U'←', 14, "13,6.5 1,6.5;5,10 1,6.5 5,3"},
    Outline{U'↑', 10, "5,0 5,13.5;1.6,10 5,13.5 8.4,10"},
    Outline{U'→', 14, "1,6.5 13,6.5;9,10 13,6.5 9,3"},
    Outline{U'↓', 10, "5,13.5 5,0;1.6,3.5 5,0 8.4,3.5"},
    Outline{U'−', 12, "1.5,6.5 10.5,6.5"},
    Outline{U'√', 12, "1,7 3,7 5.4,0 8.4,14 11.6,14"},
    Outline{U'≈', 12, "1.6,7.6 @4,7.8,2.4,2,180,30 @8,10,2.4,2,210,360;1.6,3 @4,3.2,2.4,2,180,30 @8,5.4,2.4,2,210,360"},
    Outline{U'≤', 12, "10.3,12.4 1.6,8.2 10.3,4;1.7,1 10.3,1"},
    Outline{U'≥', 12, "1.7,12.4 10.4,8.2 1.7,4;1.7,1 10.3,1"},
};

constexpr Outline missing{U'\ufffd', 11, "2,0 2,14 9,14 9,0 2,0"};

// A letter and the mark above or below it; the mark is drawn around x = 0, above a small letter.
struct Composed {
    char32_t code;
    char32_t letter;
    const char* mark;
};

constexpr const char* grave = "-1.8,14 .6,11.6";
constexpr const char* acute = "1.8,14 -.6,11.6";
constexpr const char* circumflex = "-2.2,11.6 0,14 2.2,11.6";
constexpr const char* tilde = "-2.6,11.8 @-1.2,12,1.4,1.2,180,20 @1.2,13.4,1.4,1.2,200,360";
constexpr const char* dots = "-1.9,13;1.9,13";
constexpr const char* ring = "@0,13.3,1.5,1.6,0,360";
constexpr const char* cedilla = ".4,0 -.2,-1.8 @-.2,-2.9,1.3,1.1,90,-130";
constexpr const char* caron = "-2.2,14 0,11.6 2.2,14";

constexpr std::array composed{
    Composed{U'À', U'A', grave},      Composed{U'Á', U'A', acute},      Composed{U'Â', U'A', circumflex},
    Composed{U'Ã', U'A', tilde},      Composed{U'Ä', U'A', dots},       Composed{U'Å', U'A', ring},
    Composed{U'Ç', U'C', cedilla},    Composed{U'È', U'E', grave},      Composed{U'É', U'E', acute},
    Composed{U'Ê', U'E', circumflex}, Composed{U'Ë', U'E', dots},       Composed{U'Ì', U'I', grave},
    Composed{U'Í', U'I', acute},      Composed{U'Î', U'I', circumflex}, Composed{U'Ï', U'I', dots},
    Composed{U'Ñ', U'N', tilde},      Composed{U'Ò', U'O', grave},      Composed{U'Ó', U'O', acute},
    Composed{U'Ô', U'O', circumflex}, Composed{U'Õ', U'O', tilde},      Composed{U'Ö', U'O', dots},
    Composed{U'Ù', U'U', grave},      Composed{U'Ú', U'U', acute},      Composed{U'Û', U'U', circumflex},
    Composed{U'Ü', U'U', dots},       Composed{U'Ý', U'Y', acute},      Composed{U'à', U'a', grave},
    Composed{U'á', U'a', acute},      Composed{U'â', U'a', circumflex}, Composed{U'ã', U'a', tilde},
    Composed{U'ä', U'a', dots},       Composed{U'å', U'a', ring},       Composed{U'ç', U'c', cedilla},
    Composed{U'è', U'e', grave},      Composed{U'é', U'e', acute},      Composed{U'ê', U'e', circumflex},
    Composed{U'ë', U'e', dots},       Composed{U'ì', U'ı', grave},      Composed{U'í', U'ı', acute},
    Composed{U'î', U'ı', circumflex}, Composed{U'ï', U'ı', dots},       Composed{U'ñ', U'n', tilde},
    Composed{U'ò', U'o', grave},      Composed{U'ó', U'o', acute},      Composed{U'ô', U'o', circumflex},
    Composed{U'õ', U'o', tilde},      Composed{U'ö', U'o', dots},       Composed{U'ù', U'u', grave},
    Composed{U'ú', U'u', acute},      Composed{U'û', U'u', circumflex}, Composed{U'ü', U'u', dots},
    Composed{U'ý', U'y', acute},      Composed{U'ÿ', U'y', dots},       Composed{U'Č', U'C', caron},
    Composed{U'č', U'c', caron},      Composed{U'Š', U'S', caron},      Composed{U'š', U's', caron},
    Composed{U'Ž', U'Z', caron},      Composed{U'ž', U'z', caron},
};

struct Glyph {
    double advance = 0.0;
    std::vector<Polyline> strokes; // y upwards
};

constexpr double arc_step_deg = 12.0;

class OutlineReader {
public:
    OutlineReader(std::string_view text, PagePoint shift) : text_(text), shift_(shift) {}

    std::vector<Polyline> read() {
        if (text_.empty()) return {};
        strokes_.emplace_back();
        while (!text_.empty()) {
            const char c = text_.front();
            if (c == ' ' || c == ';') text_.remove_prefix(1);
            if (c == ';') strokes_.emplace_back();
            if (c == ' ' || c == ';') continue;
            c == '@' ? arc() : point();
        }
        return std::move(strokes_);
    }

private:
    double number() {
        double value = 0.0;
        text_.remove_prefix(text_.front() == ',' || text_.front() == '@' ? 1 : 0);
        const auto [end, error] = from_chars(text_.data(), text_.data() + text_.size(), value);
        text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
        return value;
    }

    void add(double x, double y) { strokes_.back().push_back({x + shift_.x, y + shift_.y}); }

    void point() {
        const double x = number();
        const double y = number();
        add(x, y);
    }

    void arc() {
        std::array<double, 6> v{}; // x, y, rx, ry, from, to
        for (double& value : v)
            value = number();
        const int count = std::max(2, static_cast<int>(std::ceil(std::fabs(v[5] - v[4]) / arc_step_deg)));
        for (int i = 0; i <= count; ++i) {
            const double angle = (v[4] + (v[5] - v[4]) * i / count) * (std::numbers::pi / 180.0);
            add(v[0] + v[2] * std::cos(angle), v[1] + v[3] * std::sin(angle));
        }
    }

    std::string_view text_;
    PagePoint shift_;
    std::vector<Polyline> strokes_;
};

using Glyphs = std::unordered_map<char32_t, Glyph>;

Glyphs make_glyphs() {
    Glyphs glyphs;
    for (const Outline& outline : outlines)
        glyphs[outline.code] = {outline.advance, OutlineReader(outline.strokes, {}).read()};
    glyphs[missing.code] = {missing.advance, OutlineReader(missing.strokes, {}).read()};
    for (const Composed& letter : composed) {
        Glyph glyph = glyphs.at(letter.letter);
        const bool capital = letter.letter < U'a';
        const bool below = letter.mark == cedilla;
        const PagePoint shift{0.5 * glyph.advance, capital && !below ? 3.6 : 0.0};
        for (Polyline& stroke : OutlineReader(letter.mark, shift).read())
            glyph.strokes.push_back(std::move(stroke));
        glyphs[letter.code] = std::move(glyph);
    }
    glyphs[U'μ'] = glyphs.at(U'µ'); // the Greek letter and the micro sign
    return glyphs;
}

const Glyph& glyph_of(char32_t code) {
    static const Glyphs glyphs = make_glyphs();
    if (code < U' ') code = U' ';
    const auto found = glyphs.find(code);
    return found != glyphs.end() ? found->second : glyphs.at(missing.code);
}

// Removes the next character from UTF-8 text and returns it; each byte that is not valid UTF-8 becomes one missing
// character.
char32_t take_code(std::string_view& text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xc2 ? 0
                               : lead < 0xe0 ? 2
                               : lead < 0xf0 ? 3
                               : lead < 0xf5 ? 4
                                             : 0;
    char32_t code = length == 1 ? lead : lead & (0x7fU >> length);
    bool whole = length > 0 && length <= text.size();
    for (std::size_t i = 1; whole && i < length; ++i) {
        const auto next = static_cast<unsigned char>(text[i]);
        whole = (next & 0xc0U) == 0x80U;
        code = (code << 6U) | (next & 0x3fU);
    }
    text.remove_prefix(whole ? length : 1);
    return whole ? code : missing.code;
}

// Heights in pixels above the baseline, scaled so that the tops of capitals and of small letters are whole pixels above
// it.
struct Heights {
    double scale = 1.0; // px per unit
    double small_px = 0.0;
    double capital_px = 0.0;

    double operator()(double y) const {
        if (y <= 0.0) return scale * y;
        if (y <= units_per_small) return y * (small_px / units_per_small);
        return small_px + (y - units_per_small) * ((capital_px - small_px) / (units_per_capital - units_per_small));
    }
};

constexpr double em_per_unit = capital_height / units_per_capital;

} // namespace

double text_width_px(std::string_view text, double size_px) {
    double units = 0.0;
    while (!text.empty())
        units += glyph_of(take_code(text)).advance;
    return units * em_per_unit * size_px;
}

std::vector<Polyline> text_lines(std::string_view text, PagePoint at, double size_px, bool hinted) {
    const double scale = em_per_unit * size_px;
    Heights height{scale, scale * units_per_small, scale * units_per_capital};
    if (hinted) {
        height.small_px = std::round(height.small_px);
        height.capital_px = std::max(std::round(height.capital_px), height.small_px + 1.0);
        at.y = std::floor(at.y - 0.5 * stroke_weight * size_px) + 0.5;
    }
    std::vector<Polyline> lines;
    while (!text.empty()) {
        const Glyph& glyph = glyph_of(take_code(text));
        for (const Polyline& stroke : glyph.strokes) {
            Polyline& line = lines.emplace_back();
            line.reserve(stroke.size());
            for (const PagePoint p : stroke)
                line.push_back({at.x + scale * p.x, at.y - height(p.y)});
        }
        at.x += scale * glyph.advance;
    }
    return lines;
}

} // namespace gonio
