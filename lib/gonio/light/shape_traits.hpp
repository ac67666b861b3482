// The traits of all shapes (gonio/light/shapes/description.hpp), for code that has a Shape.
#pragma once

#include <gonio/light/shapes/cylinder.hpp>
#include <gonio/light/shapes/disk.hpp>
#include <gonio/light/shapes/ellipse.hpp>
#include <gonio/light/shapes/frustum.hpp>
#include <gonio/light/shapes/point.hpp>
#include <gonio/light/shapes/profile.hpp>
#include <gonio/light/shapes/rect.hpp>
#include <gonio/light/shapes/sphere.hpp>
#include <gonio/light/shapes/spot.hpp>
#include <gonio/light/shapes/sun.hpp>
#include <gonio/light/shapes/tube.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

namespace gonio {

// work(shape, ShapeTraits<its kind>{}).
template<class AnyShape, class Work>
decltype(auto) with_traits(AnyShape& shape, Work&& work) {
    return std::visit(
        [&](auto& kind) -> decltype(auto) { return work(kind, ShapeTraits<std::decay_t<decltype(kind)>>()); }, shape);
}

// Calls work(core light) with the light of the shading core for a shape with a size, placed by `frame`. Returns `none`
// for shapes without a size.
template<class Result, class Work>
Result with_core_light(const Shape& shape, const Frame& frame, const glm::dvec3& luminance, Result none, Work&& work) {
    return with_traits(shape, [&]<class Kind>(const Kind& kind, ShapeTraits<Kind>) -> Result {
        if constexpr (PunctualShape<Kind>)
            return none;
        else
            return work(ShapeTraits<Kind>::core(kind, frame, luminance));
    });
}

// work(ShapeTraits<Kind>{}) for every kind, in the order of `Shape`.
template<class Work>
void for_each_kind(Work&& work) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        (work(ShapeTraits<std::variant_alternative_t<i, Shape>>()), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Shape>>());
}

// work(key) for every key of a kind.
template<class Traits, class Work>
void for_each_key(Traits /*kind*/, Work&& work) {
    std::apply([&](const auto&... key) { (work(key), ...); }, Traits::keys);
}

} // namespace gonio
