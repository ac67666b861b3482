#include "packs.hpp"

#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace gonio::python {

namespace {

// Vectors to a piece: 512 of two kinds, and results, are 20 kB, which stay in the first cache.
constexpr std::size_t small_piece = 512;
// The kernels of surfaces sort receivers by what they see of the light, and do that best for many: 130 kB.
constexpr std::size_t large_piece = 4096;

// A light in the form of the packs.
struct PackedLight {
    shading::LightConstants constants;
    float scale; // luminance of an area light [cd/m²]
    std::optional<gonio::detail::IntensityPattern> pattern;

    // Of a punctual light its intensity towards the points is written into `room`.
    shading::LightConstants towards(const shading::Surfaces& surfaces, float* room) const {
        shading::LightConstants at = constants;
        if (!pattern) return at;
        const transport::Points points{{surfaces.position[0], surfaces.position[1], surfaces.position[2]},
                                       surfaces.count};
        pattern->evaluate(points, glm::dvec3(0.0), transport::intensity_kernels(simd::best_available()), room);
        at.intensity_cd = room;
        return at;
    }
};

std::vector<PackedLight> packed(const std::vector<Light>& lights, gonio::detail::WebTables& tables) {
    std::vector<PackedLight> all;
    all.reserve(lights.size());
    for (const Light& light : lights) {
        const shading::LightConstants constants = light_constants(light);
        if (constants.kind == shading::LightConstants::Kind::punctual)
            all.push_back({constants, 1.0F, gonio::detail::IntensityPattern(light, tables)});
        else
            all.push_back({constants, static_cast<float>(light.luminance.value), {}});
    }
    return all;
}

// Unit vectors in columns, piece by piece; what is the same for all points is copied and checked once.
class Ways {
public:
    Ways(const Vectors& vectors, const char* name, std::size_t most) : vectors_(vectors), name_(name), room_(most) {
        if (vectors.are_one()) fill(0, most);
    }
    void take(std::size_t begin, std::size_t size, const float* (&columns)[3]) {
        if (!vectors_.are_one()) fill(begin, size);
        std::copy_n(&columns_[0], 3, &columns[0]);
    }

private:
    void fill(std::size_t begin, std::size_t size) {
        vectors_.take(begin, size, room_, columns_);
        make_unit(size, room_, columns_, name_);
    }

    Vectors vectors_;
    const char* name_;
    const float* columns_[3] = {};
    Room room_;
};

// Calls work(begin, end) for the stretches of a thread, on all threads: some for each, so that none waits long for the
// others, and long ones, since each begins with work of its own.
template<class Work>
void for_each_stretch(std::size_t count, unsigned threads, const Work& work) {
    const std::size_t share = count / (4 * std::size_t{threads == 0 ? available_threads() : threads});
    const std::size_t stretch = std::max(8 * large_piece, share / large_piece * large_piece);
    parallel_for((count + stretch - 1) / stretch, threads,
                 [&](std::size_t index) { work(index * stretch, std::min(count, (index + 1) * stretch)); });
}

// Calls work(own, begin, size) for pieces of columns; own = make() is what a thread needs.
template<class Make, class Work>
void for_each_piece(std::size_t count, unsigned threads, const Make& make, const Work& work) {
    for_each_stretch(count, threads, [&](std::size_t first, std::size_t end) {
        auto own = make();
        for (std::size_t begin = first; begin < end; begin += small_piece)
            work(own, begin, std::min(small_piece, end - begin));
    });
}

// The points of a piece of at most `most` as the kernels read them.
struct PiecesOfPoints {
    std::size_t most;
    Vectors positions;
    Ways normals;
    Room position;
    std::vector<float> intensity;
    std::vector<float> share; // of one light of several

    PiecesOfPoints(const Points& points, std::size_t size)
        : most(size),
          positions(points.positions),
          normals(points.normals, "a normal", size),
          position(size),
          intensity(size),
          share(size) {}

    shading::Surfaces at(std::size_t begin, std::size_t size) {
        shading::Surfaces surfaces;
        surfaces.count = size;
        positions.take(begin, size, position, surfaces.position);
        normals.take(begin, size, surfaces.normal);
        return surfaces;
    }
};

} // namespace

bool fits_packs_alone(const Light& light) {
    return light.parts == nullptr && light.body == nullptr && light.emission == nullptr &&
           (class_of(light.shape) == ShapeClass::punctual || (light.image == nullptr && !light.has_pattern()));
}

void illuminance_in_packs(const std::vector<Light>& lights, const Points& points, unsigned threads, float* lx) {
    constexpr float ceiling = std::numeric_limits<float>::max();
    gonio::detail::WebTables tables;
    const std::vector<PackedLight> all = packed(lights, tables);
    const shading::Kernels& kernels = shading::kernels(simd::best_available());
    const auto add = [&](const shading::Surfaces& surfaces, float* intensity, float* share, float* sum) {
        if (all.empty()) std::fill_n(sum, surfaces.count, 0.0F);
        for (const PackedLight& light : all) {
            const bool is_first = &light == &all.front();
            float* const to = is_first ? sum : share;
            kernels.irradiance(surfaces, light.towards(surfaces, intensity), to);
            const float scale = light.scale;
            if (is_first && scale == 1.0F) continue;
            for (std::size_t i = 0; i < surfaces.count; ++i)
                sum[i] = std::min((is_first ? 0.0F : sum[i]) + scale * to[i], ceiling);
        }
    };
    const bool are_surfaces =
        std::none_of(all.begin(), all.end(), [](const PackedLight& light) { return light.pattern.has_value(); });
    const bool are_columns = points.positions.are_columns() && points.normals.are_columns();
    const auto in_pieces = [&](std::size_t first, std::size_t end) {
        PiecesOfPoints piece(points, std::min(are_surfaces ? large_piece : small_piece, end - first));
        for (std::size_t begin = first; begin < end; begin += piece.most) {
            const std::size_t size = std::min(piece.most, end - begin);
            add(piece.at(begin, size), piece.intensity.data(), piece.share.data(), lx + begin);
        }
    };
    for_each_stretch(points.count, threads, [&](std::size_t begin, std::size_t end) {
        if (!are_surfaces || !are_columns) return in_pieces(begin, end);
        shading::Surfaces surfaces;
        surfaces.count = end - begin;
        points.positions.in_place(begin, surfaces.position);
        points.normals.in_place(begin, surfaces.normal);
        if (!shading::reflectance_kernels(simd::best_available()).are_unit(surfaces.normal, surfaces.count))
            return in_pieces(begin, end);
        std::vector<float> share(all.size() > 1 ? surfaces.count : 0);
        add(surfaces, nullptr, share.data(), lx + begin);
    });
}

void luminance_in_packs(const std::vector<Light>& lights, const Points& points, const glm::dvec3& eye,
                        const Material& material, unsigned threads, float* nits) {
    gonio::detail::WebTables tables;
    const std::vector<PackedLight> all = packed(lights, tables);
    const shading::MaterialConstants constants = material_constants(material);
    const shading::Kernels& kernels = shading::kernels(simd::best_available());
    const float at[3] = {static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)};
    const float y[3] = {static_cast<float>(rec709_luminance.x), static_cast<float>(rec709_luminance.y),
                        static_cast<float>(rec709_luminance.z)};
    struct Pieces {
        PiecesOfPoints points;
        Room view, shade;
    };
    for_each_piece(
        points.count, threads,
        [&] {
            return Pieces{PiecesOfPoints(points, small_piece), Room(small_piece), Room(small_piece)};
        },
        [&](Pieces& own, std::size_t begin, std::size_t size) {
            auto& [piece, view, shade] = own;
            shading::Surfaces surfaces = piece.at(begin, size);
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t i = 0; i < size; ++i)
                    view.column(k)[i] = at[k] - surfaces.position[k][i];
                surfaces.view[k] = view.column(k);
            }
            make_unit(size, view, surfaces.view, "the way to the eye");
            float* const sum = nits + begin;
            std::fill_n(sum, size, 0.0F);
            float* const rgb[3] = {shade.column(0), shade.column(1), shade.column(2)};
            for (const PackedLight& light : all) {
                kernels.shade(surfaces, light.towards(surfaces, piece.intensity.data()), constants, rgb);
                for (std::size_t i = 0; i < size; ++i)
                    sum[i] += y[0] * rgb[0][i] + y[1] * rgb[1][i] + y[2] * rgb[2][i];
            }
        });
}

void reflectance_in_packs(const Material& material, const WaysOfLight& ways, bool by_columns, unsigned threads,
                          float* rgb) {
    const shading::MaterialConstants constants = material_constants(material);
    const shading::ReflectanceKernels& kernels = shading::reflectance_kernels(simd::best_available());
    struct Pieces {
        Ways lights, eyes;
        Room value;
    };
    for_each_piece(
        ways.count, threads,
        [&] {
            return Pieces{Ways(ways.to_light, "a direction", small_piece),
                          Ways(ways.to_eye, "a direction", small_piece), Room(small_piece)};
        },
        [&](Pieces& piece, std::size_t begin, std::size_t size) {
            shading::DirectionPairs pairs;
            pairs.count = size;
            piece.lights.take(begin, size, pairs.to_light);
            piece.eyes.take(begin, size, pairs.to_eye);
            float* to[3];
            for (std::size_t k = 0; k < 3; ++k)
                to[k] = by_columns ? rgb + k * ways.count + begin : piece.value.column(k);
            kernels.brdf(pairs, constants, to);
            if (!by_columns) columns_to_rows(to[0], to[1], to[2], size, rgb + 3 * begin);
        });
}

} // namespace gonio::python
