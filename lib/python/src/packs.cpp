#include "packs.hpp"

#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace gonio::python {

namespace {

using Room = std::array<float, 3 * piece_of_columns>;
using Numbers = std::array<float, piece_of_columns>;

// A light in the form of the packs.
struct PackedLight {
    shading::LightConstants constants;
    float scale; // luminance of an area light [cd/m²]
    std::optional<gonio::detail::IntensityPattern> pattern;

    // Of a punctual light its intensity towards the points is written into `room`.
    shading::LightConstants towards(const shading::Surfaces& surfaces, Numbers& room) const {
        shading::LightConstants at = constants;
        if (!pattern) return at;
        const transport::Points points{{surfaces.position[0], surfaces.position[1], surfaces.position[2]},
                                       surfaces.count};
        pattern->evaluate(points, glm::dvec3(0.0), transport::intensity_kernels(simd::best_available()), room.data());
        at.intensity_cd = room.data();
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
    Ways(const Vectors& vectors, const char* name) : vectors_(vectors), name_(name) {
        if (vectors.are_one()) fill(0, piece_of_columns);
    }
    void take(std::size_t begin, std::size_t size, const float* (&columns)[3]) {
        if (!vectors_.are_one()) fill(begin, size);
        std::copy_n(&columns_[0], 3, &columns[0]);
    }

private:
    void fill(std::size_t begin, std::size_t size) {
        vectors_.take(begin, size, room_.data(), columns_);
        make_unit(size, room_.data(), columns_, name_);
    }

    Vectors vectors_;
    const char* name_;
    const float* columns_[3] = {};
    Room room_;
};

// Calls work(begin, end) for the stretches of a thread, on all threads.
template<class Work>
void for_each_stretch(std::size_t count, unsigned threads, const Work& work) {
    constexpr std::size_t most = 64 * piece_of_columns;
    parallel_for((count + most - 1) / most, threads,
                 [&](std::size_t index) { work(index * most, std::min(count, (index + 1) * most)); });
}

// Calls work(own, begin, size) for pieces of columns; own = make() is what a thread needs.
template<class Make, class Work>
void for_each_piece(std::size_t count, unsigned threads, const Make& make, const Work& work) {
    for_each_stretch(count, threads, [&](std::size_t first, std::size_t end) {
        auto own = make();
        for (std::size_t begin = first; begin < end; begin += piece_of_columns)
            work(own, begin, std::min(piece_of_columns, end - begin));
    });
}

// The points of a piece as the kernels read them.
struct PiecesOfPoints {
    Vectors positions;
    Ways normals;
    Room position;
    Numbers intensity;
    Numbers share;

    explicit PiecesOfPoints(const Points& points) : positions(points.positions), normals(points.normals, "a normal") {}

    shading::Surfaces at(std::size_t begin, std::size_t size) {
        shading::Surfaces surfaces;
        surfaces.count = size;
        positions.take(begin, size, position.data(), surfaces.position);
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
    const auto add = [&](const shading::Surfaces& surfaces, Numbers& intensity, float* share, float* sum) {
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
    // The kernels of surfaces sort receivers, and do that best for many: columns need not be cut into pieces.
    const bool are_surfaces =
        std::none_of(all.begin(), all.end(), [](const PackedLight& light) { return light.pattern.has_value(); });
    const bool are_columns = points.positions.are_columns() && points.normals.are_columns();
    const auto in_pieces = [&](std::size_t first, std::size_t end) {
        PiecesOfPoints piece(points);
        for (std::size_t begin = first; begin < end; begin += piece_of_columns) {
            const std::size_t size = std::min(piece_of_columns, end - begin);
            add(piece.at(begin, size), piece.intensity, piece.share.data(), lx + begin);
        }
    };
    for_each_stretch(points.count, threads, [&](std::size_t begin, std::size_t end) {
        if (!are_surfaces || !are_columns) return in_pieces(begin, end);
        shading::Surfaces surfaces;
        surfaces.count = end - begin;
        points.positions.take(begin, surfaces.count, nullptr, surfaces.position);
        points.normals.take(begin, surfaces.count, nullptr, surfaces.normal);
        if (!shading::reflectance_kernels(simd::best_available()).are_unit(surfaces.normal, surfaces.count))
            return in_pieces(begin, end);
        std::vector<float> share(all.size() > 1 ? surfaces.count : 0);
        Numbers unused;
        add(surfaces, unused, share.data(), lx + begin);
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
    for_each_piece(
        points.count, threads, [&] { return PiecesOfPoints(points); },
        [&](PiecesOfPoints& piece, std::size_t begin, std::size_t size) {
            shading::Surfaces surfaces = piece.at(begin, size);
            Room view;
            Room shade;
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t i = 0; i < size; ++i)
                    view[k * piece_of_columns + i] = at[k] - surfaces.position[k][i];
                surfaces.view[k] = view.data() + k * piece_of_columns;
            }
            make_unit(size, view.data(), surfaces.view, "the way to the eye");
            float* const sum = nits + begin;
            std::fill_n(sum, size, 0.0F);
            float* const rgb[3] = {shade.data(), shade.data() + piece_of_columns, shade.data() + 2 * piece_of_columns};
            for (const PackedLight& light : all) {
                kernels.shade(surfaces, light.towards(surfaces, piece.intensity), constants, rgb);
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
            return Pieces{Ways(ways.to_light, "a direction"), Ways(ways.to_eye, "a direction"), {}};
        },
        [&](Pieces& piece, std::size_t begin, std::size_t size) {
            shading::DirectionPairs pairs;
            pairs.count = size;
            piece.lights.take(begin, size, pairs.to_light);
            piece.eyes.take(begin, size, pairs.to_eye);
            float* const at = by_columns ? rgb + begin : piece.value.data();
            const std::size_t step = by_columns ? ways.count : piece_of_columns;
            float* const to[3] = {at, at + step, at + 2 * step};
            kernels.brdf(pairs, constants, to);
            if (!by_columns) columns_to_rows(to[0], to[1], to[2], size, rgb + 3 * begin);
        });
}

} // namespace gonio::python
