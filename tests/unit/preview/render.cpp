#include <gonio/light/light_color.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/reference_picture.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/probe.hpp>

#include "../light/lights.hpp"
#include "../web/webs.hpp"
#include "numbers.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gonio {
namespace {

Stage matte_floor(double albedo) {
    Stage stage;
    stage.surfaces.push_back({"floor", Plane{}, LambertMaterial{glm::dvec3(albedo)}});
    stage.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40.0};
    return stage;
}

Image picture_of(const Stage& stage, const Light& light, const RenderOptions& options) {
    return render(stage, {&light, 1}, stage.camera, options).value().luminance_nt;
}

// A Lambertian floor under a light has the luminance albedo/π · E: compared with the closed form at each pixel's point.
TEST(ThreadsPreview, AMatteFloorShowsTheIlluminance) {
    const Stage stage = matte_floor(0.4);
    RenderOptions options;
    options.width = 33;
    options.height = 21;
    const CameraRays rays(stage.camera, options.width, options.height);
    for (const char* shape : {"point", "sphere:r=20cm"}) {
        // The spherical light is behind the camera; otherwise it would be visible.
        const Light light = light_of(shape, "1000cd", {0.3, -0.2, 6.0});
        const Image image = picture_of(stage, light, options);
        for (int y = 0; y < options.height; ++y)
            for (int x = 0; x < options.width; ++x) {
                const glm::dvec3 point = first_hit(stage, rays.ray(x + 0.5, y + 0.5))->position;
                const glm::dvec3 to_light = glm::dvec3(0.3, -0.2, 6.0) - point;
                const double d = glm::length(to_light);
                const double lux = 1000.0 * to_light.z / (d * d * d);
                EXPECT_NEAR(image.at(x, y)[1], 0.4 / std::numbers::pi * lux, 1e-5 * lux) << shape;
            }
    }
}

// The picture and a probe agree: packed float against double, for every shape.
TEST(ThreadsPreview, PicturesShowWhatProbesSay) {
    const Stage stage = matte_floor(0.4);
    RenderOptions options;
    options.width = 24;
    options.height = 16;
    const CameraRays rays(stage.camera, options.width, options.height);
    for (const char* shape : {"spot:outer=40deg,inner=10deg", "frustum:h=50deg,v=30deg", "sphere:r=50cm", "disk:r=80cm",
                              "ellipse:w=2m,h=40cm", "rect:w=2m,h=30cm", "tube:r=10cm,l=2m", "cylinder:r=10cm,l=2m"}) {
        const Light light = light_of(shape, "1000cd", {0.3, -0.2, 6.0});
        const Image image = picture_of(stage, light, options);
        std::vector<Receiver> receivers;
        for (int y = 0; y < options.height; ++y)
            for (int x = 0; x < options.width; ++x)
                receivers.push_back({first_hit(stage, rays.ray(x + 0.5, y + 0.5))->position, {0, 0, 1}});
        const ProbeResult truth = probe(std::span(&light, 1), receivers, {}).value();
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            const double nits = 0.4 / std::numbers::pi * truth.illuminance_lx[i];
            // For the frustum, which is all or nothing, the lobe's edge is within rounding of a pixel.
            EXPECT_NEAR(image.pixels[3 * i + 1], nits, 2e-5 * nits + 1e-6) << shape << " at " << i;
        }
    }
}

TEST(ThreadsPreview, ColoursKeepTheLuminance) {
    const Stage stage = matte_floor(0.5);
    Light light = light_of("point", "1000cd", {0, 0, 4});
    RenderOptions options;
    options.width = 9;
    options.height = 9;
    options.shadows = Shadows::off;
    const Image white = picture_of(stage, light, options);
    light.color = parse_light_color("#ffb060").value();
    const Image warm = picture_of(stage, light, options);
    const auto y = [](const float* rgb) { return glm::dot(glm::dvec3(rgb[0], rgb[1], rgb[2]), rec709_luminance); };
    EXPECT_NEAR(y(warm.at(4, 4)), y(white.at(4, 4)), 1e-6 * y(white.at(4, 4)));
    EXPECT_GT(warm.at(4, 4)[0], warm.at(4, 4)[2]);
}

Light measured_light() {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape =
        ProfileShape{"test.ies", std::make_shared<const Web>(test::random_web(Symmetry::none, test::steps(0, 360, 25),
                                                                              test::steps(0, 90, 19), 11))};
    description.position = {0, 0, 2.6};
    return resolve_light(description, diagnostics).value();
}

TEST(ThreadsPreview, ThreadsChangeNothing) {
    const Stage stage = make_stage("floor").value();
    for (const Light& light : {measured_light(), light_of("sphere:r=10cm", "800lm", {0, 0, 2.2})}) {
        RenderOptions options;
        options.width = 150;
        options.height = 100;
        options.threads = 1;
        const Image one = picture_of(stage, light, options);
        options.threads = 7;
        EXPECT_EQ(picture_of(stage, light, options).pixels, one.pixels);
    }
}

TEST(ThreadsPreview, InstructionSetsAgree) {
    const Stage stage = make_stage("floor").value();
    for (const Light& light : {measured_light(), light_of("sphere:r=10cm", "800lm", {0, 0, 2.2})}) {
        RenderOptions options;
        options.width = 96;
        options.height = 96;
        options.instruction_set = simd::InstructionSet::scalar;
        const Image scalar = picture_of(stage, light, options);
        const float top = *std::max_element(scalar.pixels.begin(), scalar.pixels.end());
        for (const simd::InstructionSet set : simd::available_sets()) {
            options.instruction_set = set;
            const Image other = picture_of(stage, light, options);
            for (std::size_t i = 0; i < other.pixels.size(); ++i)
                ASSERT_NEAR(other.pixels[i], scalar.pixels[i], 1e-4F * top) << simd::to_text(set);
        }
    }
}

TEST(ThreadsPreview, NothingIsEverNotANumber) {
    const Stage stage = make_stage("floor").value();
    // Inside the sphere, in the floor, behind the wall, at the camera, far away.
    for (const glm::dvec3 position : {glm::dvec3(0.42, -0.28, 0.32), glm::dvec3(0, 0, 0), glm::dvec3(0, 5, 1),
                                      stage.camera.position, glm::dvec3(0, 0, 1e6)}) {
        for (const char* shape : {"point", "sphere:r=0.000001m", "sphere:r=3m"}) {
            RenderOptions options;
            options.width = 40;
            options.height = 40;
            const Image image = picture_of(stage, light_of(shape, "800lm", position), options);
            for (const float value : image.pixels)
                ASSERT_TRUE(std::isfinite(value) && value >= 0.0F) << shape;
        }
    }
}

TEST(Preview, RefusesSizes) {
    const Stage stage = matte_floor(0.5);
    const Light light = light_of("point", "1cd", {0, 0, 1});
    for (const auto& [width, height] : {std::pair{0, 5}, {5, 0}, {-1, 5}, {20000, 5}}) {
        RenderOptions options;
        options.width = width;
        options.height = height;
        EXPECT_FALSE(render(stage, {&light, 1}, stage.camera, options));
    }
}

TEST(Exposure, BringsTheBrightPartToWhite) {
    Image image(10, 10, 3);
    std::fill(image.pixels.begin(), image.pixels.end(), 50.0F);
    const Ev100 ev = auto_exposure(image);
    expose(image, ev);
    EXPECT_NEAR(image.pixels[0], 1.0, 1e-6);
    EXPECT_EQ(auto_exposure(Image(4, 4, 3)).value, 0.0);
    // A lamp that fills a corner of the picture does not count, unless the picture contains nothing else.
    std::vector<std::uint8_t> lamp(100, 0);
    for (std::size_t i = 0; i < 5; ++i) {
        lamp[i] = 1;
        std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, 1000.0F);
    }
    EXPECT_NEAR(auto_exposure(image, lamp).value, std::log2(1.0 / 1.2), 1e-6);
    EXPECT_NEAR(auto_exposure(image).value, std::log2(1000.0 / 1.2), 1e-6);
    EXPECT_EQ(auto_exposure(image, std::vector<std::uint8_t>(100, 1)).value, auto_exposure(image).value);
    EXPECT_NEAR(white_luminance(Ev100(10)).value, 1228.8, 1e-9);
}

// One in 40 where luminances differ much, one in 200 where they are almost the same.
TEST(Exposure, FindsTheQuantilesOfSortedPixels) {
    measure::Random random(5);
    for (const double decades : {0.05, 6.0})
        for (const std::size_t of_subject : {0U, 700U, 9000U}) {
            Image image(100, 100, 3);
            std::vector<std::uint8_t> subject(10'000, 0);
            std::vector<std::pair<double, double>> sorted; // luminances and weights
            for (std::size_t i = 0; i < 10'000; ++i) {
                const auto grey = static_cast<float>(std::pow(10.0, decades * random.uniform(-1.0, 1.0)));
                std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, grey);
                subject[i] = i < of_subject ? 1 : 0;
                const bool is_small = of_subject == 700;
                const auto rest = static_cast<double>(10'000 - of_subject);
                sorted.emplace_back(grey, !is_small ? 1.0 : 5000.0 / (i < of_subject ? 700.0 : rest));
            }
            std::sort(sorted.begin(), sorted.end());
            double left = decades > 1.0 ? 9999.0 * 39.0 / 40.0 : 9999.0 * 199.0 / 200.0;
            std::size_t k = 0;
            for (; k + 1 < sorted.size() && sorted[k].second <= left; ++k)
                left -= sorted[k].second;
            EXPECT_NEAR(white_luminance(auto_exposure(image, {}, subject)).value / sorted[k].first, 1.0, 1e-6)
                << decades << ' ' << of_subject;
        }
}

// Several pieces, of which the last is not whole.
TEST(Exposure, IsTheSameAtAnyNumberOfThreads) {
    measure::Random random(6);
    Image image(500, 407, 3);
    std::vector<std::uint8_t> subject(image.pixels.size() / 3);
    for (const double decades : {0.05, 6.0}) {
        for (float& value : image.pixels)
            value = static_cast<float>(std::pow(10.0, decades * random.uniform(-1.0, 1.0)));
        for (std::uint8_t& is_subject : subject)
            is_subject = random.uniform(0.0, 1.0) < 0.1 ? 1 : 0;
        const double alone = auto_exposure(image, {}, subject).value;
        for (const unsigned threads : {0U, 2U, 5U})
            EXPECT_EQ(auto_exposure(image, {}, subject, threads).value, alone) << threads;
    }
}

TEST(Exposure, KnowsWhetherAnyChannelIsAsHigh) {
    Image image(7, 3, 3);
    EXPECT_FALSE(reaches(image, Nits(1e20)));
    EXPECT_TRUE(reaches(image, Nits(0.0)));
    image.pixels[1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(reaches(image, Nits(1e20)));
    image.pixels[62] = 1e20F;
    EXPECT_TRUE(reaches(image, Nits(1e20)));
}

// A hundred pixels of a subject in a thousand count as much as all others.
TEST(Exposure, GivesTheSubjectHalfOfTheWeight) {
    Image image(1000, 1, 3);
    std::fill(image.pixels.begin(), image.pixels.end(), 1.0F);
    std::vector<std::uint8_t> subject(1000, 0);
    for (std::size_t i = 0; i < 100; ++i) {
        subject[i] = 1;
        std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, 0.25F);
    }
    // 40 pixels around it, a hot spot: 4 % of the pixels and 2.2 % of the weight.
    for (std::size_t i = 960; i < 1000; ++i)
        std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, 20.0F);
    const auto white = [&] { return white_luminance(auto_exposure(image, {}, subject)).value; };
    const double mean = std::sqrt(0.25 * std::pow(20.0, 40.0 / 900.0));
    EXPECT_NEAR(white(), mean / 0.18, 1e-6);
    EXPECT_NEAR(white_luminance(auto_exposure(image)).value, 20.0, 1e-6); // by pixels, the hot spot decides
    // More than half of the pixels: each counts as one.
    std::fill(subject.begin(), subject.begin() + 600, 1);
    EXPECT_EQ(white(), white_luminance(auto_exposure(image)).value);
    std::fill(subject.begin(), subject.end(), 1);
    EXPECT_EQ(white(), white_luminance(auto_exposure(image)).value);
}

// The definition, by sorting.
double white_by_sorting(const Image& image, const std::vector<std::uint8_t>& subject) {
    std::vector<std::pair<double, bool>> pixels;
    for (std::size_t i = 0; i < subject.size(); ++i)
        pixels.emplace_back(static_cast<double>(image.pixels[3 * i]), subject[i] != 0);
    std::sort(pixels.begin(), pixels.end());
    const auto all = static_cast<double>(pixels.size());
    const auto of_subject = static_cast<double>(std::count(subject.begin(), subject.end(), 1));
    const bool is_small = of_subject > 0.0 && of_subject < 0.5 * all;
    const auto weight = [&](bool is_subject) {
        return !is_small ? 1.0 : is_subject ? 0.5 * all / of_subject : 0.5 * all / (all - of_subject);
    };
    double logarithms = 0.0;
    for (const auto& [luminance, is_subject] : pixels)
        logarithms += weight(is_subject) * std::log(luminance);
    const auto below_one_in = [&](double share) {
        double sum = 0.0;
        for (const auto& [luminance, is_subject] : pixels)
            if ((sum += weight(is_subject)) > (all - 1.0) * (share - 1.0) / share) return luminance;
        return pixels.back().first;
    };
    return std::clamp(std::exp(logarithms / all) / 0.18, below_one_in(40.0), below_one_in(200.0));
}

TEST(Exposure, IsThatOfSortedPixels) {
    test::Numbers numbers(12);
    for (int i = 0; i < 300; ++i) {
        const auto count = static_cast<std::size_t>(numbers.between(1.0, 2000.0));
        const double spread = numbers.between(0.1, 60.0);
        const double share = numbers.between(-0.2, 1.2);
        Image image(static_cast<int>(count), 1, 3);
        std::vector<std::uint8_t> subject(count);
        for (std::size_t j = 0; j < count; ++j) {
            const auto value = static_cast<float>(std::exp(numbers.between(-spread, spread)));
            std::fill_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * j), 3, value);
            subject[j] = numbers.between(0.0, 1.0) < share ? 1 : 0;
        }
        const double white = white_by_sorting(image, subject);
        EXPECT_NEAR(white_luminance(auto_exposure(image, {}, subject)).value, white, 1e-6 * white) << count;
    }
}

// Which pixels show the subject does not depend on the method.
TEST(Exposure, SubjectIsTheSameForTheReference) {
    const Stage stage = make_stage("room").value();
    const Light light = light_of("point", "100cd", {0, 0.3, 2});
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    options.bounces = 0;
    const Rendering rendering = render(stage, {&light, 1}, stage.camera, options).value();
    ReferencePicture reference = ReferencePicture::begin(stage, {&light, 1}, stage.camera, options).value();
    reference.add_pass();
    EXPECT_EQ(rendering.shows_subject, reference.picture().shows_subject);
    const auto count = std::count(rendering.shows_subject.begin(), rendering.shows_subject.end(), 1);
    EXPECT_GT(count, 60); // a box and a sphere
    EXPECT_LT(count, 300);
}

// Of a wide picture of few pixels, the corner of a tile is more than a right angle from its middle.
TEST(Preview, WideTilesSeeWhatTheirRaysMeet) {
    Stage stage = make_stage("floor").value();
    stage.camera.position = {0.0, -2.0, 0.6};
    stage.camera.target = {-4.0, -0.5, 0.6};
    stage.camera.vertical_fov_deg = 172.0;
    const Light light = light_of("point", "8000lm", {0.0, 0.0, 3.0});
    RenderOptions options;
    options.width = 40;
    options.height = 40;
    const Rendering picture = render(stage, {&light, 1}, stage.camera, options).value();
    const CameraRays rays(stage.camera, options.width, options.height);
    std::size_t subjects = 0;
    for (int j = 0; j < options.height; ++j)
        for (int i = 0; i < options.width; ++i) {
            const std::optional<Hit> hit = first_hit(stage, rays.ray(i + 0.5, j + 0.5));
            const bool is_subject = hit && stage.surfaces[hit->surface].subject;
            subjects += is_subject ? 1 : 0;
            EXPECT_EQ(picture.shows_subject[static_cast<std::size_t>(j * options.width + i)] != 0, is_subject)
                << i << ", " << j;
        }
    EXPECT_GT(subjects, 20U);
}

// Middle grey in the geometric mean, unless too many or too few pixels are white then.
TEST(Exposure, WeighsTheWholePicture) {
    const auto white = [](std::initializer_list<std::pair<std::size_t, float>> parts) {
        Image image(1000, 1, 3);
        std::size_t at = 0;
        for (const auto& [count, value] : parts)
            for (std::size_t i = 0; i < 3 * count; ++i)
                image.pixels[at++] = value;
        return white_luminance(auto_exposure(image)).value;
    };
    const double mean = std::pow(50.0, 0.008) * std::pow(1000.0, 0.002);
    EXPECT_NEAR(white({{990, 1.0F}, {8, 50.0F}, {2, 1000.0F}}), mean / 0.18, 1e-6);
    EXPECT_NEAR(white({{900, 1.0F}, {100, 10.0F}}), 10.0, 1e-6); // no more than 25 may be white
    EXPECT_NEAR(white({{500, 1.0F}, {500, 0.9F}}), 1.0, 1e-6);   // 5 should be
    EXPECT_NEAR(white({{500, 1e-3F}, {500, 1.0F}}), 1.0, 1e-6);  // dark surroundings
}

// Light adds up: a picture of two lights is the sum of their single pictures, in luminance and in lux.
TEST(ThreadsPreview, LightsAddUp) {
    const Stage stage = make_stage("floor").value();
    const std::array lights{light_of("point", "800lm", {0.3, -0.2, 2.0}),
                            light_of("rect:w=60cm,h=30cm", "500lm", {-0.4, -3.0, 2.4})}; // above the camera's view
    RenderOptions options;
    options.width = 48;
    options.height = 32;
    options.illuminance = true;
    const Rendering both = render(stage, lights, stage.camera, options).value();
    const Rendering first = render(stage, {lights.data(), 1}, stage.camera, options).value();
    const Rendering second = render(stage, {lights.data() + 1, 1}, stage.camera, options).value();
    float largest = 0.0F;
    for (std::size_t i = 0; i < both.luminance_nt.pixels.size(); ++i) {
        const float sum = first.luminance_nt.pixels[i] + second.luminance_nt.pixels[i];
        largest = std::max(largest, sum);
        EXPECT_NEAR(both.luminance_nt.pixels[i], sum, 4e-6F * sum);
    }
    EXPECT_GT(largest, 1.0F);
    for (std::size_t i = 0; i < both.illuminance_lx.pixels.size(); ++i) {
        const float sum = first.illuminance_lx.pixels[i] + second.illuminance_lx.pixels[i];
        EXPECT_NEAR(both.illuminance_lx.pixels[i], sum, 4e-6F * sum);
    }
}

// On a matte surface, luminance is albedo/π times the illuminance reported with it.
TEST(ThreadsPreview, IlluminanceIsWhatAMatteSurfaceReceives) {
    const Stage stage = matte_floor(0.4);
    RenderOptions options;
    options.width = 24;
    options.height = 16;
    options.illuminance = true;
    for (const char* shape : {"point", "sphere:r=20cm", "disk:r=20cm", "ellipse:w=60cm,h=20cm", "rect:w=60cm,h=30cm",
                              "tube:r=2cm,l=1m", "cylinder:r=2cm,l=1m"}) {
        const Light light = light_of(shape, "800lm", {0.3, -0.2, 6.0});
        const Rendering rendering = render(stage, {&light, 1}, stage.camera, options).value();
        for (std::size_t i = 0; i < rendering.illuminance_lx.pixels.size(); ++i) {
            const double expected = rendering.luminance_nt.pixels[3 * i] * std::numbers::pi / 0.4;
            EXPECT_GT(expected, 0.0);
            EXPECT_NEAR(rendering.illuminance_lx.pixels[i], expected, 2e-6 * expected) << shape;
        }
    }
}

// By every method, a picture's lux equal those of a probe by that method, and its luminance on a matte surface follows.
TEST(ThreadsPreview, EveryMethodShowsWhatItsProbesSay) {
    const Stage stage = matte_floor(0.4);
    RenderOptions options;
    options.width = 8;
    options.height = 6;
    options.illuminance = true;
    const CameraRays rays(stage.camera, options.width, options.height);
    std::vector<Receiver> receivers;
    for (int y = 0; y < options.height; ++y)
        for (int x = 0; x < options.width; ++x)
            receivers.push_back({first_hit(stage, rays.ray(x + 0.5, y + 0.5))->position, {0, 0, 1}});
    for (const char* shape :
         {"point", "spot:outer=40deg,inner=10deg", "sphere:r=50cm", "disk:r=80cm", "disk:r=80cm,two-sided",
          "ellipse:w=2m,h=40cm", "rect:w=2m,h=30cm", "tube:r=10cm,l=2m", "cylinder:r=10cm,l=2m", "sun:angle=3deg"})
        for (const IrradianceMethodName& name : irradiance_methods()) {
            const bool is_sun = std::string_view(shape).starts_with("sun");
            const Light light = light_of(shape, is_sun ? "1000lx" : "1000cd", {0.3, -0.2, 6.0});
            options.method = name.method;
            const Rendering rendering = render(stage, {&light, 1}, stage.camera, options).value();
            ProbeOptions asked;
            asked.method = name.method;
            const ProbeResult truth = probe(std::span(&light, 1), receivers, asked).value();
            for (std::size_t i = 0; i < receivers.size(); ++i) {
                const double lx = truth.illuminance_lx[i];
                EXPECT_NEAR(rendering.illuminance_lx.pixels[i], lx, 3e-5 * lx + 1e-4) << shape << ' ' << name.name;
                const double nt = 0.4 / std::numbers::pi * lx;
                EXPECT_NEAR(rendering.luminance_nt.pixels[3 * i + 1], nt, 3e-5 * nt + 1e-4)
                    << shape << ' ' << name.name;
            }
        }
}

// With a method that has an irradiance formula of its own, a material has the result of the exact method plus the
// change of its diffuse part, which for these materials is Lambert's with the same albedo.
TEST(ThreadsPreview, OwnIrradianceReachesTheDiffusePartAlone) {
    Stage stage = matte_floor(0.4);
    RenderOptions options;
    options.width = 8;
    options.height = 6;
    options.method = IrradianceMethod::frostbite;
    const Light light = light_of("disk:r=80cm", "1000cd", {0.3, -0.2, 2.0});
    const auto diffuse_of = [&](const char* material) {
        stage.surfaces[0].material = parse_material(material).value();
        options.specular = false;
        return picture_of(stage, light, options);
    };
    const Image lambert = diffuse_of("lambert:albedo=0.3");
    const Image cavity = diffuse_of("ue4:base=0.6,cavity=0.5");
    ASSERT_EQ(lambert.pixels, cavity.pixels);
    options.specular = true;
    stage.surfaces[0].material = parse_material("ue4:base=0.6,cavity=0.5").value();
    const Image whole = picture_of(stage, light, options);
    stage.surfaces[0].material = parse_material("ue4:base=0,cavity=0.5").value();
    const Image black = picture_of(stage, light, options);
    for (std::size_t i = 0; i < whole.pixels.size(); ++i)
        EXPECT_NEAR(whole.pixels[i] - black.pixels[i], lambert.pixels[i], 2e-6F * whole.pixels[i]) << i;
}

// The luminance of glossy, coloured materials: the reference against a probe's, channel by channel through Y; ltc
// within the error of its fit.
TEST(ThreadsPreview, GlossShowsWhatProbesSay) {
    Stage stage = matte_floor(0.4);
    RenderOptions options;
    options.width = 4;
    options.height = 3;
    const CameraRays rays(stage.camera, options.width, options.height);
    for (const char* material : {"frostbite:base=rgb(0.5,0.2,0.1),smoothness=0.6", "ue4:base=rgb(0.2,0.5,0.9)",
                                 "gltf:base=rgb(0.9,0.5,0.2)", "eon"})
        for (const char* shape : {"point", "sphere:r=50cm", "rect:w=2m,h=30cm", "sun:angle=3deg"}) {
            const bool is_sun = std::string_view(shape).starts_with("sun");
            Light light = light_of(shape, is_sun ? "1000lx" : "1000cd", {0.3, -0.2, 6.0});
            light.color = parse_light_color("#ffb060").value();
            stage.surfaces[0].material = parse_material(material).value();
            for (const IrradianceMethod method : {IrradianceMethod::reference, IrradianceMethod::exact}) {
                const bool reference = method == IrradianceMethod::reference;
                options.method = method;
                const Image image = picture_of(stage, light, options);
                for (int y = 0; y < options.height; ++y)
                    for (int x = 0; x < options.width; ++x) {
                        const glm::dvec3 at = first_hit(stage, rays.ray(x + 0.5, y + 0.5))->position;
                        ProbeOptions asked;
                        asked.method = IrradianceMethod::reference;
                        asked.view = ProbeView{{}, stage.surfaces[0].material, stage.camera.position};
                        const std::array receiver{Receiver{at, {0, 0, 1}}};
                        const double truth =
                            probe(std::span(&light, 1), receiver, asked).value().luminance[0].total().value;
                        const float* rgb = image.at(x, y);
                        const double shown = glm::dot(glm::dvec3(rgb[0], rgb[1], rgb[2]), rec709_luminance);
                        EXPECT_NEAR(shown, truth, (reference ? 2e-5 : 0.03) * truth) << shape << ' ' << material;
                    }
            }
        }
}

// What a picture knows from another one must not show: not of the materials as they were, nor of lobes that are now
// left out, nor from another camera.
TEST(Preview, KnowledgeOfAnotherPictureDoesNotChangeIt) {
    Stage stage = make_stage("room").value();
    const std::vector<Light> lights{light_of("sphere:r=15cm", "900lm", {0.0, -0.6, 1.5})};
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    options.bounces = all_bounces;
    std::shared_ptr<const Interreflection> known = render(stage, lights, stage.camera, options).value().indirect;
    const auto expect_same = [&](const char* what) {
        options.known = nullptr;
        const Rendering afresh = render(stage, lights, stage.camera, options).value();
        options.known = known;
        const Rendering found = render(stage, lights, stage.camera, options).value();
        EXPECT_EQ(found.luminance_nt.pixels, afresh.luminance_nt.pixels) << what;
        known = found.indirect;
    };
    expect_same("nothing changed");
    stage.camera.position.x += 0.4;
    expect_same("camera");
    stage.surfaces.back().material = parse_material("ue4:base=0.9,metallic=1,roughness=0.3").value();
    expect_same("material");
    options.specular = false;
    expect_same("specular");
    options.specular = true;
    options.sky = resolve_sky(parse_sky_description("300lx").value()).value();
    expect_same("sky");
    options.sky = Sky();
    expect_same("no sky");
}

} // namespace
} // namespace gonio
