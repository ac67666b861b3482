#include <gonio/base/text.hpp>
#include <gonio/table/table_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio {

namespace {

// What the languages write differently.
struct Words {
    const StoredTable& stored;
    TableLanguage language;

    [[nodiscard]] const ShadingTable& table() const { return stored.table; }
    [[nodiscard]] const TableInfo& info() const { return info_of(table().kind); }
    [[nodiscard]] bool in_c() const { return language == TableLanguage::c; }
    [[nodiscard]] bool in_wgsl() const { return language == TableLanguage::wgsl; }
    [[nodiscard]] std::string prefix() const {
        std::string name(info().name);
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    }
    // "LtcGgxValues"
    [[nodiscard]] std::string structure() const {
        std::string name;
        bool upper = true;
        for (const char c : info().name) {
            if (c != '-') name += upper ? to_upper(c) : c;
            upper = c == '-';
        }
        return name + "Values";
    }
    // A constant that reads back as the same float.
    [[nodiscard]] std::string number(double value) const {
        std::string text = fmt::format("{}", static_cast<float>(value));
        if (text.find_first_of(".e") == std::string::npos) text += ".0";
        return in_c() || language == TableLanguage::msl ? text + "f" : text;
    }
    // The declaration of a number that stays as it is, or of one that changes.
    [[nodiscard]] std::string constant(std::string_view name) const {
        return fmt::format("{} {}", in_wgsl() ? "let" : "float", name);
    }
    [[nodiscard]] std::string variable(std::string_view name) const {
        return fmt::format("{} {}", in_wgsl() ? "var" : "float", name);
    }
    // A parameter or, with what follows it, a member of a structure.
    [[nodiscard]] std::string number_named(std::string_view name) const {
        return in_wgsl() ? fmt::format("{}: f32", name) : fmt::format("float {}", name);
    }
    [[nodiscard]] std::string integer_named(std::string_view name) const {
        return in_wgsl() ? fmt::format("{}: i32", name) : fmt::format("int {}", name);
    }
    // "float NAME(PARAMETERS) {"
    [[nodiscard]] std::string opening(std::string_view before, std::string_view type, std::string_view name,
                                      std::string_view parameters) const {
        return in_wgsl() ? fmt::format("fn {}({}) -> {} {{\n", name, parameters, type)
                         : fmt::format("{}{} {}({}) {{\n", before, type, name, parameters);
    }
    // "sqrt", in C "sqrtf"
    [[nodiscard]] std::string function(std::string_view name) const {
        if (!in_c()) return std::string(name);
        if (name == "max" || name == "min") return fmt::format("f{}f", name);
        return fmt::format("{}f", name);
    }
    [[nodiscard]] std::string within(std::string_view value) const {
        return fmt::format("{}({}({}, {}), {})", function("min"), function("max"), value, number(0.0), number(1.0));
    }
    [[nodiscard]] std::string qualifier() const {
        return in_c() ? "static inline " : (language == TableLanguage::msl ? "inline " : "");
    }
};

std::string comment(const Words& words) {
    const ShadingTable& table = words.table();
    std::string summary(words.info().summary);
    summary.front() = to_upper(summary.front());
    std::string text = fmt::format("// {}.\n//\n", summary);
    const bool lobe = words.info().is_lobe();
    const bool heitz = table.kind == TableKind::ltc_heitz;
    if (!lobe)
        for (const TableChannel& channel : words.info().channels)
            text += fmt::format("//   {:12} {}\n", channel.name, channel.says);
    else if (heitz)
        text += "// With z the normal, x = normalize(view - z dot(z, view)) and y = cross(z, x) a direction p becomes\n"
                "// p' = (m00 x + m02 z, y, m20 x + m22 z). E' is the integral of z'/pi over what of a light is above "
                "z' = 0\n"
                "// after the transform. A light reflects E' * (F0 * (magnitude - fresnel) + fresnel) times its "
                "luminance.\n";
    else
        text +=
            "// With z the normal, x = normalize(z dot(z, view) - view) and y = cross(z, x) a direction p becomes\n"
            "// p' = (m00 x + m02 z, m11 y, m20 x + m22 z). A light covers the share E'/mass of the lobe, where E' is\n"
            "// the integral of z'/pi over what it covers after the transform, without a clip there: clip the light\n"
            "// at the surface's own horizon, z = 0, before.\n";
    if (lobe && !heitz)
        text += words.table().kind == TableKind::ltc_ggx
                    ? "// It reflects share * (F0 * (albedo - grazing) + grazing) times the light's luminance.\n"
                    : "// It reflects share * albedo times base colour and the light's luminance.\n";
    text += fmt::format("//   n_dot_v      [0, 1]\n//   roughness    linear, [0, 1]: alpha = roughness * roughness\n");
    if (table.form == TableForm::chebyshev)
        text += fmt::format("// A polynomial of {} x {} terms in the square root of n_dot_v and in roughness.\n",
                            table.width, table.height);
    else
        text += fmt::format("// {} x {} texels of {}: {}; {}.\n", table.width, table.height,
                            info_of(words.stored.pixel).name, columns_in_words(table), rows_in_words(table));
    return text;
}

std::string structure(const Words& words) {
    std::string text = fmt::format("struct {} {{\n", words.structure());
    const auto member = [&](std::string_view name) {
        text += fmt::format("    {}{}\n", words.number_named(name), words.in_wgsl() ? "," : ";");
    };
    if (words.info().is_lobe() && words.table().kind != TableKind::ltc_heitz) {
        if (words.in_wgsl())
            for (const std::string_view name : {"m00", "m02", "m11", "m20", "m22"})
                member(name);
        else
            text += "    float m00, m02, m11, m20, m22;\n";
        member("mass");
        member("albedo");
        if (words.table().kind == TableKind::ltc_ggx) member("grazing");
    } else {
        for (const TableChannel& channel : words.info().channels)
            if (channel.is_of_pose) member(channel.name);
    }
    return text + (words.in_wgsl() ? "}\n" : "};\n");
}

// The numbers of the table in a list, some in a line.
template<class Each>
std::string listed(std::size_t count, std::size_t in_line, const Each& each) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += fmt::format("{}{}{}", i % in_line == 0 ? "    " : " ", each(i),
                            i + 1 == count ? "\n" : ((i + 1) % in_line == 0 ? ",\n" : ","));
    return text;
}

// Clenshaw's recurrence over the columns within that over the rows.
std::string series(const Words& words) {
    const ShadingTable& table = words.table();
    const std::size_t count = table.values.size();
    const std::string numbers =
        listed(count, 6, [&](std::size_t i) { return words.number(static_cast<double>(table.values[i])); });
    const std::string zero = words.number(0.0);
    const std::string two = words.number(2.0);
    const std::string name = words.prefix();
    std::string text;
    switch (words.language) {
    case TableLanguage::glsl:
        text = fmt::format("const float {0}_terms[{1}] = float[{1}](\n{2});\n", name, count, numbers);
        break;
    case TableLanguage::wgsl:
        text = fmt::format("const {}_terms = array<f32, {}>(\n{});\n", name, count, numbers);
        break;
    case TableLanguage::hlsl:
    case TableLanguage::msl:
    case TableLanguage::c:
        text = fmt::format("{} float {}_terms[{}] = {{\n{}}};\n",
                           words.language == TableLanguage::msl ? "static constant" : "static const", name, count,
                           numbers);
        break;
    }
    const std::string_view real = words.in_wgsl() ? "f32" : "float";
    // The sum Σ c_k T_k(AT) down from the last term; TERM is c_k.
    const auto sum = [&](std::string_view at, int last, std::string_view term) {
        return fmt::format("    {one} = {zero};\n"
                           "    {before} = {zero};\n"
                           "    for ({k} = {last}; k > 0; {down}) {{\n"
                           "        {next} = {two} * {at} * one - before + {term};\n"
                           "        before = one;\n"
                           "        one = next;\n"
                           "    }}\n",
                           fmt::arg("one", words.variable("one")), fmt::arg("before", words.variable("before")),
                           fmt::arg("next", words.constant("next")), fmt::arg("zero", zero), fmt::arg("two", two),
                           fmt::arg("k", words.in_wgsl() ? "var k" : "int k"),
                           fmt::arg("down", words.in_wgsl() ? "k--" : "--k"), fmt::arg("last", last),
                           fmt::arg("at", at), fmt::arg("term", term));
    };
    text += words.opening(
        words.qualifier(), real, name + "_row",
        fmt::format("{}, {}, {}", words.integer_named("row"), words.integer_named("channel"), words.number_named("x")));
    text += fmt::format("    {} first = row * {} * {} + channel;\n", words.in_wgsl() ? "let" : "int", table.width,
                        table.channels());
    text += sum("x", table.width - 1, fmt::format("{}_terms[first + k * {}]", name, table.channels()));
    text += fmt::format("    return x * one - before + {}_terms[first];\n}}\n", name);
    text += words.opening(
        words.qualifier(), real, name + "_series",
        fmt::format("{}, {}, {}", words.integer_named("channel"), words.number_named("x"), words.number_named("y")));
    text += sum("y", table.height - 1, fmt::format("{}_row(k, channel, x)", name));
    text += fmt::format("    return y * one - before + {}_row(0, channel, x);\n}}\n", name);
    return text;
}

// A coordinate of the texture: that of the middle of the first texel at 0, and of the last one at 1.
std::string coordinate(const Words& words, std::string_view at, int count) {
    if (words.table().axes == TableAxes::linear) return std::string(at);
    return fmt::format("{} * {} + {}", at, words.number((count - 1.0) / count), words.number(0.5 / count));
}

// Where a lookup is between texels, as the number of a column or row.
std::string place(const Words& words, std::string_view at, int count) {
    if (words.table().axes == TableAxes::linear)
        return fmt::format("{} * {} - {}", at, words.number(count), words.number(0.5));
    return fmt::format("{} * {}", at, words.number(count - 1.0));
}

// Declares the four numbers of a layer at the coordinates u and v.
std::string texel(const Words& words, std::size_t layer, bool array, std::string_view u, std::string_view v) {
    const std::string third = array ? fmt::format(", {}", words.number(static_cast<double>(layer))) : "";
    const std::string whole = array ? fmt::format(", {}", layer) : "";
    switch (words.language) {
    case TableLanguage::glsl:
        return fmt::format("    vec4 layer{} = texture(table, vec{}({}, {}{}));\n", layer, array ? 3 : 2, u, v, third);
    case TableLanguage::hlsl:
        return fmt::format("    float4 layer{} = table.SampleLevel(held, float{}({}, {}{}), 0.0);\n", layer,
                           array ? 3 : 2, u, v, third);
    case TableLanguage::msl:
        return fmt::format("    float4 layer{} = table.sample(held, float2({}, {}){}, level(0.0f));\n", layer, u, v,
                           whole);
    case TableLanguage::wgsl:
        return fmt::format("    let layer{} = textureSampleLevel(table, held, vec2<f32>({}, {}){}, 0.0);\n", layer, u,
                           v, whole);
    case TableLanguage::c:
        break;
    }
    return {};
}

// Declares the float of a channel, from an expression of what the table holds.
std::string number_of(const Words& words, std::size_t channel, std::string_view held) {
    const std::string_view name = words.info().channels[channel].name;
    if (!words.table().holds_root(channel)) return fmt::format("    {} = {};\n", words.constant(name), held);
    return fmt::format("    {} = {};\n    {} = {}_root * {}_root;\n", words.constant(fmt::format("{}_root", name)),
                       held, words.constant(name), name, name);
}

// Declares a float for each channel, from the coordinates x and y of the axes.
std::string fetch(const Words& words) {
    const std::span<const TableChannel> channels = words.info().channels;
    const ShadingTable& table = words.table();
    std::string text;
    if (table.form == TableForm::chebyshev || words.in_c()) {
        const bool polynomial = table.form == TableForm::chebyshev;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (!channels[c].is_of_pose) continue;
            text += number_of(
                words, c,
                polynomial ? fmt::format("{}_series({}, {} * x - {}, {} * y - {})", words.prefix(), c,
                                         words.number(2.0), words.number(1.0), words.number(2.0), words.number(1.0))
                           : fmt::format("{}_at({}, {}, {})", words.prefix(), place(words, "x", table.width),
                                         place(words, "y", table.height), c));
        }
        return text;
    }
    const std::string u = coordinate(words, "x", table.width);
    const std::string v = coordinate(words, "y", table.height);
    const bool array = words.stored.layers.size() > 1;
    std::size_t channel = 0;
    for (std::size_t layer = 0; layer < words.stored.layers.size(); ++layer) {
        text += texel(words, layer, array, u, v);
        for (std::size_t c = 0; c < words.stored.layers[layer]; ++c, ++channel) {
            if (!channels[channel].is_of_pose) continue;
            const ChannelRange range = words.stored.ranges[channel];
            const std::string read = fmt::format("layer{}.{}", layer, std::string_view("xyzw").substr(c, 1));
            text +=
                number_of(words, channel,
                          info_of(words.stored.pixel).steps > 0.0
                              ? fmt::format("{} * {} + {}", read, words.number(range.scale), words.number(range.offset))
                              : read);
        }
    }
    return text;
}

std::string parameters(const Words& words) {
    const bool polynomial = words.table().form == TableForm::chebyshev;
    if (polynomial || words.in_c()) return "";
    const bool array = words.stored.layers.size() > 1;
    switch (words.language) {
    case TableLanguage::glsl:
        return fmt::format("highp sampler2D{} table, ", array ? "Array" : "");
    case TableLanguage::hlsl:
        return fmt::format("Texture2D{}<float4> table, SamplerState held, ", array ? "Array" : "");
    case TableLanguage::msl:
        return fmt::format("texture2d{}<float> table, sampler held, ", array ? "_array" : "");
    case TableLanguage::wgsl:
        return fmt::format("table: texture_2d{}<f32>, held: sampler, ", array ? "_array" : "");
    case TableLanguage::c:
        break;
    }
    return "";
}

std::string lookup(const Words& words) {
    const bool linear = words.table().axes == TableAxes::linear;
    std::string text = words.opening(
        words.in_c() ? "static inline struct " : words.qualifier(), words.structure(), words.prefix() + "_lookup",
        fmt::format("{}{}, {}", parameters(words), words.number_named("n_dot_v"), words.number_named("roughness")));
    const bool heitz = words.table().axes == TableAxes::heitz;
    const bool lobe = words.info().is_lobe() && !heitz;
    text += fmt::format("    {} = {};\n", words.constant("mu"), words.within("n_dot_v"));
    if (heitz) {
        text += fmt::format("    {} = {};\n", words.constant("x"), words.within("roughness"));
        text += fmt::format("    {} = {}({} - mu);\n", words.constant("y"), words.function("sqrt"), words.number(1.0));
    } else {
        text += linear ? fmt::format("    {} = mu;\n", words.constant("x"))
                       : fmt::format("    {} = {}(mu);\n", words.constant("x"), words.function("sqrt"));
        text += fmt::format("    {} = {};\n", words.constant("y"), words.within("roughness"));
    }
    text += fetch(words);
    text += words.in_wgsl() ? fmt::format("    var result: {};\n", words.structure())
                            : fmt::format("    {}{} result;\n", words.in_c() ? "struct " : "", words.structure());
    if (!lobe) {
        for (const TableChannel& channel : words.info().channels)
            if (channel.is_of_pose) text += fmt::format("    result.{0} = {0};\n", channel.name);
        return text + "    return result;\n}\n";
    }
    const std::string one = words.number(1.0);
    const bool specular = words.table().kind == TableKind::ltc_ggx;
    text += fmt::format("    {} = {}(({} - mu) * ({} + mu));\n", words.constant("s"), words.function("sqrt"), one, one);
    text += specular ? fmt::format("    {} = {}(y * y, {});\n", words.constant("width"), words.function("max"),
                                   words.number(1e-4))
                     : fmt::format("    {} = {};\n", words.constant("width"), one);
    text += fmt::format("    result.m00 = {}(along * mu + raised * s * s, {});\n"
                        "    result.m02 = (raised * mu - along) * s;\n"
                        "    result.m11 = across;\n"
                        "    result.m20 = width * slant * s;\n"
                        "    result.m22 = width;\n"
                        "    result.mass = result.m00 / {}(result.m00 * result.m00 + result.m20 * result.m20);\n"
                        "    result.albedo = albedo;\n",
                        words.function("max"), words.number(1e-18), words.function("sqrt"));
    if (specular) text += "    result.grazing = grazing;\n";
    return text + "    return result;\n}\n";
}

struct CType {
    const char* name;
    std::size_t in_line;
};

CType c_type(TablePixel pixel) {
    switch (pixel) {
    case TablePixel::float32:
        return {"float", 6};
    case TablePixel::half:
    case TablePixel::uint16:
        return {"uint16_t", 12};
    case TablePixel::rgb9e5:
        return {"uint32_t", 8};
    case TablePixel::uint8:
        return {"uint8_t", 18};
    }
    return {"float", 6};
}

// The number that a component stands for, as an expression of its place in the data.
std::string c_value(const Words& words) {
    const std::string data = words.prefix() + "_data";
    switch (words.stored.pixel) {
    case TablePixel::float32:
        return fmt::format("    return {}[place];\n", data);
    case TablePixel::half:
        return fmt::format("    int exponent = ({0}[place] >> 10) & 31;\n"
                           "    float mantissa = (float)({0}[place] & 1023);\n"
                           "    float size = exponent == 0 ? ldexpf(mantissa, -24)\n"
                           "                               : ldexpf(mantissa + 1024.0f, exponent - 25);\n"
                           "    return ({0}[place] & 0x8000) != 0 ? -size : size;\n",
                           data);
    case TablePixel::rgb9e5:
        return fmt::format("    return ldexpf((float)(({0}[place] >> (9 * channel)) & 511u), (int)({0}[place] >> 27) - "
                           "24);\n",
                           data);
    case TablePixel::uint16:
    case TablePixel::uint8:
        return fmt::format("    return {0}_offset[channel] + {0}_scale[channel] * ((float){1}[place] / {2});\n",
                           words.prefix(), data, words.number(info_of(words.stored.pixel).steps));
    }
    return {};
}

// Where a component is in the data: layer after layer.
std::string c_place(const Words& words) {
    std::string texel = fmt::format("row * {} + column", words.table().width);
    if (words.stored.pixel == TablePixel::rgb9e5) return texel;
    const std::vector<std::size_t>& layers = words.stored.layers;
    if (layers.size() == 1) return fmt::format("({}) * {} + channel", texel, layers[0]);
    const std::size_t texels =
        static_cast<std::size_t>(words.table().width) * static_cast<std::size_t>(words.table().height);
    return fmt::format("channel < {0} ? ({1}) * {0} + channel : {2} + ({1}) * {3} + channel - {0}", layers[0], texel,
                       texels * layers[0], layers[1]);
}

std::string c_data(const Words& words) {
    const StoredTable& stored = words.stored;
    const auto [type, in_line] = c_type(stored.pixel);
    std::string text = fmt::format("static const {} {}_data[{}] = {{\n", type, words.prefix(), stored.stored.size());
    text += listed(stored.stored.size(), in_line, [&](std::size_t i) {
        const std::uint32_t bits = stored.stored[i];
        if (stored.pixel == TablePixel::float32)
            return words.number(static_cast<double>(__builtin_bit_cast(float, bits)));
        return stored.pixel == TablePixel::rgb9e5 ? fmt::format("{}u", bits) : fmt::format("{}", bits);
    });
    text += "};\n";
    if (info_of(stored.pixel).steps > 0.0)
        for (const auto& [name, member] :
             {std::pair{"offset", &ChannelRange::offset}, {"scale", &ChannelRange::scale}}) {
            std::vector<double> numbers;
            for (const ChannelRange& range : stored.ranges)
                numbers.push_back(range.*member);
            text += fmt::format("static const float {}_{}[{}] = {{\n{}}};\n", words.prefix(), name, numbers.size(),
                                listed(numbers.size(), 6, [&](std::size_t c) { return words.number(numbers[c]); }));
        }
    text += fmt::format("static inline float {0}_component(int column, int row, int channel) {{\n"
                        "    int place = {1};\n"
                        "{2}"
                        "}}\n",
                        words.prefix(), c_place(words), c_value(words));
    text += fmt::format("static inline float {0}_at(float x, float y, int channel) {{\n"
                        "    float across = fminf(fmaxf(x, 0.0f), {1}.0f);\n"
                        "    float down = fminf(fmaxf(y, 0.0f), {2}.0f);\n"
                        "    int left = (int)across;\n"
                        "    int top = (int)down;\n"
                        "    int right = left < {1} ? left + 1 : left;\n"
                        "    int bottom = top < {2} ? top + 1 : top;\n"
                        "    float low = {0}_component(left, top, channel);\n"
                        "    float high = {0}_component(left, bottom, channel);\n"
                        "    low += (across - (float)left) * ({0}_component(right, top, channel) - low);\n"
                        "    high += (across - (float)left) * ({0}_component(right, bottom, channel) - high);\n"
                        "    return low + (down - (float)top) * (high - low);\n"
                        "}}\n",
                        words.prefix(), words.table().width - 1, words.table().height - 1);
    return text;
}

std::string axis_in_words(const ShadingTable& table, std::string_view value, std::string_view root,
                          std::string_view index, int count, std::string_view from) {
    if (table.form == TableForm::chebyshev)
        return fmt::format("{}: the term of Chebyshev's polynomial T of that degree in 2 {} - 1", index, root);
    if (table.axes == TableAxes::linear)
        return fmt::format("{} = ({} + 0.5)/{}, from the {}", value, index, count, from);
    return fmt::format("{} = {}/{}, from the {}", root, index, count - 1, from);
}

} // namespace

std::string columns_in_words(const ShadingTable& table) {
    if (table.axes == TableAxes::heitz)
        return axis_in_words(table, "roughness", "roughness", "column", table.width, "left");
    return axis_in_words(table, "n.v", "sqrt(n.v)", "column", table.width, "left");
}

std::string rows_in_words(const ShadingTable& table) {
    if (table.axes == TableAxes::heitz) return axis_in_words(table, "n.v", "sqrt(1 - n.v)", "row", table.height, "top");
    return axis_in_words(table, "roughness", "roughness", "row", table.height, "top");
}

std::string table_lookup(const StoredTable& stored, TableLanguage language) {
    const Words words{stored, language};
    std::string text = language == TableLanguage::msl ? "#include <metal_stdlib>\nusing namespace metal;\n\n" : "";
    text += structure(words) + "\n";
    if (stored.table.form == TableForm::chebyshev) text += series(words) + "\n";
    return text + comment(words) + lookup(words);
}

std::string table_header(const StoredTable& stored) {
    const Words words{stored, TableLanguage::c};
    const ShadingTable& table = stored.table;
    // Two tables of one name in a program are a compiler's error, and not the first one in place of the second.
    const std::string guard = to_upper(fmt::format(
        "gonio_table_{}_{}x{}_{}_{}_h", words.prefix(), table.width, table.height,
        table.form == TableForm::chebyshev ? to_text(table.form) : to_text(table.axes), info_of(stored.pixel).name));
    std::string text = fmt::format("// Printed by gonio: the table {}. For C99 and C++.\n#ifndef {}\n#define {}\n\n",
                                   words.info().name, guard, guard);
    text += "#include <math.h>\n";
    if (stored.pixel != TablePixel::float32) text += "#include <stdint.h>\n";
    text += "\n";
    if (table.form == TableForm::bilinear) text += c_data(words) + "\n";
    return text + table_lookup(stored, TableLanguage::c) + fmt::format("\n#endif // {}\n", guard);
}

} // namespace gonio
