#include "binding.hpp"

#include <gonio/preview/exposure.hpp>
#include <gonio/scene/probe.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace gonio::python {

std::array<Doubles, 2> broadcast(const Doubles& a, const Doubles& b) {
    if (a.ndim() == b.ndim() && std::equal(a.shape(), a.shape() + a.ndim(), b.shape())) return {a, b};
    const py::list both = py::module_::import("numpy").attr("broadcast_arrays")(a, b);
    return {Doubles(py::object(both[0])), Doubles(py::object(both[1]))};
}

py::array as_array(const py::object& numbers) {
    const py::array array = py::array::ensure(numbers);
    if (!array) throw py::error_already_set();
    return array;
}

bool is_float_vectors(const py::array& array) {
    return py::isinstance<py::array_t<float, 0>>(array) && (array.ndim() == 1 || array.ndim() == 2) &&
           array.shape(array.ndim() - 1) == 3;
}

Vectors vectors_of(const Floats& array) {
    return {array.data(), array.ndim() == 1 ? 0 : array.strides(0), array.strides(array.ndim() - 1)};
}

Doubles like(const py::array& shape) {
    return Doubles(std::vector<py::ssize_t>(shape.shape(), shape.shape() + shape.ndim()));
}

void require_vectors(const py::array& array, const char* name) {
    if (array.ndim() < 1 || array.shape(array.ndim() - 1) != 3)
        throw Failed{fail("USE0105", std::string(name) + " must be vectors: an array whose last axis has 3 numbers",
                          "for example [[0, 0, 1], [1, 0, 1]]")
                         .value()};
}

std::vector<py::ssize_t> shape_of_vectors(const py::array& array) {
    return {array.shape(), array.shape() + array.ndim() - 1};
}

py::object number_or_array(const Doubles& array) {
    if (array.ndim() == 0) return py::float_(*array.data());
    return array;
}

py::array view_of(const py::object& owner, std::vector<py::ssize_t> shape, const float* numbers) {
    py::array_t<float> array(std::move(shape), numbers, owner);
    array.attr("setflags")("write"_a = false);
    return array;
}

py::array view_of(const py::object& owner, const Image& image) {
    std::vector<py::ssize_t> shape{image.height, image.width};
    if (image.channels != 1) shape.push_back(image.channels);
    return view_of(owner, std::move(shape), image.pixels.data());
}

Image image_of(const py::handle& pixels, const char* name) {
    const auto array = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(pixels);
    if (!array) throw py::error_already_set();
    constexpr py::ssize_t most = std::numeric_limits<int>::max();
    const bool has_rows = array.ndim() == 2 || array.ndim() == 3;
    if (!has_rows || array.size() == 0 || array.size() > most)
        throw Failed{fail("USE0105",
                          std::string(name) + " must be pixels: an array (height, width) or (height, width, 3)",
                          "for example numpy.ones((64, 128, 3))")
                         .value()};
    Image image;
    image.height = static_cast<int>(array.shape(0));
    image.width = static_cast<int>(array.shape(1));
    image.channels = array.ndim() == 3 ? static_cast<int>(array.shape(2)) : 1;
    image.pixels.assign(array.data(), array.data() + array.size());
    return image;
}

py::object exposed_png(const py::object& owner, const Image& rgb) {
    const double white = white_luminance(auto_exposure(rgb)).value;
    return py::module_::import("gonio._png")
        .attr("srgb_png")(py::object(view_of(owner, rgb)) * py::float_(1.0 / white));
}

glm::dvec3 direction_of_length(const glm::dvec3& vector, const char* name) {
    const std::optional<glm::dvec3> unit = unit_vector(vector);
    if (!unit) throw Failed{fail("USE0105", std::string(name) + " must be finite and longer than 0").value()};
    return *unit;
}

glm::dvec3 vector_of(const py::handle& numbers, const char* name) {
    const auto array = Doubles::ensure(numbers);
    if (!array) throw py::error_already_set();
    if (array.ndim() != 1 || array.shape(0) != 3)
        throw Failed{fail("USE0105", std::string(name) + " must be three numbers", "for example (0, 0, 2.5)").value()};
    return {array.at(0), array.at(1), array.at(2)};
}

Doubles to_array(const glm::dvec3& vector) {
    Doubles array(3);
    for (int i = 0; i < 3; ++i)
        array.mutable_at(i) = vector[i];
    return array;
}

std::string path_of(const py::handle& path) {
    const py::object text = py::module_::import("os").attr("fsencode")(path);
    return text.cast<std::string>();
}

} // namespace gonio::python
