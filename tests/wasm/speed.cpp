// How fast the kernels and the preview are, by instruction set: the same program for the processor and for WebAssembly.
// Prints a line for each case and set: milliseconds of the processor. speed.sh compares the two.
#include <gonio/light/light.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/simd/array_math.hpp>
#include <gonio/transport/shading_constants.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#if defined(__EMSCRIPTEN__)
#include <emscripten/emscripten.h>
#endif

namespace {

using namespace gonio;

// Of this process: other programs on the machine do not count.
double processor_ms() {
#if defined(__EMSCRIPTEN__)
    return EM_ASM_DOUBLE({
        const time = process.cpuUsage();
        return (time.user + time.system) / 1000;
    });
#else
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
#endif
}

// The median of nine measurements of a tenth of a second. What comes first warms up V8, which compiles what is used
// much again, and better, while it runs.
template<class Work>
double median_ms(const Work& work) {
    const auto measure = [&work] {
        int runs = 0;
        const double begin = processor_ms();
        double time = 0.0;
        for (; time < 100.0; time = processor_ms() - begin, ++runs)
            work();
        return time / runs;
    };
    measure();
    measure();
    std::array<double, 9> times{};
    for (double& time : times)
        time = measure();
    std::nth_element(times.begin(), times.begin() + 4, times.end());
    return times[4];
}

template<class T>
T required(Result<T>&& result) {
    if (result) return std::move(*result);
    std::fprintf(stderr, "%s\n", to_text(result.error().diagnostics.back()).c_str());
    std::exit(1);
}

Light light_of(const char* shape, const char* intensity, const Stage& stage) {
    LightDescription description;
    description.shape = required(parse_shape(shape));
    if (intensity != nullptr) description.intensity = required(parse_photometric_value(intensity));
    hang(description, stage.light);
    Diagnostics diagnostics;
    return required(resolve_light(std::move(description), diagnostics));
}

void print(const char* what, simd::InstructionSet set, double ms) {
    std::printf("%-24s %-8s %9.3f\n", what, to_text(set), ms);
}

} // namespace

int main() {
    constexpr std::size_t count = 16384;
    std::vector<float> numbers(12 * count);
    unsigned random = 1;
    for (float& number : numbers) {
        random = random * 1664525U + 1013904223U;
        number = static_cast<float>(random >> 8U) / 16777216.0F;
    }
    const auto column = [&](std::size_t i) { return numbers.data() + i * count; };
    for (std::size_t i = 0; i < count; ++i) { // normals and views point up, more or less
        column(3)[i] -= 0.5F;
        column(4)[i] -= 0.5F;
        for (const std::size_t first : {3U, 6U}) {
            const float x = column(first)[i], y = column(first + 1)[i], z = column(first + 2)[i] += 0.5F;
            const float scale = 1.0F / std::sqrt(x * x + y * y + z * z);
            for (std::size_t k = 0; k < 3; ++k)
                column(first + k)[i] *= scale;
        }
    }
    shading::Surfaces surfaces;
    surfaces.count = count;
    for (std::size_t k = 0; k < 3; ++k) {
        surfaces.position[k] = column(k);
        surfaces.normal[k] = column(3 + k);
        surfaces.view[k] = column(6 + k);
    }
    float* const rgb[3] = {column(9), column(10), column(11)};

    const Stage room = required(make_stage("room"));
    const auto glossy = material_constants(required(parse_material("ue4:roughness=0.4")));
    for (const simd::InstructionSet set : simd::available_sets()) {
        const simd::ArrayMath& math = simd::array_math(set);
        print("atan2", set, median_ms([&] { math.atan2(column(0), column(1), column(9), count); }));
        print("exp2", set, median_ms([&] { math.exp2(column(0), column(9), count); }));
        const shading::Kernels& kernels = shading::kernels(set);
        for (const auto& [name, shape] : {std::pair{"sphere", "sphere:r=10cm"}, std::pair{"rect", "rect:w=60cm,h=30cm"},
                                          std::pair{"tube", "tube:r=2cm,l=1m"}}) {
            const shading::LightConstants light = light_constants(light_of(shape, "800lm", room));
            print((std::string("irradiance of a ") + name).c_str(), set,
                  median_ms([&] { kernels.irradiance(surfaces, light, column(9)); }));
            print((std::string("ue4 under a ") + name).c_str(), set,
                  median_ms([&] { kernels.shade(surfaces, light, glossy, rgb); }));
        }
        for (const auto& [name, shape, intensity] :
             {std::tuple{"preview, profile", "ies:profiles/downlight.ies", static_cast<const char*>(nullptr)},
              std::tuple{"preview, sphere", "sphere:r=10cm", "800lm"}}) {
            const Light light = light_of(shape, intensity, room);
            RenderOptions options;
            options.width = 128;
            options.height = 128;
            options.threads = 1;
            options.instruction_set = set;
            print(name, set, median_ms([&] {
                      if (!render(room, {&light, 1}, room.camera, options)) std::exit(1);
                  }));
        }
    }
    print("read, resolve, flux", simd::InstructionSet::scalar, median_ms([] {
              const auto profile = required(read_profile_file("profiles/downlight.ies"));
              const auto resolved = required(resolve_web(profile));
              if (!(flux(resolved.web).value > 0.0)) std::exit(1);
          }));
}
