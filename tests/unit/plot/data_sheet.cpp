#include <gonio/base/folder.hpp>
#include <gonio/plot/data_sheet.hpp>
#include <gonio/plot/page_font.hpp>
#include <gonio/plot/room_sheet.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/resolve.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace gonio {
namespace {

struct TextBox {
    std::string text;
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
};

// The capitals of a text; descenders are not counted.
std::vector<TextBox> boxes_of(const Drawing& page) {
    std::vector<TextBox> boxes;
    for (const DrawingStep& step : page.steps()) {
        const auto* const text = std::get_if<WrittenText>(&step);
        if (text == nullptr) continue;
        const TextStyle& style = text->style;
        const double width = page_text_width(text->text, style.size_px, style.bold);
        const double left = text->at.x - (style.anchor == TextAnchor::start    ? 0.0
                                          : style.anchor == TextAnchor::middle ? 0.5 * width
                                                                               : width);
        boxes.push_back({text->text, left, left + width, text->at.y - 0.72 * style.size_px, text->at.y});
    }
    return boxes;
}

// Within the margins of printers, and no two over each other.
void expect_fine(const std::vector<Drawing>& pages, const std::string& name) {
    for (std::size_t p = 0; p < pages.size(); ++p) {
        const Drawing& page = pages[p];
        std::vector<TextBox> boxes = boxes_of(page);
        std::sort(boxes.begin(), boxes.end(), [](const TextBox& a, const TextBox& b) { return a.top < b.top; });
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const TextBox& box = boxes[i];
            EXPECT_GE(box.left, 20.0) << name << " page " << p + 1 << ": " << box.text;
            EXPECT_LE(box.right, page.width_px() - 20.0) << name << " page " << p + 1 << ": " << box.text;
            EXPECT_GE(box.top, 20.0) << name << " page " << p + 1 << ": " << box.text;
            EXPECT_LE(box.bottom, page.height_px() - 20.0) << name << " page " << p + 1 << ": " << box.text;
            for (std::size_t k = i + 1; k < boxes.size() && boxes[k].top < box.bottom; ++k)
                EXPECT_FALSE(boxes[k].left < box.right - 0.5 && box.left < boxes[k].right - 0.5 &&
                             boxes[k].top < box.bottom - 0.5)
                    << name << " page " << p + 1 << ": '" << box.text << "' and '" << boxes[k].text << "'";
        }
    }
}

struct Loaded {
    Profile profile;
    Web web;
};

std::optional<Loaded> loaded(const std::string& file) {
    Result<Profile> profile = read_profile_file(file);
    if (!profile) return std::nullopt;
    Result<ResolvedWeb> resolved = resolve_web(*profile);
    if (!resolved) return std::nullopt;
    return Loaded{std::move(*profile), std::move(resolved->web)};
}

DataSheetContent content_of(const Loaded& loaded) {
    const ProfileHeader header = header_of(loaded.profile);
    DataSheetContent content;
    content.file = "lamp.ldt";
    content.name = keyword_text(header, "LUMINAIRE");
    content.maker = keyword_text(header, "MANUFAC");
    content.catalogue_number = keyword_text(header, "LUMCAT");
    content.cct = keyword_text(header, "_CCT");
    content.cri = keyword_text(header, "_CRI");
    content.report = keyword_text(header, "TEST");
    content.web = &loaded.web;
    content.opening = opening_of(loaded.profile);
    content.facts = profile_facts(loaded.profile, loaded.web);
    content.figures = luminaire_figures(loaded.profile, loaded.web);
    return content;
}

bool shows(const DataSheet& sheet, std::string_view words) {
    for (const Drawing& page : sheet.pages)
        for (const TextBox& box : boxes_of(page))
            if (box.text.find(words) != std::string::npos) return true;
    return false;
}

void expect_all_fine(const std::string& folder, std::size_t least) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        const std::optional<Loaded> profile = loaded(entry.path().string());
        if (!profile) continue;
        const DataSheetContent content = content_of(*profile);
        if (content.facts.intensity_unit != "cd") continue;
        ++count;
        for (const PaperSize paper : {PaperSize::a4, PaperSize::letter})
            for (const LuminaireUse use : {LuminaireUse::indoor, LuminaireUse::outdoor}) {
                const DataSheet sheet = data_sheet(content, {paper, use, {}});
                expect_fine(sheet.pages, entry.path().filename().string());
                // The last lines of the lists, which would be left out for want of room.
                EXPECT_TRUE(shows(sheet, "Photometry"));
                EXPECT_TRUE(shows(sheet, use == LuminaireUse::indoor ? "Flux code" : "Light output ratio"));
            }
    }
    EXPECT_GE(count, least);
}

const std::string profiles = std::string(test::source_folder) + "/profiles";

TEST(DataSheet, TextsOfEveryProfileFitAndDoNotOverlap) {
    expect_all_fine(profiles, 24);
}

TEST(DataSheet, TextsOfRealProfilesFitAndDoNotOverlap) {
    if (std::string(test::corpus_folder).empty()) GTEST_SKIP() << "no corpus: set GONIO_CORPUS";
    expect_all_fine(test::corpus_folder, 1);
}

TEST(DataSheet, IndoorAndOutdoorLuminairesAreToldApart) {
    for (const auto& [name, is_outdoor] : {std::pair{"/street.ldt", true}, std::pair{"/batwing.ldt", false},
                                           std::pair{"/downlight.ies", false}, std::pair{"/pendant.xml", false}}) {
        const std::optional<Loaded> profile = loaded(profiles + name);
        ASSERT_TRUE(profile) << name;
        const DataSheet sheet = data_sheet(content_of(*profile));
        EXPECT_EQ(sheet.is_outdoor, is_outdoor) << name;
        EXPECT_EQ(shows(sheet, "BUG rating"), is_outdoor) << name;
        EXPECT_EQ(shows(sheet, "UGR, corrected"), !is_outdoor) << name;
    }
}

TEST(DataSheet, ItSaysWhyAFigureIsMissing) {
    std::optional<Loaded> profile = loaded(profiles + "/downlight.ies");
    ASSERT_TRUE(profile);
    auto& file = std::get<IesFile>(profile->profile.file);
    file.width = file.length = file.height = 0.0;
    DataSheetContent content = content_of(*profile);
    content.maker.clear();
    const DataSheet sheet = data_sheet(content);
    EXPECT_TRUE(shows(sheet, "None: the file states no luminous opening."));
    EXPECT_TRUE(shows(sheet, "not stated"));
}

TEST(DataSheet, HostileTextsStayOnThePage) {
    const std::optional<Loaded> profile = loaded(profiles + "/batwing.ldt");
    ASSERT_TRUE(profile);
    DataSheetContent content = content_of(*profile);
    content.name = std::string(5000, 'W');
    content.maker = "\xe2\x80\xae"
                    "evil\x1b[31m\n\n\t maker \xf0\x9f\x92\xa1 " +
                    std::string(300, 'm');
    content.catalogue_number = "\xd8\xb3\xd9\x84\xd8\xa7\xd9\x85 <script> & \"";
    content.report = std::string(3000, ' ') + "x" + std::string(3000, '-');
    content.cct = "caf\xe9 \xb2"; // Windows-1252
    for (const PaperSize paper : {PaperSize::a4, PaperSize::letter}) {
        const DataSheet sheet = data_sheet(content, {paper, {}, {}});
        expect_fine(sheet.pages, "hostile");
        EXPECT_TRUE(shows(sheet, "…"));
        EXPECT_TRUE(shows(sheet, "café ²"));
        EXPECT_TRUE(shows(sheet, "\uFFFDevil\uFFFD[31m maker \uFFFD mmm"));
        EXPECT_EQ(sheet.replaced, 3U * (3U + 4U)); // in the heads of both pages, and in the list
        for (const Drawing& page : sheet.pages) {
            const std::string svg = to_svg(page);
            EXPECT_EQ(svg.find("<script"), std::string::npos);
            EXPECT_EQ(svg.find('\x1b'), std::string::npos);
            EXPECT_EQ(svg.find("\xe2\x80\xae"), std::string::npos);
        }
    }
}

TEST(DataSheet, EqualContentGivesEqualPages) {
    const std::optional<Loaded> profile = loaded(profiles + "/street.ldt");
    ASSERT_TRUE(profile);
    const DataSheetContent content = content_of(*profile);
    const DataSheet once = data_sheet(content);
    const DataSheet again = data_sheet(content);
    ASSERT_EQ(once.pages.size(), again.pages.size());
    for (std::size_t i = 0; i < once.pages.size(); ++i)
        EXPECT_EQ(to_svg(once.pages[i]), to_svg(again.pages[i]));
}

TEST(RoomSheet, ItFitsWithManyLuminairesAndLongTexts) {
    RoomSheetContent content;
    content.title = "Room of " + std::string(400, 'W');
    content.source = "room.json";
    for (int i = 0; i < 12; ++i)
        content.facts.emplace_back(i == 5 ? std::string(90, 'n') : "Fact",
                                   std::string(static_cast<std::size_t>(20 * i), 'v'));
    for (const char* view : {"Towards +X", "Towards -X", "Towards +Y", "Towards -Y"})
        content.glare.emplace_back(view, "19.4");
    content.task = "office.writing, EN 12464-1:2021";
    content.verdicts.push_back({"mean_lx", "mean illuminance", "lx", 500.0, false, 730.2});
    content.verdicts.push_back({"uniformity", "uniformity U0", "", 0.6, false, 0.5});
    content.verdicts.push_back({"ra", "colour rendering Ra", "", 80.0, false, {}});
    for (int i = 0; i < 40; ++i)
        content.luminaires.push_back({"A", std::string(200, 'l'), 3, 32.0, 4000.0, "at 2.8 m"});
    content.plot.width_m = 5.0;
    content.plot.height_m = 3.0;
    content.plot.columns = 5;
    content.plot.rows = 3;
    content.plot.values.assign(15, 400.0);
    content.plot.values[7] = 800.0;
    content.plot.margin_m = 0.5;
    content.plot.marks = {{2.5, 1.5}};
    for (const PaperSize paper : {PaperSize::a4, PaperSize::letter}) {
        const Result<RoomSheet> sheet = room_sheet(content, paper);
        ASSERT_TRUE(sheet);
        expect_fine(sheet->pages, "room");
    }
}

} // namespace
} // namespace gonio
