#include <gonio/light/photometric_value.hpp>
#include <gonio/preview/glare.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gonio {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Camera camera_of(double vertical_fov_deg) {
    Camera camera;
    camera.position = {0.0, -5.0, 1.0};
    camera.target = {0.0, 0.0, 1.0};
    camera.vertical_fov_deg = vertical_fov_deg;
    return camera;
}

// The equation as published, written out.
double published(double t, double age, double p) {
    const double a = std::pow(age / 70.0, 4.0);
    return (1.0 - 0.08 * a) * (9.2e6 / std::pow(1.0 + std::pow(t / 0.0046, 2.0), 1.5) +
                               1.5e5 / std::pow(1.0 + std::pow(t / 0.045, 2.0), 1.5)) +
           (1.0 + 1.6 * a) * (400.0 / (1.0 + std::pow(t / 0.1, 2.0)) + 3e-8 * t * t +
                              p * (1300.0 / std::pow(1.0 + std::pow(t / 0.1, 2.0), 1.5) +
                                   0.8 / std::sqrt(1.0 + std::pow(t / 0.1, 2.0)))) +
           2.5e-3 * p;
}

// The CIE's general disability glare equation, for 0.1° to 100°.
double general(double t, double age, double p) {
    return 10.0 / (t * t * t) + (5.0 / (t * t) + 0.1 * p / t) * (1.0 + std::pow(age / 62.5, 4.0)) + 0.0025 * p;
}

// In cd/m²: a picture of one colour with some pixels of another.
Image lit_picture(int width, int height, float everywhere) {
    Image image(width, height, 3);
    std::fill(image.pixels.begin(), image.pixels.end(), everywhere);
    return image;
}

void set(Image& image, int column, int row, float value) {
    std::fill_n(image.at(column, row), 3, value);
}

glm::dvec3 direction(const Camera& camera, const Image& image, double x, double y) {
    return CameraRays(camera, image.width, image.height).ray(x, y).direction;
}

TEST(Glare, FunctionIsThePublishedOneOverItsIntegral) {
    for (const double age : {20.0, 25.0, 60.0, 83.0})
        for (const double pigment : {0.0, 0.5, 1.2}) {
            const GlareFunction glare({age, pigment});
            for (const double angle_deg : {0.0, 0.002, 0.03, 0.1, 1.0, 7.0, 30.0, 90.0}) {
                const double expected = published(angle_deg, age, pigment) / glare.published_integral();
                EXPECT_NEAR(glare.per_sr(angle_deg * degree), expected, 1e-12 * expected);
            }
        }
    // The rounding of the published constants.
    EXPECT_NEAR(GlareFunction({25.0, 0.0}).published_integral(), 1.0, 0.01);
    EXPECT_NEAR(GlareFunction({25.0, 0.5}).published_integral(), 1.0, 0.05);
}

// The CIE's simpler equation is a fit to the same data. It puts less of the light through green eyes.
TEST(Glare, AgreesWithTheGeneralDisabilityGlareEquation) {
    for (const double age : {25.0, 50.0, 75.0})
        for (const double pigment : {0.0, 0.5, 1.0})
            for (double angle_deg = 0.3; angle_deg < 60.0; angle_deg *= 1.3) {
                const double ratio = published(angle_deg, age, pigment) / general(angle_deg, age, pigment);
                EXPECT_GT(ratio, 0.7) << age << ' ' << pigment << ' ' << angle_deg;
                EXPECT_LT(ratio, 1.45) << age << ' ' << pigment << ' ' << angle_deg;
            }
}

// ∫ f 2πθ dθ by the midpoint rule in log θ.
TEST(Glare, ShareWithinAnAngleIsTheIntegral) {
    const GlareFunction glare({70.0, 1.0});
    for (const double end_deg : {0.001, 0.0046, 0.05, 0.3, 2.0}) {
        constexpr int steps = 20000;
        const double from = std::log(1e-7);
        const double step = (std::log(end_deg) - from) / steps;
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double angle = std::exp(from + (i + 0.5) * step) * degree;
            sum += glare.per_sr(angle) * 2.0 * std::numbers::pi * angle * angle * step;
        }
        EXPECT_NEAR(glare.share_within(end_deg * degree), sum, 1e-6 * sum) << end_deg;
    }
}

// ∫ f(θ) cosθ dω over a pixel, by its values at so many points along each side.
double received_from(const Camera& camera, const Image& image, int column, int row, const glm::dvec3& to, int parts) {
    const auto at = [&](double x, double y) { return direction(camera, image, column + x, row + y); };
    const double solid_angle = glm::length(glm::cross(at(1.0, 0.5) - at(0.0, 0.5), at(0.5, 1.0) - at(0.5, 0.0)));
    const GlareFunction glare;
    double sum = 0.0;
    for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
            const glm::dvec3 from = at((i + 0.5) / parts, (j + 0.5) / parts);
            sum += glare.per_sr(2.0 * std::asin(0.5 * glm::distance(from, to))) * glm::dot(from, to);
        }
    return solid_angle * sum / (parts * parts);
}

// One bright pixel: away from it, the veil is the function at the angle times the illuminance at the eye.
TEST(Glare, OnePixelGivesTheFunctionAtItsAngles) {
    const Camera camera = camera_of(50.0);
    constexpr float white = 1.0F;
    constexpr float bright = 100001.0F;
    for (const auto& [column, row] : {std::pair{31, 22}, std::pair{2, 3}}) {
        Image image = lit_picture(64, 48, 0.0F);
        set(image, column, row, bright);
        add_glare(image, {}, camera);
        const double excess = static_cast<double>(bright) - static_cast<double>(white);
        int compared = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                if (std::hypot(x - column, y - row) < 4.0) continue;
                const double expected =
                    excess * received_from(camera, image, column, row, direction(camera, image, x + 0.5, y + 0.5), 8);
                EXPECT_NEAR(static_cast<double>(*image.at(x, y)), expected, 2e-3 * expected) << x << ' ' << y;
                ++compared;
            }
        EXPECT_GT(compared, 2000);
    }
}

// What the source loses is what the others receive, in the illuminance at the eye, but for what leaves the picture: a
// picture of nearly half the space holds almost everything.
TEST(Glare, KeepsTheLight) {
    const Camera camera = camera_of(150.0);
    Image image = lit_picture(301, 301, 0.0F);
    constexpr int middle = 150;
    set(image, middle, middle, 1e6F);
    add_glare(image, {}, camera);
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::dvec3 across = direction(camera, image, x + 1.0, y + 0.5) - direction(camera, image, x, y + 0.5);
            const glm::dvec3 down = direction(camera, image, x + 0.5, y + 1.0) - direction(camera, image, x + 0.5, y);
            sum += static_cast<double>(*image.at(x, y)) * glm::length(glm::cross(across, down));
        }
    const double angle = 150.0 * degree / 2.0; // the nearest side
    const double width = 2.0 * std::tan(angle) / 301.0;
    const double before = 1e6 * width * width; // the middle's solid angle
    EXPECT_LT(sum, before * (1.0 + 1e-3));
    EXPECT_GT(sum, before * (1.0 - 3e-3));
    EXPECT_LT(static_cast<double>(*image.at(middle, middle)), 1e6);
}

TEST(Glare, IsSymmetric) {
    Image image = lit_picture(33, 33, 0.2F);
    set(image, 16, 16, 5000.0F);
    add_glare(image, {}, camera_of(30.0));
    for (int y = 0; y < 33; ++y)
        for (int x = 0; x < 33; ++x) {
            EXPECT_NEAR(*image.at(x, y), *image.at(32 - x, y), 1e-5F * *image.at(x, y));
            EXPECT_NEAR(*image.at(x, y), *image.at(y, x), 1e-5F * *image.at(x, y));
        }
}

TEST(Glare, LeavesPicturesUpToWhiteAlone) {
    Image image = lit_picture(40, 30, 1.0F);
    set(image, 3, 4, 0.0F);
    const Image before = image;
    add_glare(image, {}, camera_of(40.0));
    EXPECT_EQ(image.pixels, before.pixels);
}

// Groups against every pixel by itself, where the picture is dark: relative to the veil.
struct GroupError {
    double worst = 0.0;
    double rms = 0.0;
};

GroupError group_error(const Image& picture) {
    Image grouped = picture;
    Image direct = picture;
    const Camera camera = camera_of(46.0);
    add_glare(grouped, {}, camera);
    add_glare(direct, {}, camera, {Eye(), 0, 0.0});
    GroupError result;
    int count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 3) {
        if (picture.pixels[i] > 1.0F) continue; // elsewhere the veil is all that was added
        const double veil = static_cast<double>(direct.pixels[i] - picture.pixels[i]);
        const double error = std::abs(static_cast<double>(grouped.pixels[i] - direct.pixels[i])) / veil;
        result.rms += error * error;
        result.worst = std::max(result.worst, error);
        ++count;
    }
    result.rms = std::sqrt(result.rms / count);
    return result;
}

// A thin tube, along which a group has all of its spread.
TEST(Glare, GroupsOfALineAreNearTheDirectSum) {
    Image image = lit_picture(160, 120, 0.0F);
    for (int x = 20; x < 110; ++x)
        set(image, x, 30 + x / 3, 3000.0F);
    const GroupError error = group_error(image);
    EXPECT_LT(error.worst, 0.005);
    EXPECT_LT(error.rms, 0.001);
    RecordProperty("worst", std::to_string(error.worst));
    RecordProperty("rms", std::to_string(error.rms));
}

// A third of the pixels bright, from 1 to 1e4 times white.
TEST(Glare, GroupsAreNearTheDirectSum) {
    std::mt19937 random(3); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same picture every time
    std::uniform_real_distribution<float> uniform;
    Image image = lit_picture(96, 72, 0.1F);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (uniform(random) < 0.33F || (x > 60 && y > 40))
                set(image, x, y, std::pow(10.0F, 4.0F * uniform(random)));
    const GroupError error = group_error(image);
    EXPECT_LT(error.worst, 0.005);
    EXPECT_LT(error.rms, 0.001);
    RecordProperty("worst", std::to_string(error.worst));
    RecordProperty("rms", std::to_string(error.rms));
}

// Next to a bright pixel the function changes within it: against 200×200 points of it.
TEST(Glare, NeighboursReceiveTheMeanOverThePixel) {
    const Camera camera = camera_of(40.0);
    Image image = lit_picture(512, 512, 0.0F); // 0.08° for a pixel in the middle
    constexpr int at = 255;
    set(image, at, at, 1001.0F);
    add_glare(image, {}, camera);
    const auto received = [&](int x, int y) {
        return 1000.0 * received_from(camera, image, at, at, direction(camera, image, x + 0.5, y + 0.5), 200);
    };
    for (const auto& [x, y] : {std::pair{at + 1, at}, std::pair{at + 1, at + 1}, std::pair{at - 2, at},
                               std::pair{at - 3, at + 2}, std::pair{at, at + 6}})
        EXPECT_NEAR(static_cast<double>(*image.at(x, y)), received(x, y), 0.01 * received(x, y)) << x << ' ' << y;
    // And all of it together with what stays is the light of the pixel.
    double sum = 0.0;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x)
            sum += static_cast<double>(*image.at(x, y));
    EXPECT_NEAR(sum / 1001.0, 1.0, 0.03); // the part beyond 20° is outside
    EXPECT_LT(sum, 1001.0);
}

TEST(Glare, AgeAndLightEyesMakeMoreOfIt) {
    const auto veil = [](Eye eye) {
        Image image = lit_picture(64, 64, 0.0F);
        set(image, 32, 32, 1e5F);
        add_glare(image, {}, camera_of(40.0), {eye});
        return *image.at(50, 32);
    };
    EXPECT_GT(veil({60.0, 0.5}), 1.5F * veil({25.0, 0.5}));
    EXPECT_GT(veil({25.0, 1.2}), 1.1F * veil({25.0, 0.0}));
}

// The parts of a pixel that shows a light in part: the wall beside the lamp receives, the lamp loses, and the pixel is
// their mean.
TEST(Glare, PartsOfAPixelAddUpToIt) {
    Image image = lit_picture(40, 40, 0.25F);
    set(image, 20, 20, 0.75F * 0.25F + 0.25F * 4000.0F);
    set(image, 21, 20, 4000.0F);
    std::vector<PartialLight> lights{{20U * 40U + 20U, 0.25F, {4000.0F, 4000.0F, 4000.0F}}};
    add_glare(image, lights, camera_of(40.0));
    const Image parts = parts_of(image, lights);
    ASSERT_EQ(parts.width, 2);
    EXPECT_GT(parts.pixels[0], 0.25F);
    EXPECT_LT(parts.pixels[0], *image.at(21, 20));
    EXPECT_NEAR(0.75F * parts.pixels[0] + 0.25F * parts.pixels[3], *image.at(20, 20), 1e-3F);
    EXPECT_GT(parts.pixels[3], 1.0F);
}

Light spot_at(const glm::dvec3& position, double candela) {
    LightDescription description;
    description.name = "spot";
    description.shape = PointShape();
    description.intensity = parse_photometric_value(std::to_string(candela) + "cd").value();
    description.position = position;
    description.color = {1.2, 0.99, 0.5};
    Diagnostics diagnostics;
    return resolve_light(std::move(description), diagnostics).value();
}

// A light without size, as the luminance of its pixel, gives I/d² at the eye; behind a wall or the camera, nothing.
TEST(Glare, PointsGiveTheirIlluminanceAtTheEye) {
    const Camera camera = camera_of(40.0);
    Stage stage;
    stage.surfaces = {{"wall", Plane{{0.0, 2.0, 0.0}, {0.0, -1.0, 0.0}}, LambertMaterial{glm::dvec3(0.5)}}};
    const std::vector<Light> lights{spot_at({0.4, 1.0, 1.3}, 250.0), spot_at({0.0, 3.0, 1.0}, 1e5),
                                    spot_at({0.0, -9.0, 1.0}, 1e5), spot_at({30.0, 1.0, 1.0}, 1e5)};
    Image image = lit_picture(64, 48, 0.0F);
    show_points(image, stage, lights, camera);
    glm::dvec3 lux(0.0);
    int lit = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::dvec3 across = direction(camera, image, x + 1.0, y + 0.5) - direction(camera, image, x, y + 0.5);
            const glm::dvec3 down = direction(camera, image, x + 0.5, y + 1.0) - direction(camera, image, x + 0.5, y);
            const double solid_angle = glm::length(glm::cross(across, down));
            for (int c = 0; c < 3; ++c)
                lux[c] += solid_angle * static_cast<double>(image.at(x, y)[c]);
            if (*image.at(x, y) > 0.0F) ++lit;
        }
    EXPECT_EQ(lit, 1);
    const glm::dvec3 expected = 250.0 / (0.16 + 36.0 + 0.09) * glm::dvec3(1.2, 0.99, 0.5);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(lux[c], expected[c], 1e-6 * expected[c]); // the roundings of floats
}

TEST(Glare, AnyNumberOfThreadsGivesTheSameBytes) {
    std::mt19937 random(8); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same picture every time
    std::uniform_real_distribution<float> uniform;
    Image one = lit_picture(90, 70, 0.3F);
    for (float& value : one.pixels)
        if (uniform(random) < 0.05F) value = 300.0F;
    Image many = one;
    add_glare(one, {}, camera_of(60.0), {Eye(), 1});
    add_glare(many, {}, camera_of(60.0), {Eye(), 7});
    EXPECT_EQ(one.pixels, many.pixels);
}

} // namespace
} // namespace gonio
