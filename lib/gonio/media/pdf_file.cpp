#include <gonio/base/file.hpp>
#include <gonio/base/version.hpp>
#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/pdf_file.hpp>
#include <gonio/profile/text_encoding.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>

namespace gonio::media {

namespace {

constexpr const char* regular_file = "DejaVuSans.ttf";
constexpr const char* bold_file = "DejaVuSans-Bold.ttf";

abi::PdfInk pdf_ink(Ink ink) {
    return {ink.r / 255.0, ink.g / 255.0, ink.b / 255.0, ink.opacity};
}

// Draws steps into a document.
class Writer {
public:
    Writer(const abi::PdfModule& module, abi::PdfDocument* document) : module_(module), document_(document) {}

    void operator()(const FilledPath& step) {
        set_parts(step.path);
        const abi::PdfInk ink = pdf_ink(step.ink);
        module_.fill(document_, parts_.data(), parts_.size(), &ink);
    }
    void operator()(const StrokedPath& step) {
        set_parts(step.path);
        const abi::PdfPen pen{pdf_ink(step.pen.ink), step.pen.width_px, step.pen.dash_px[0], step.pen.dash_px[1]};
        module_.stroke(document_, parts_.data(), parts_.size(), &pen);
    }
    void operator()(const FilledRectangle& step) {
        const abi::PdfInk ink = pdf_ink(step.ink);
        module_.rectangle(document_, step.corner.x, step.corner.y, step.width, step.height, &ink);
    }
    void operator()(const FilledCircle& step) {
        const abi::PdfInk ink = pdf_ink(step.ink);
        module_.circle(document_, step.center.x, step.center.y, step.radius, &ink);
    }
    void operator()(const WrittenText& step) {
        const TextStyle& style = step.style;
        const std::string utf8 = to_utf8(step.text); // cairo refuses a document for a text that is not
        const abi::PdfText text{
            utf8.c_str(),       step.at.x,     step.at.y,          static_cast<std::int32_t>(style.anchor),
            style.bold ? 1 : 0, style.size_px, pdf_ink(style.ink), style.rim_px,
            pdf_ink(style.rim)};
        module_.text(document_, &text);
    }
    void operator()(const ClipBegin& step) {
        module_.begin_clip(document_, step.corner.x, step.corner.y, step.width, step.height);
    }
    void operator()(const ClipEnd& /*step*/) { module_.end_clip(document_); }

private:
    void set_parts(const PagePath& path) {
        static_assert(sizeof(PagePoint) == 2 * sizeof(double));
        parts_.clear();
        for (const PagePath::Part& part : path.parts())
            if (!part.points.empty()) parts_.push_back({&part.points[0].x, part.points.size(), part.closed ? 1 : 0});
    }

    const abi::PdfModule& module_;
    abi::PdfDocument* document_;
    std::vector<abi::PdfPart> parts_;
};

// The folder that has both fonts.
Result<std::string> font_folder(const PdfOptions& options) {
    const std::vector<std::string> folders =
        options.font_folders.empty() ? default_font_folders() : options.font_folders;
    for (const std::string& folder : folders)
        if (file_exists(folder + '/' + regular_file) && file_exists(folder + '/' + bold_file)) return folder;
    return fail(
        "UNS0105",
        fmt::format("the fonts {} and {} are missing; looked in {}", regular_file, bold_file, fmt::join(folders, ", ")),
        "install the package fonts-dejavu-core");
}

} // namespace

std::vector<std::string> default_font_folders() {
    return {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts", "/usr/share/fonts/TTF",
            "/usr/local/share/fonts", "/opt/homebrew/share/fonts"};
}

Result<void> check_pdf(const PdfOptions& options) {
    if (Result<const abi::PdfModule*> module = detail::pdf_module(); !module) return pass_on(module);
    if (Result<std::string> folder = font_folder(options); !folder) return pass_on(folder);
    return {};
}

Result<std::string> to_pdf(std::span<const Drawing> pages, const PdfOptions& options) {
    Result<const abi::PdfModule*> module = detail::pdf_module();
    if (!module) return pass_on(module);
    Result<std::string> folder = font_folder(options);
    if (!folder) return folder;
    const std::string regular = *folder + '/' + regular_file;
    const std::string bold = *folder + '/' + bold_file;
    const std::string creator = fmt::format("gonio {}", version);
    const std::string title = to_utf8(options.title);
    const std::string author = to_utf8(options.author);
    const abi::PdfRequest request{regular.c_str(), bold.c_str(), title.c_str(), author.c_str(), creator.c_str()};
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    std::array<char, abi::message_bytes> message{};
    abi::PdfDocument* opened = nullptr;
    const int status = (*module)->open(&request, &opened, message.data());
    const std::unique_ptr<abi::PdfDocument, void (*)(abi::PdfDocument*)> document(opened, (*module)->close);
    if (status != abi::done)
        return fail(detail::cause_of(status), fmt::format("the PDF cannot be begun: {}", message.data()));
    Writer writer(**module, document.get());
    for (const Drawing& page : pages) {
        (*module)->begin_page(document.get(), page.width_px(), page.height_px());
        for (const DrawingStep& step : page.steps())
            std::visit(writer, step);
    }
    abi::PdfReply reply{};
    if (const int finished = (*module)->finish(document.get(), &reply, message.data()); finished != abi::done)
        return fail(detail::cause_of(finished), fmt::format("the PDF cannot be made: {}", message.data()));
    return std::string(reinterpret_cast<const char*>(reply.bytes), reply.size);
}

} // namespace gonio::media
