#include "table_job.hpp"

#include <gonio/asset/table_sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/table/dds.hpp>
#include <gonio/table/stored_table.hpp>
#include <gonio/table/table_error.hpp>
#include <gonio/table/table_text.hpp>

#include "../batch.hpp"
#include "../json_text.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/values.hpp"
#include "../stopwatch.hpp"
#include "table_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array used_options{"--table",      "--axes",   "--form",    "--size",  "--pixel", "--sidecar",
                                  "--no-sidecar", "--output", "--durable", "--to",    "--json",  "--jsonl",
                                  "--jobs",       "--quiet",  "--verbose", "--color", "--help"};

struct Wanted {
    TableKind kind = TableKind::dfg;
    TableForm form = TableForm::bilinear;
    TableAxes axes = TableAxes::linear;
    int width = 0;
    int height = 0;
    TablePixel pixel = TablePixel::float32;
    const TableFormat* format = nullptr;
    std::string output;
    std::optional<std::string> sidecar;
    unsigned threads = 0;
};

Result<void> refuse_others(const Command& command, const Arguments& arguments) {
    if (!arguments.positional().empty())
        return fail("USE0107",
                    fmt::format("a table is made of no profile, but '{}' is given", arguments.positional().front()),
                    "leave it out, or leave --table out to bake the profile");
    for (const OptionGroup& group : command.groups)
        for (const Option& option : group.options) {
            const std::string_view name = spellings(option).back();
            if (arguments.has(name) && std::find(used_options.begin(), used_options.end(), name) == used_options.end())
                return fail("USE0107", fmt::format("--table does not take {}", name),
                            "leave it out; for example gonio bake --table dfg -s 32 -o dfg.dds");
        }
    return {};
}

Result<const TableFormat*> format_of(const Arguments& arguments, const std::string& output) {
    if (const auto named = arguments.value("--to"))
        return find_named("format of tables", to_lower(*named), table_formats);
    const std::string ending = to_lower(extension_of(output));
    for (const TableFormat& format : table_formats)
        if (!ending.empty() &&
            std::find(format.extensions.begin(), format.extensions.end(), ending) != format.extensions.end())
            return &format;
    return fail("USE0104", fmt::format("'{}' does not show the format of the table", output),
                "end it in .exr, .dds, .raw, .bin, .h, .hpp or .json, or add --to exr, dds, raw, header or json");
}

// N or WIDTHxHEIGHT.
Result<PixelSize> size_of(const Arguments& arguments, const TableInfo& table, TableForm form) {
    const auto text = arguments.value("--size");
    const PixelSize usual{table.size, table.size};
    constexpr PixelSize usual_terms{10, 10};
    if (!text) return form == TableForm::bilinear ? usual : usual_terms;
    const std::string both = text->find('x') == std::string::npos ? *text + "x" + *text : *text;
    if (Result<PixelSize> size = parse_size(both)) return size;
    return fail("USE0105", fmt::format("'{}' is not the size of a table", *text),
                "write N or WIDTHxHEIGHT, for example 32");
}

Result<Wanted> wanted(const Arguments& arguments) {
    Wanted want;
    auto info = find_named("table", *arguments.value("--table"), table_infos());
    if (!info) return pass_on(info);
    want.kind = (*info)->kind;
    if (const auto text = arguments.value("--form")) {
        constexpr std::array forms{Named{"bilinear", TableForm::bilinear}, Named{"chebyshev", TableForm::chebyshev}};
        Result<TableForm> form = find_value("form of a table", *text, forms);
        if (!form) return pass_on(form);
        want.form = *form;
    }
    want.axes = want.form == TableForm::chebyshev ? TableAxes::root : (*info)->axes.front();
    if (const auto text = arguments.value("--axes")) {
        constexpr std::array kinds{Named{"linear", TableAxes::linear}, Named{"root", TableAxes::root},
                                   Named{"heitz", TableAxes::heitz}};
        Result<TableAxes> axes = find_value("axes of a table", *text, kinds);
        if (!axes) return pass_on(axes);
        want.axes = *axes;
    }
    Result<PixelSize> size = size_of(arguments, **info, want.form);
    if (!size) return pass_on(size);
    want.width = size->width;
    want.height = size->height;
    if (const auto text = arguments.value("--pixel")) {
        auto pixel = find_named("pixel", *text, table_pixels());
        if (!pixel) return pass_on(pixel);
        want.pixel = (*pixel)->pixel;
    }
    const auto output = arguments.value("--output");
    if (!output) return fail("USE0104", "there is no output", "add -o FILE, for example -o dfg.dds");
    want.output = *output;
    Result<const TableFormat*> format = format_of(arguments, want.output);
    if (!format) return pass_on(format);
    want.format = *format;
    if (!want.format->holds_integers && want.pixel != TablePixel::float32 && want.pixel != TablePixel::half)
        return fail("USE0107", fmt::format("{} cannot store {} pixels", want.format->name, info_of(want.pixel).name),
                    "it stores float and half; dds, raw, header and json store every type");
    if (!want.format->holds_polynomials && want.form == TableForm::chebyshev)
        return fail("USE0107", fmt::format("{} stores pictures, and a polynomial is none", want.format->name),
                    "write .h, .json or .raw");
    if (want.form == TableForm::chebyshev && want.format->name == "header" && want.pixel == TablePixel::half)
        return fail("USE0107", "a header stores the terms of a polynomial as float, not as half",
                    "leave --pixel half out, or write .raw or .json");
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    want.threads = *threads;
    if (arguments.value("--sidecar") && (want.format->has_values || arguments.has("--no-sidecar")))
        return fail("USE0107",
                    want.format->has_values ? "a table in JSON is its own sidecar, but --sidecar is given"
                                            : "--sidecar and --no-sidecar are both given",
                    "leave --sidecar out");
    if (!want.format->has_values && !arguments.has("--no-sidecar")) {
        want.sidecar = arguments.value("--sidecar");
        if (!want.sidecar && want.output != "-") want.sidecar = want.output + ".json";
    }
    FilesInUse in_use({});
    for (const std::optional<std::string>& file : {std::optional(want.output), want.sidecar})
        if (file)
            if (Result<void> free = in_use.take(*file); !free) return pass_on(free);
    return want;
}

Result<std::string> exr_file(const StoredTable& stored) {
    const std::span<const TableChannel> channels = info_of(stored.table.kind).channels;
    Image image(stored.table.width, stored.table.height, static_cast<int>(channels.size()));
    image.pixels = stored.table.values;
    media::ImageWriteOptions options;
    options.pixel = stored.pixel == TablePixel::half ? media::Pixel::half : media::Pixel::float32;
    for (const TableChannel& channel : channels)
        options.channel_names.emplace_back(channel.name);
    return media::encode_image(image, *media::find_image_format("exr"), options);
}

Result<std::string> file_of(const StoredTable& stored, const TableFormat& format) {
    if (format.name == "exr") return exr_file(stored);
    if (format.name == "dds") return dds_file(stored);
    if (format.name == "header") return table_header(stored);
    return raw_bytes(stored);
}

} // namespace

Result<int> bake_table(const Command& command, const Arguments& arguments, Console& console) {
    if (Result<void> fine = refuse_others(command, arguments); !fine) return pass_on(fine);
    Result<Wanted> want = wanted(arguments);
    if (!want) return pass_on(want);
    const ReportKind kind = report_kind(arguments);
    if (kind != ReportKind::words && (want->output == "-" || want->sidecar == "-"))
        return both_to_standard_output(want->output == "-" ? "table" : "sidecar");
    const Stopwatch filling;
    Result<ShadingTable> table =
        make_shading_table(want->kind, want->form, want->axes, want->width, want->height, want->threads);
    if (!table) return pass_on(table);
    Result<StoredTable> stored = store_table(std::move(*table), want->pixel);
    if (!stored) return pass_on(stored);
    const double filled_ms = filling.milliseconds();
    TableDescription description{want->format->name, {}, {}};
    const bool described = want->sidecar || want->format->has_values || kind != ReportKind::words;
    const Stopwatch measuring;
    if (described)
        description.error = TableTruth(want->kind, TableTruth::usual_poses, want->threads).error_of(stored->table);
    console.remark(fmt::format("{}: filled in {:.2f} ms", want->output, filled_ms) +
                   (described ? fmt::format(", error measured in {:.2f} ms", measuring.milliseconds()) : ""));
    std::vector<OutputFile> files;
    if (!want->format->has_values) {
        Result<std::string> bytes = file_of(*stored, *want->format);
        if (!bytes) return pass_on(bytes);
        if (want->output != "-") description.file = file_record(file_name(want->output), *bytes);
        files.push_back({want->output, std::move(*bytes)});
    }
    const std::string sidecar = described ? table_sidecar(*stored, description) : std::string();
    if (want->format->has_values) files.push_back({want->output, sidecar});
    if (want->sidecar) files.push_back({*want->sidecar, sidecar});
    if (Result<void> written = write_outputs(files); !written) return pass_on(written);
    if (kind == ReportKind::words) return 0;
    Result<Json> described_json = detail::parse_json(sidecar);
    if (!described_json) return pass_on(described_json);
    Json report{{"schema", "gonio.bake-table/1"}, {"output", want->output}};
    report["table"] = std::move(*described_json);
    report["diagnostics"] = Json::array();
    console.print(dump(report, kind == ReportKind::jsonl ? -1 : 2));
    return 0;
}

} // namespace gonio::cli
