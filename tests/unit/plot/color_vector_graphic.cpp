#include <gonio/plot/color_vector_graphic.hpp>
#include <gonio/plot/svg.hpp>

#include <gtest/gtest.h>

#include <string>

namespace gonio {
namespace {

LightQuality quality_of(const char* name) {
    return light_quality(read_spectrum(name).value()).value();
}

TEST(ColorVectorGraphicTest, StatesTheFiguresAndEscapesItsTitle) {
    ColorVectorOptions options;
    options.title = "<b> & co";
    const std::string svg = to_svg(color_vector_graphic(quality_of("FL2"), options).value());
    for (const char* const text :
         {"Rf 70", "Rg 86", "CCT 4224 K", "Duv 0.0018", "&lt;b&gt; &amp; co", "reference illuminant"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    EXPECT_EQ(svg.find("<b>"), std::string::npos);
    for (const char* const no_number : {"\"nan", " nan", ",nan", "-nan", "inf "})
        EXPECT_EQ(svg.find(no_number), std::string::npos) << no_number;
    EXPECT_EQ(svg, to_svg(color_vector_graphic(quality_of("FL2"), options).value()));
}

// The means of the bins are inside of the page, for a light with great shifts too.
TEST(ColorVectorGraphicTest, StrongShiftsStayOnThePage) {
    for (const char* const name : {"HP1", "LED-RGB1", "FL11"}) {
        const Drawing page = color_vector_graphic(quality_of(name), {200, 300, {}}).value();
        for (const DrawingStep& step : page.steps())
            if (const auto* const stroke = std::get_if<StrokedPath>(&step))
                for (const PagePath::Part& part : stroke->path.parts())
                    for (const PagePoint point : part.points) {
                        EXPECT_GE(point.x, 0.0) << name;
                        EXPECT_LE(point.x, 200.0) << name;
                        EXPECT_GE(point.y, 0.0) << name;
                        EXPECT_LE(point.y, 300.0) << name;
                    }
    }
}

TEST(ColorVectorGraphicTest, FailsWithoutAReferenceAndOnOddPages) {
    LightQuality none = quality_of("FL2");
    EXPECT_FALSE(color_vector_graphic(none, {100, 100, {}}));
    none.fidelity.reset();
    EXPECT_FALSE(color_vector_graphic(none));
}

} // namespace
} // namespace gonio
