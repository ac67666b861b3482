#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"
#include "../sheet/profile_pages.hpp"
#include "../sheet/rig_pages.hpp"
#include "../sheet/sheet_output.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array sheet_options{
    paper_option,
    Option{"--use", "USE", "indoor: UGR and utilisation; outdoor: classes and isolux (auto, by the light)"},
    Option{"--height", "LENGTH", "height of the light above the plane, for isolux and cone (8m outdoors, 3m indoors)"},
};
constexpr std::array write_options{
    Option{"-o,--output", "FILE", "the pages: .pdf, .html, or .svg, a file for each page; '-' is stdout"},
    Option{"--to", "FORMAT", "pdf, svg or html, if the file name does not show it"},
    fonts_option,
    Option{"-n,--dry-run", "", "check the options, and write nothing"},
    durable_option,
};
constexpr std::array groups{OptionGroup{"sheet", sheet_options},
                            OptionGroup{"room", rig_page_options},
                            task_group,
                            OptionGroup{"output", write_options},
                            profile_input_group,
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio sheet lamp.ldt -o lamp.pdf", "data, diagrams, UGR table and utilisation factors, on A4"},
    Example{"gonio sheet street.ies --use outdoor --height 10m -o street.pdf", "classes, and isolux from 10 m"},
    Example{"gonio sheet catalogue --paper letter -o catalogue.pdf", "a folder, in one PDF for US letter"},
    Example{"gonio sheet lamp.ldt -o lamp.html", "the same pages for a browser"},
    Example{"gonio sheet room.json --task office.writing -o room.pdf",
            "the plan of a rig in a room, with a verdict for each requirement"},
};

struct SheetRequest {
    std::vector<std::string> files;
    SheetOutput output;
    DataSheetOptions sheet;
    RigPageOptions rig;
    ProfileInputOptions input;
    unsigned threads = 0;
};

Result<SheetRequest> parse(const Arguments& arguments) {
    SheetRequest request;
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return pass_on(files);
    if (files->size() > limit("sheet-files").value)
        return fail("USE0106", fmt::format("{} files are more than {}", files->size(), to_text(limit("sheet-files"))),
                    std::string(limits_hint));
    request.files = std::move(*files);
    if (const auto use = arguments.value("--use")) {
        constexpr std::array uses{Named{"auto", LuminaireUse::automatic}, Named{"indoor", LuminaireUse::indoor},
                                  Named{"outdoor", LuminaireUse::outdoor}};
        Result<LuminaireUse> found = find_value("use", *use, uses);
        if (!found) return pass_on(found);
        request.sheet.use = *found;
    }
    if (const auto text = arguments.value("--height")) {
        Result<double> height = parse_amount(*text, Dimension::length, "--height");
        if (!height) return pass_on(height);
        if (!(*height > 0.0))
            return fail("USE0105", fmt::format("--height takes a length greater than 0, not '{}'", *text));
        request.sheet.height_m = *height;
    }
    Result<RigPageOptions> rig = rig_page_options_of(arguments);
    if (!rig) return pass_on(rig);
    request.rig = std::move(*rig);
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    request.input = *input;
    request.input.photometric = true;
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.threads = *threads;
    Result<SheetOutput> output = sheet_output(arguments);
    if (!output) return pass_on(output);
    request.output = std::move(*output);
    request.sheet.paper = request.output.paper;
    // A rig may name its own files, one after the other.
    request.rig.threads = request.files.size() > 1 ? 1 : request.threads;
    return request;
}

// The pages of one file.
struct FilePages {
    std::vector<Drawing> pages;
    SheetTitle title;
    std::vector<std::string> files; // all that were read
};

Outcome make_pages(const SheetRequest& request, const Arguments& arguments, const std::string& file, FilePages& made) {
    Outcome outcome;
    if (ends_with_any_case(file, ".json")) {
        Result<RigPage> page = rig_page(file, arguments, request.rig, request.output.paper, outcome.diagnostics);
        if (!page) {
            outcome.error = std::move(page.error());
            return outcome;
        }
        add_letters_note(page->sheet.replaced, file, outcome.diagnostics);
        outcome.status = page->has_failed ? 1 : 0;
        made = {std::move(page->sheet.pages), {std::move(page->title), {}}, std::move(page->files)};
        return outcome;
    }
    Result<LoadedProfile> loaded = load(file, request.input);
    if (!loaded) {
        outcome.error = std::move(loaded.error());
        return outcome;
    }
    ProfilePages pages = profile_pages(file, *loaded, request.input.resolve, request.sheet);
    outcome.diagnostics = std::move(loaded->diagnostics);
    add_letters_note(pages.sheet.replaced, file, outcome.diagnostics);
    made = {std::move(pages.sheet.pages), {std::move(pages.name), std::move(pages.maker)}, {file}};
    return outcome;
}

// One file says its name and maker, several their number.
SheetTitle title_of(const std::vector<FilePages>& all) {
    const FilePages* only = nullptr;
    std::size_t count = 0;
    for (const FilePages& each : all) {
        if (each.pages.empty()) continue;
        only = &each;
        ++count;
    }
    if (count == 1) return only->title;
    return {fmt::format("{} data sheets", count), {}};
}

Result<int> run_sheet(const Arguments& arguments, Console& console) {
    Result<SheetRequest> request = parse(arguments);
    if (!request) return pass_on(request);
    const std::size_t usual_pages = 2;
    // Names of one and of several pages are both checked before the work; those that come out, after it.
    for (const std::size_t pages : {std::size_t{1}, usual_pages})
        if (Result<void> free = check_outputs(request->files, sheet_files(request->output, pages)); !free)
            return pass_on(free);
    if (arguments.has("--dry-run")) {
        console.print(request->output.file + "\n");
        return 0;
    }
    std::vector<FilePages> all(request->files.size());
    const Batch batch{request->files, "gonio.sheet/1", "drawn", request->threads};
    int status = run_batch(batch, ReportKind::words, console, [&](std::size_t index) {
        return make_pages(*request, arguments, request->files[index], all[index]);
    });
    std::vector<Drawing> pages;
    std::vector<std::string> read;
    const SheetTitle title = title_of(all);
    for (FilePages& each : all) {
        pages.insert(pages.end(), std::make_move_iterator(each.pages.begin()),
                     std::make_move_iterator(each.pages.end()));
        read.insert(read.end(), each.files.begin(), each.files.end());
    }
    if (pages.empty()) return status; // every file has its error
    if (Result<void> free = check_outputs(read, sheet_files(request->output, pages.size())); !free)
        return pass_on(free);
    if (Result<void> written = write_sheet(request->output, pages, title); !written) return pass_on(written);
    return status;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = run_sheet(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command sheet_command;
const Command sheet_command{
    "sheet",
    "make data sheets of luminaires, and of a room, as PDF, HTML or SVG",
    "FILE… -o OUT.pdf",
    "FILE is an IES, EULUMDAT or TM-33 profile, a folder of profiles, '-' for stdin, @LIST for a list of\n"
    "files, or a rig with a room as its stage (.json). A profile has two pages: its data, polar diagram,\n"
    "cartesian diagram and luminous opening, then the tables or classes by which such luminaires are\n"
    "planned. What a file does not give is replaced by the reason. A file that cannot be read is left out\n"
    "and reported.",
    groups,
    examples,
    run};

} // namespace gonio::cli
