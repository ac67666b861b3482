// What every part of the Python module uses: errors, arrays, long calls.
//
// Python's names carry units as C++'s do (`_deg`, `_lm`, `_cd`). Arrays are NumPy's; functions of several arrays
// broadcast them, and give a float for numbers. Each subject has a file of its own and one function here.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/base/stop.hpp>

#include "columns.hpp"
#include "failed.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <utility>
#include <vector>

namespace gonio::python {

namespace py = pybind11;
using pybind11::literals::operator""_a;

void add_diagnostics(py::module_& module);
void add_profiles(py::module_& module);
void add_webs(py::module_& module);
void add_units(py::module_& module);
void add_colors(py::module_& module);
void add_lights(py::module_& module);
void add_materials(py::module_& module);
void add_textures(py::module_& module);
void add_previews(py::module_& module);
void add_rigs(py::module_& module);
void add_stages(py::module_& module);
void add_openings(py::module_& module);
void add_suns(py::module_& module);
void add_skies(py::module_& module);
void add_environments(py::module_& module);
void add_prefiltering(py::module_& module);
void add_split_sums(py::module_& module);
void add_exports(py::module_& module);
void add_media(py::module_& module);

template<class T>
T value_of(Result<T>&& result) {
    if (!result) throw Failed{std::move(result.error())};
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

// Warnings of a call whose result has no list of diagnostics: Python's warnings. Notes are left out.
void warn(const Diagnostics& diagnostics);

// Arrays in C order; anything that NumPy can turn into one is accepted, and only that costs a copy.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Both in one shape, by NumPy's rules.
std::array<Doubles, 2> broadcast(const Doubles& a, const Doubles& b);

using Floats = py::array_t<float>; // in any order

// Numbers as an array, as they are.
py::array as_array(const py::object& numbers);

// Whether an array holds floats in vectors, (n, 3) or (3): what the packs take.
bool is_float_vectors(const py::array& array);

// (3) is the same for all points.
Vectors vectors_of(const Floats& array);

// An array of that shape, to be filled.
Doubles like(const py::array& shape);

// Whether the last axis has three components; fails (usage) if not.
void require_vectors(const py::array& array, const char* name);

// The shape without the last axis.
std::vector<py::ssize_t> shape_of_vectors(const py::array& array);

// A float if there is one number without an axis, else the array.
py::object number_or_array(const Doubles& array);

// The library's floats as an array of that shape that cannot be written; `owner` keeps them alive.
py::array view_of(const py::object& owner, std::vector<py::ssize_t> shape, const float* numbers);

// Pixels (height, width), or (height, width, channels) if there are several, as such a view.
py::array view_of(const py::object& owner, const Image& image);

// An array (height, width) or (height, width, channels) of numbers as an image, a copy. Fails (usage) on other shapes.
Image image_of(const py::handle& pixels, const char* name);

// Linear Rec.709 as a PNG whose exposure fits it: what a notebook shows.
py::object exposed_png(const py::object& owner, const Image& rgb);

// work(vector) for each of (…, 3), whose results are numbers.
template<class Work>
py::object for_each_vector(const Doubles& vectors, const char* name, const Work& work);

// The same with results of three numbers: (…, 3).
template<class Work>
Doubles for_each_vector_rgb(const Doubles& vectors, const char* name, const Work& work);

// A unit vector of one of any length; fails (usage) on one without.
glm::dvec3 direction_of_length(const glm::dvec3& vector, const char* name);

// Three numbers: a tuple, a list or an array.
glm::dvec3 vector_of(const py::handle& numbers, const char* name);
Doubles to_array(const glm::dvec3& vector);

// The text of a path: str, bytes or os.PathLike.
std::string path_of(const py::handle& path);

template<class Work>
py::object for_each_vector(const Doubles& vectors, const char* name, const Work& work) {
    require_vectors(vectors, name);
    Doubles result(shape_of_vectors(vectors));
    const double* from = vectors.data();
    double* const to = result.mutable_data();
    const py::ssize_t count = result.size();
    {
        const py::gil_scoped_release released;
        for (py::ssize_t i = 0; i < count; ++i, from += 3)
            to[i] = work(glm::dvec3(from[0], from[1], from[2]));
    }
    return number_or_array(result);
}

template<class Work>
Doubles for_each_vector_rgb(const Doubles& vectors, const char* name, const Work& work) {
    require_vectors(vectors, name);
    Doubles result = like(vectors);
    const double* from = vectors.data();
    double* to = result.mutable_data();
    const py::ssize_t count = result.size() / 3;
    const py::gil_scoped_release released;
    for (py::ssize_t i = 0; i < count; ++i, from += 3, to += 3) {
        const glm::dvec3 value = work(glm::dvec3(from[0], from[1], from[2]));
        to[0] = value.x;
        to[1] = value.y;
        to[2] = value.z;
    }
    return result;
}

// The names of a list of the library.
template<class List>
std::vector<std::string> names_of(const List& list) {
    std::vector<std::string> names;
    for (const auto& row : list)
        names.emplace_back(row.name);
    return names;
}

// The same, each with its summary.
template<class List>
std::vector<std::pair<std::string, std::string>> summaries_of(const List& list) {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const auto& row : list)
        rows.emplace_back(row.name, row.summary);
    return rows;
}

// Runs `work` without Python's lock, on another thread, and looks for Ctrl-C while it runs: then its loops end early
// and KeyboardInterrupt is raised. For calls that may take longer than a person waits.
template<class Work>
auto interruptible(Work&& work) {
    std::atomic<bool> stop{false};
    auto running = std::async(std::launch::async, [&] {
        const StopLoops listening(stop);
        return work();
    });
    for (;;) {
        {
            const py::gil_scoped_release released;
            if (running.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready) break;
        }
        if (PyErr_CheckSignals() == 0) continue;
        stop = true;
        {
            const py::gil_scoped_release released;
            running.wait();
        }
        try {
            running.get();
        } catch (const LoopsStopped&) {
            // as asked
        }
        throw py::error_already_set();
    }
    return running.get();
}

} // namespace gonio::python
