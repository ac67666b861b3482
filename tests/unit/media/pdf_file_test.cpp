#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/module.hpp>
#include <gonio/media/pdf_file.hpp>
#include <gonio/plot/page_font_widths.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::media {
namespace {

class Pdf : public testing::Test {
protected:
    void SetUp() override { set_module_folders({test::modules_folder}); }
    void TearDown() override { set_module_folders({}); }
};

Drawing page_of(std::string_view text) {
    Drawing page(595, 842, "page");
    page.text({40.0, 60.0}, text, {TextAnchor::start, 9.0, ink(0x1c1c1c)});
    page.text({40.0, 90.0}, "Bold 12", {TextAnchor::end, 12.0, ink(0x000000, 0.5), true, 1.0});
    page.rectangle({10.0, 10.0}, 100.0, 5.0, ink(0xff0000));
    page.circle({50.0, 200.0}, 10.0, ink(0x00ff00));
    page.begin_clip({0.0, 0.0}, 300.0, 300.0);
    PagePath path;
    path.move_to({1.0, 2.0}).line_to({30.0, 40.0}).line_to({50.0, 2.0}).close();
    page.fill(path, ink(0x0000ff, 0.3));
    page.stroke(std::move(path), {ink(0x000000), 1.0, {3.0, 2.0}});
    page.end_clip();
    return page;
}

std::size_t count_of(std::string_view text, std::string_view what) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

std::size_t number_at(std::string_view text) {
    std::size_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

// The header, the end, and a cross-reference table in which each entry points at its object.
void expect_valid(std::string_view pdf) {
    EXPECT_TRUE(pdf.starts_with("%PDF-1.5\n"));
    EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
    const std::size_t start = pdf.rfind("startxref\n");
    ASSERT_NE(start, std::string_view::npos);
    const std::size_t table = number_at(pdf.substr(start + 10));
    ASSERT_LT(table, pdf.size());
    ASSERT_TRUE(pdf.substr(table).starts_with("xref\n0 "));
    const std::size_t objects = number_at(pdf.substr(table + 7));
    const std::size_t entries = pdf.find('\n', table + 5) + 1;
    ASSERT_LE(entries + 20 * objects, pdf.size());
    for (std::size_t i = 1; i < objects; ++i) {
        const std::size_t at = number_at(pdf.substr(entries + 20 * i));
        const std::string head = std::to_string(i) + " 0 obj";
        ASSERT_LT(at, pdf.size());
        EXPECT_TRUE(pdf.substr(at).starts_with(head)) << i;
    }
}

TEST_F(Pdf, ItIsValidAndHasItsFontsAndPages) {
    const std::vector<Drawing> pages{page_of("Größe 60 m², Ø 3 °C"), page_of("Светильник")};
    const Result<std::string> pdf = to_pdf(pages, {"Title", "Maker", {}});
    ASSERT_TRUE(pdf) << pdf.error().diagnostics.back().message;
    expect_valid(*pdf);
    EXPECT_EQ(count_of(*pdf, "/Type /Page "), 2U);
    EXPECT_GE(count_of(*pdf, "/FontFile2") + count_of(*pdf, "/FontFile3"), 2U); // regular and bold
    EXPECT_GE(count_of(*pdf, "/ToUnicode"), 2U);
    EXPECT_NE(pdf->find("+DejaVuSans-Bold"), std::string::npos);
    EXPECT_NE(pdf->find("(Title)"), std::string::npos);
    EXPECT_NE(pdf->find("(Maker)"), std::string::npos);
    EXPECT_NE(pdf->find("/MediaBox [ 0 0 595 842 ]"), std::string::npos);
    EXPECT_EQ(pdf->find("/Subtype /Image"), std::string::npos); // lines and text, no pixels
}

TEST_F(Pdf, EqualPagesGiveEqualBytesAndNoDate) {
    const std::vector<Drawing> pages{page_of("same")};
    const Result<std::string> once = to_pdf(pages);
    const Result<std::string> again = to_pdf(pages);
    ASSERT_TRUE(once && again);
    EXPECT_EQ(*once, *again);
    EXPECT_EQ(once->find("CreationDate"), std::string::npos);
    EXPECT_EQ(once->find("ModDate"), std::string::npos);
}

TEST_F(Pdf, TextOfAnyBytesGivesAValidFile) {
    const std::vector<Drawing> pages{page_of("caf\xe9 \xff\xfe \x01\x02 )\\( \xe2\x80\xae"), page_of(""),
                                     page_of("\xf0\x9f\x92\xa1")};
    const Result<std::string> pdf = to_pdf(pages, {"t\xe9\x01)", "(\xff", {}});
    ASSERT_TRUE(pdf) << pdf.error().diagnostics.back().message;
    expect_valid(*pdf);
}

TEST_F(Pdf, MissingFontsAreNamedWithTheirPackage) {
    const std::vector<Drawing> pages{page_of("no font")};
    const Result<std::string> pdf = to_pdf(pages, {{}, {}, {"/nonexistent"}});
    ASSERT_FALSE(pdf);
    EXPECT_EQ(pdf.error().failure, Failure::unsupported);
    EXPECT_EQ(pdf.error().diagnostics.back().code, "UNS0105");
    EXPECT_NE(pdf.error().diagnostics.back().message.find("/nonexistent"), std::string::npos);
    EXPECT_NE(pdf.error().diagnostics.back().hint.find("fonts-dejavu-core"), std::string::npos);
    EXPECT_FALSE(check_pdf({{}, {}, {"/nonexistent"}}));
    EXPECT_TRUE(check_pdf({}));
}

// The widths by which pages are laid out are those of the font.
TEST_F(Pdf, WidthsAreThoseOfTheFonts) {
    const auto module = detail::pdf_module();
    ASSERT_TRUE(module);
    const std::string folder = default_font_folders().front();
    const std::string regular = folder + "/DejaVuSans.ttf";
    const std::string bold = folder + "/DejaVuSans-Bold.ttf";
    const abi::PdfRequest request{regular.c_str(), bold.c_str(), "", "", ""};
    std::array<char, abi::message_bytes> message{};
    abi::PdfDocument* document = nullptr;
    ASSERT_EQ((*module)->open(&request, &document, message.data()), abi::done) << message.data();
    for (const plot_detail::LetterRange& range : plot_detail::letter_ranges())
        for (char32_t code = range.first; code <= range.last; ++code) {
            std::string text;
            if (code < 0x80) {
                text = static_cast<char>(code);
            } else if (code < 0x800) {
                text = {static_cast<char>(0xC0U | code >> 6U), static_cast<char>(0x80U | (code & 0x3FU))};
            } else {
                text = {static_cast<char>(0xE0U | code >> 12U), static_cast<char>(0x80U | (code >> 6U & 0x3FU)),
                        static_cast<char>(0x80U | (code & 0x3FU))};
            }
            for (const bool is_bold : {false, true}) {
                const auto width = plot_detail::letter_width(code, is_bold);
                if (!width) continue;
                EXPECT_NEAR((*module)->text_width(document, text.c_str(), is_bold ? 1 : 0), *width / 2048.0, 1e-9)
                    << std::hex << static_cast<unsigned>(code);
            }
        }
    (*module)->close(document);
}

} // namespace
} // namespace gonio::media
