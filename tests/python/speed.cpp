// What speed.py compares the module with: the library's kernels on columns of a million points, on one thread.
//   gonio-python-speed POINTS     floats of positions x y z, then of normals x y z, column by column
// Prints a line for each case: its name, the least seconds of several runs with columns, and with rows x y z x y z,
// which a program copies into columns first, since that is what the kernels read.
#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace gonio;

constexpr std::size_t piece = 4096; // of intensities, which stay in the cache

template<class Work>
double least_seconds(const Work& work) {
    double least = 1e9;
    for (int run = 0; run < 7; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return least;
}

void to_rows(const float* columns, std::vector<float>& rows) {
    const std::size_t count = rows.size() / 3;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            rows[3 * i + k] = columns[k * count + i];
}

void to_columns(const std::vector<float>& rows, std::vector<float>& columns) {
    const std::size_t count = rows.size() / 3;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            columns[k * count + i] = rows[3 * i + k];
}

template<class T>
T required(Result<T>&& result) {
    if (result) return std::move(*result);
    std::fprintf(stderr, "%s\n", to_text(result.error().diagnostics.back()).c_str());
    std::exit(1);
}

Light light_of(const char* shape, const char* intensity) {
    LightDescription description;
    description.shape = required(parse_shape(shape));
    if (intensity != nullptr) description.intensity = required(parse_photometric_value(intensity));
    description.position = {0.0, 0.0, 2.0};
    Diagnostics diagnostics;
    return required(resolve_light(std::move(description), diagnostics));
}

} // namespace

int main(int count_of_arguments, char** arguments) {
    if (count_of_arguments != 2) return 2;
    std::ifstream file(arguments[1], std::ios::binary | std::ios::ate);
    const auto bytes = static_cast<std::size_t>(file.tellg());
    std::vector<float> numbers(bytes / sizeof(float));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(bytes));
    const std::size_t count = numbers.size() / 6;
    std::vector<float> rows_of_positions(3 * count), rows_of_normals(3 * count);
    to_rows(numbers.data(), rows_of_positions);
    to_rows(numbers.data() + 3 * count, rows_of_normals);
    // Kept from run to run: fresh memory costs more than the light does.
    std::vector<float> positions_by_column(3 * count), normals_by_column(3 * count);
    const shading::Kernels& kernels = shading::kernels(simd::best_available());
    for (const auto& [name, shape, intensity] :
         {std::tuple{"point", "point", "800lm"}, std::tuple{"sphere", "sphere:r=10cm", "800lm"},
          std::tuple{"rect", "rect:w=60cm,h=30cm", "800lm"},
          std::tuple{"profile", "ies:profiles/downlight.ies", static_cast<const char*>(nullptr)}}) {
        const Light light = light_of(shape, intensity);
        detail::WebTables tables;
        const detail::IntensityPattern pattern(light, tables);
        const bool is_point = class_of(light.shape) == ShapeClass::punctual;
        const auto scale = is_point ? 1.0F : static_cast<float>(light.luminance.value);
        const auto illuminance = [&](const float* positions, const float* normals) {
            std::vector<float> lx(count); // as Python makes an array for each result
            std::vector<float> intensities(piece);
            for (std::size_t begin = 0; begin < count; begin += is_point ? piece : count) {
                shading::Surfaces part;
                part.count = std::min(is_point ? piece : count, count - begin);
                for (std::size_t k = 0; k < 3; ++k) {
                    part.position[k] = positions + k * count + begin;
                    part.normal[k] = normals + k * count + begin;
                }
                shading::LightConstants constants = light_constants(light);
                if (is_point) {
                    pattern.evaluate({{part.position[0], part.position[1], part.position[2]}, part.count},
                                     glm::dvec3(0.0), transport::intensity_kernels(simd::best_available()),
                                     intensities.data());
                    constants.intensity_cd = intensities.data();
                }
                kernels.irradiance(part, constants, lx.data() + begin);
            }
            for (float& one : lx)
                one *= scale;
        };
        const double columns = least_seconds([&] { illuminance(numbers.data(), numbers.data() + 3 * count); });
        const double rows = least_seconds([&] {
            to_columns(rows_of_positions, positions_by_column);
            to_columns(rows_of_normals, normals_by_column);
            illuminance(positions_by_column.data(), normals_by_column.data());
        });
        std::printf("%s %.6e %.6e\n", name, columns, rows);
    }
    shading::DirectionPairs pairs;
    pairs.count = count;
    std::vector<float> views(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        views[i] = 0.0F;
        views[count + i] = -0.6F;
        views[2 * count + i] = 0.8F;
    }
    for (std::size_t k = 0; k < 3; ++k)
        pairs.to_eye[k] = views.data() + k * count;
    for (const char* const text : {"lambert:albedo=0.5", "ue4:roughness=0.4", "frostbite:smoothness=0.6,coat=1"}) {
        const shading::MaterialConstants constants = material_constants(required(parse_material(text)));
        const auto brdf = [&](const float* to_light) {
            for (std::size_t k = 0; k < 3; ++k)
                pairs.to_light[k] = to_light + k * count;
            std::vector<float> rgb(3 * count);
            float* const to[3] = {rgb.data(), rgb.data() + count, rgb.data() + 2 * count};
            shading::reflectance_kernels(simd::best_available()).brdf(pairs, constants, to);
            return rgb;
        };
        const double columns = least_seconds([&] { brdf(numbers.data() + 3 * count); });
        const double rows = least_seconds([&] {
            to_columns(rows_of_normals, normals_by_column);
            const std::vector<float> rgb = brdf(normals_by_column.data());
            to_rows(rgb.data(), positions_by_column);
        });
        std::printf("%s %.6e %.6e\n", text, columns, rows);
    }
    return 0;
}
