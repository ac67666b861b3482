#include "binding.hpp"

#include <cmath>

namespace gonio::python {

std::array<Doubles, 2> broadcast(const Doubles& a, const Doubles& b) {
    if (a.ndim() == b.ndim() && std::equal(a.shape(), a.shape() + a.ndim(), b.shape())) return {a, b};
    const py::list both = py::module_::import("numpy").attr("broadcast_arrays")(a, b);
    return {Doubles(py::object(both[0])), Doubles(py::object(both[1]))};
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
