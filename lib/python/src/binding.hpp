// What every part of the Python module uses: errors, arrays, long calls.
//
// Python's names carry units as C++'s do (`_deg`, `_lm`, `_cd`). Arrays are NumPy's; functions of several arrays
// broadcast them, and give a float for numbers. Each subject has a file of its own and one function here.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/base/stop.hpp>

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

// Becomes a gonio.Error of Python.
struct Failed {
    Error error;
};

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

// An array of that shape, to be filled.
Doubles like(const py::array& shape);

// Whether the last axis has three components; fails (usage) if not.
void require_vectors(const py::array& array, const char* name);

// The shape without the last axis.
std::vector<py::ssize_t> shape_of_vectors(const py::array& array);

// A float if there is one number without an axis, else the array.
py::object number_or_array(const Doubles& array);

// Three numbers: a tuple, a list or an array.
glm::dvec3 vector_of(const py::handle& numbers, const char* name);
Doubles to_array(const glm::dvec3& vector);

// The text of a path: str, bytes or os.PathLike.
std::string path_of(const py::handle& path);

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
