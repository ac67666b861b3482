// The error of the preview's pictures: every stage × light × material, `exact` against the same picture by `reference`.
// In Markdown, for MEASURED.md of preview/.
//
//   gonio-preview-accuracy [WIDTH]
//
// Each error is the mean of |value − truth| over the mean of the truth, over the pixels that show a surface. The
// diffuse materials have no highlight at all; the others have only a highlight. Without an argument pictures are 16
// pixels wide; takes some minutes.
#include <gonio/preview/render.hpp>
#include <gonio/scene/stage.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace {

using namespace gonio;

struct Deviation {
    double difference = 0.0;
    double truth = 0.0;

    void add(const Deviation& other) {
        difference += other.difference;
        truth += other.truth;
    }
    double percent() const { return truth > 0.0 ? 100.0 * difference / truth : 0.0; }
};

Light light_on(const Stage& stage, const char* shape, const char* intensity) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = parse_shape(shape).value();
    description.intensity = parse_photometric_value(intensity).value();
    hang(description, stage.light);
    return resolve_light(std::move(description), diagnostics).value();
}

Deviation error_of(Stage stage, const Light& light, const char* material, RenderOptions options) {
    for (Surface& surface : stage.surfaces)
        surface.material = parse_material(material).value();
    options.illuminance = true;
    const Rendering picture = render(stage, {&light, 1}, stage.camera, options).value();
    options.method = IrradianceMethod::reference;
    const Rendering truth = render(stage, {&light, 1}, stage.camera, options).value();
    Deviation error;
    for (std::size_t i = 0; i < truth.illuminance_lx.pixels.size(); ++i) {
        if (!(truth.illuminance_lx.pixels[i] > 0.0F)) continue; // the light itself, or background
        const double expected = truth.luminance_nt.pixels[3 * i];
        error.add({std::abs(picture.luminance_nt.pixels[3 * i] - expected), expected});
    }
    return error;
}

} // namespace

int main(int argc, char** argv) {
    constexpr std::array lights{std::pair{"sphere:r=10cm", "800lm"},      std::pair{"disk:r=20cm", "800lm"},
                                std::pair{"rect:w=60cm,h=30cm", "800lm"}, std::pair{"tube:r=1.3cm,l=1.2m", "800lm"},
                                std::pair{"sun:angle=0.53deg", "10klx"},  std::pair{"point", "800lm"}};
    constexpr std::array diffuse{"lambert", "eon", "frostbite:reflectance=0,smoothness=0.6"};
    constexpr std::array glossy{"ggx:alpha=0.1", "ggx:alpha=0.3", "ggx:alpha=0.7"};
    RenderOptions options;
    options.width = argc > 1 ? std::atoi(argv[1]) : 16;
    options.height = options.width * 3 / 4;
    options.goal.relative_error = 1e-5;

    (void)std::printf("| stage | light |");
    for (const char* material : diffuse)
        (void)std::printf(" %s |", material);
    for (const char* material : glossy)
        (void)std::printf(" %s |", material);
    (void)std::printf("\n|---|---|---|---|---|---|---|---|\n");
    Deviation all_diffuse;
    Deviation all_glossy;
    for (const StageKind& kind : stage_kinds()) {
        const Stage stage = make_stage(kind.name).value();
        for (const auto& [shape, intensity] : lights) {
            const Light light = light_on(stage, shape, intensity);
            (void)std::printf("| %s | %s |", stage.name.c_str(), shape);
            for (const char* material : diffuse) {
                const Deviation error = error_of(stage, light, material, options);
                if (error.truth > 0.0) all_diffuse.add({error.difference / error.truth, 1.0});
                (void)std::printf(" %.4f %% |", error.percent());
            }
            for (const char* material : glossy) {
                const Deviation error = error_of(stage, light, material, options);
                if (error.truth > 0.0) all_glossy.add({error.difference / error.truth, 1.0});
                (void)std::printf(" %.2f %% |", error.percent());
            }
            (void)std::printf("\n");
            (void)std::fflush(stdout);
        }
    }
    (void)std::printf("\nMean of all: diffuse %.4f %%, glossy %.2f %%\n", all_diffuse.percent(), all_glossy.percent());
    return 0;
}
