// Runs every function that `gonio shader` prints on the machine's own GPU: compute shaders of OpenGL ES 3.1, at the
// poses of gonio-shader-cases. Compares each result with the core in double, within the error that the comment of the
// function states, and prints tables of errors and of times. Run by gpu.sh.
//
//   gonio-shader-gpu MADE [--no-times]
//
// MADE is the folder that gonio-shader-cases wrote. Exits with 1 if an error is larger than stated.
#include <nlohmann/json.hpp>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl31.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr GLenum time_elapsed = 0x88BF; // GL_TIME_ELAPSED_EXT of GL_EXT_disjoint_timer_query
constexpr GLenum disjoint = 0x8FBB;     // GL_GPU_DISJOINT_EXT
constexpr int group_size = 64;
// How often a thread evaluates the function where it is timed.
constexpr int evaluations = 64;

// Whether a processor draws instead of a GPU.
bool is_software() {
    const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos ||
           renderer.find("SwiftShader") != std::string::npos;
}

// An OpenGL ES context without a window: of the first GPU that gives one, else of what imitates one.
void make_context() {
    std::vector<EGLDisplay> displays;
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto display_of =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (query_devices != nullptr && display_of != nullptr) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE)
            for (EGLint i = 0; i < count; ++i)
                displays.push_back(
                    display_of(EGL_PLATFORM_DEVICE_EXT, devices.at(static_cast<std::size_t>(i)), nullptr));
    }
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    std::pair<EGLDisplay, EGLContext> software{EGL_NO_DISPLAY, EGL_NO_CONTEXT};
    for (EGLDisplay display : displays) {
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) continue;
        const std::array<EGLint, 5> version{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
        if (eglBindAPI(EGL_OPENGL_ES_API) != EGL_TRUE) continue;
        EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version.data());
        if (context == EGL_NO_CONTEXT || eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE)
            continue;
        if (!is_software()) return;
        if (software.second == EGL_NO_CONTEXT) software = {display, context};
    }
    if (software.second != EGL_NO_CONTEXT &&
        eglMakeCurrent(software.first, EGL_NO_SURFACE, EGL_NO_SURFACE, software.second) == EGL_TRUE)
        return;
    throw std::runtime_error("no OpenGL ES 3.1 without a window on this machine");
}

// The poses of one function on the GPU: number k of pose i is at k·count + i, so that neighbouring threads read
// neighbouring numbers.
struct Poses {
    GLuint inputs = 0;
    GLuint results = 0;
    int count = 0;
    int per_case = 0;

    Poses(const std::vector<float>& numbers, int each)
        : count(static_cast<int>(numbers.size()) / each), per_case(each) {
        std::vector<float> by_number(numbers.size());
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < each; ++k)
                by_number[static_cast<std::size_t>(k * count + i)] = numbers[static_cast<std::size_t>(i * each + k)];
        inputs = buffer(by_number.size() * sizeof(float), by_number.data());
        results = buffer(static_cast<std::size_t>(count) * 4 * sizeof(float), nullptr);
    }
    Poses(const Poses&) = delete;
    Poses& operator=(const Poses&) = delete;
    ~Poses() {
        glDeleteBuffers(1, &inputs);
        glDeleteBuffers(1, &results);
    }

private:
    static GLuint buffer(std::size_t bytes, const void* data) {
        GLuint made = 0;
        glGenBuffers(1, &made);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, made);
        glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_COPY);
        return made;
    }
};

// A compute shader that calls the function `repeat` times in each thread, at one pose, and keeps the sum. No compiler
// knows that the numbers stay the same.
class Program {
public:
    Program(const std::string& function, const std::string& call, bool is_vector, const Poses& poses, int repeat) {
        const std::string count = std::to_string(poses.count);
        const std::string numbers = std::to_string(poses.per_case);
        const std::string text = "#version 310 es\n" + function + R"(
layout(local_size_x = )" + std::to_string(group_size) +
                                 R"() in;
layout(std430, binding = 0) readonly buffer Inputs { float inputs[]; };
layout(std430, binding = 1) writeonly buffer Results { vec4 results[]; };
void main() {
    uint pose = gl_GlobalInvocationID.x % )" +
                                 count + R"(u;
    float n[)" + numbers + R"(];
    for (uint k = 0u; k < )" + numbers +
                                 R"(u; ++k) n[k] = inputs[k * )" + count + R"(u + pose];
    vec4 sum = vec4(0.0);
    for (uint r = 0u; r < )" + std::to_string(repeat) +
                                 R"(u; ++r) {
        sum += )" + (is_vector ? "vec4(" + call + ", 1.0)" : "vec4(" + call + ")") +
                                 R"(;
        for (uint k = 0u; k < )" +
                                 numbers +
                                 R"(u; ++k) n[k] += 1e-30 * sum.x;
    }
    results[pose] = sum;
}
)";
        GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
        const char* const source = text.c_str();
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        GLint ok = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        if (ok == 0) {
            std::string log(4096, '\0');
            glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
            throw std::runtime_error("does not compile:\n" + log);
        }
        program_ = glCreateProgram();
        glAttachShader(program_, shader);
        glLinkProgram(program_);
        glDeleteShader(shader);
        glGetProgramiv(program_, GL_LINK_STATUS, &ok);
        if (ok == 0) throw std::runtime_error("does not link");
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { glDeleteProgram(program_); }

    void run(const Poses& poses, int groups) const {
        glUseProgram(program_);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, poses.inputs);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, poses.results);
        glDispatchCompute(static_cast<GLuint>(groups), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    }

private:
    GLuint program_ = 0;
};

std::vector<float> results_of(const Poses& poses) {
    const std::size_t bytes = static_cast<std::size_t>(poses.count) * 4 * sizeof(float);
    std::vector<float> out(static_cast<std::size_t>(poses.count) * 4);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, poses.results);
    const void* const mapped =
        glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
    if (mapped == nullptr) throw std::runtime_error("results cannot be read");
    std::memcpy(out.data(), mapped, bytes);
    glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
    return out;
}

using ResultOfQuery = void (*)(GLuint query, GLenum what, std::uint64_t* result);

// glGetQueryObjectui64vEXT of GL_EXT_disjoint_timer_query.
ResultOfQuery result_of_query() {
    static const auto found = reinterpret_cast<ResultOfQuery>(eglGetProcAddress("glGetQueryObjectui64vEXT"));
    return found;
}

bool has_clock() {
    const std::string extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    return extensions.find("GL_EXT_disjoint_timer_query") != std::string::npos && result_of_query() != nullptr;
}

// A program whose calls are timed by the GPU's own clock.
class Timed {
public:
    Timed(const std::string& function, const std::string& call, bool is_vector, const Poses& poses)
        : poses_(poses), program_(function, call, is_vector, poses, evaluations) {}

    void run() {
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(time_elapsed, query);
        program_.run(poses_, groups);
        glEndQuery(time_elapsed);
        std::uint64_t took_ns = 0;
        result_of_query()(query, GL_QUERY_RESULT, &took_ns);
        glDeleteQueries(1, &query);
        least_ns_ = std::min(least_ns_, static_cast<double>(took_ns));
    }
    // Of one call, in the quickest run.
    double picoseconds() const { return 1e3 * least_ns_ / (static_cast<double>(groups) * group_size * evaluations); }

private:
    static constexpr int groups = 16384;
    const Poses& poses_;
    Program program_;
    double least_ns_ = std::numeric_limits<double>::infinity();
};

// A row of the table of times.
struct TimedFunction {
    std::string name;
    std::unique_ptr<Poses> poses;
    std::map<std::string, std::unique_ptr<Timed>> programs; // by column
};

// In rounds without pauses, because a GPU that waits lowers its clock.
void print_times(std::vector<TimedFunction>& functions) {
    const auto round = [&] {
        for (TimedFunction& function : functions)
            for (const auto& [column, program] : function.programs)
                program->run();
    };
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < std::chrono::seconds(2))
        round();
    GLint is_disjoint = 0;
    glGetIntegerv(disjoint, &is_disjoint); // reading it resets it
    for (int i = 0; i < 9; ++i)
        round();
    glGetIntegerv(disjoint, &is_disjoint);
    if (is_disjoint != 0) std::puts("\nThe clock of the GPU jumped while it measured: run it again.");
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error("times: OpenGL reports error " + std::to_string(error));
    std::puts("\n| ps for a call | early returns | selects | by hand | loop alone |\n|---|---:|---:|---:|---:|");
    for (const TimedFunction& function : functions) {
        std::printf("| %s |", function.name.c_str());
        for (const char* column : {"real", "select", "hand", "loop"}) {
            const auto found = function.programs.find(column);
            if (found == function.programs.end())
                std::printf(" |");
            else
                std::printf(" %.1f |", found->second->picoseconds());
        }
        std::puts("");
    }
}

// The largest share of the stated error's scale, apart from the light and near it.
std::array<double, 2> largest_errors(const Json& cases, const std::vector<float>& out) {
    std::array<double, 2> found{};
    const int channels = cases["vector"].get<bool>() ? 3 : 1;
    const std::vector<double> scales = cases["scale"], expected = cases["expected"];
    const std::vector<int> is_near = cases["is_near"];
    for (std::size_t i = 0; i < scales.size(); ++i)
        for (int k = 0; k < channels; ++k) {
            const double wanted = expected[3 * i + static_cast<std::size_t>(k)];
            const double error = std::abs(static_cast<double>(out[4 * i + static_cast<std::size_t>(k)]) - wanted) /
                                 (std::abs(wanted) + scales[i]);
            double& largest = found.at(static_cast<std::size_t>(is_near[i]));
            largest = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(largest, error);
        }
    return found;
}

std::string shown(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1e", x);
    return text.data();
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2 && !(argc == 3 && std::string_view(argv[2]) == "--no-times")) {
        std::fputs("usage: gonio-shader-gpu MADE [--no-times]\n", stderr);
        return 2;
    }
    try {
        make_context();
        const bool has_times = argc == 2 && !is_software() && has_clock();
        std::printf("%s, %s\n\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
                    reinterpret_cast<const char*>(glGetString(GL_VERSION)));
        std::puts("| function | error: early returns | near | selects | near |\n|---|---:|---:|---:|---:|");
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(fs::path(argv[1]) / "cases"))
            files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        std::vector<TimedFunction> timed;
        bool failed = false;
        for (const fs::path& file : files) {
            std::ifstream stream(file);
            const Json cases = Json::parse(stream);
            const std::string name = cases["function"];
            const std::string call = name + "(" + cases["arguments"].get<std::string>() + ")";
            const bool is_vector = cases["vector"];
            auto kept = std::make_unique<Poses>(cases["inputs"].get<std::vector<float>>(), cases["per_case"]);
            const Poses& poses = *kept;
            const bool has_near = std::ranges::count(cases["is_near"].get<std::vector<int>>(), 1) > 0;
            std::printf("| %s", name.c_str());
            for (const char* branches : {"real", "select"}) {
                const Program program(cases[branches], call, is_vector, poses, 1);
                program.run(poses, (poses.count + group_size - 1) / group_size);
                const std::array<double, 2> errors = largest_errors(cases, results_of(poses));
                std::printf(" | %s | %s", shown(errors[0]).c_str(), has_near ? shown(errors[1]).c_str() : "");
                const std::array<double, 2> stated{cases["apart"], cases["near"]};
                for (std::size_t near = 0; near < 2; ++near)
                    if (!(errors.at(near) <= stated.at(near))) {
                        failed = true;
                        std::fprintf(stderr, "%s, %s: %s, not %s\n", name.c_str(), branches,
                                     shown(errors.at(near)).c_str(), shown(stated.at(near)).c_str());
                    }
            }
            std::puts(" |");
            if (has_times) {
                TimedFunction& row = timed.emplace_back();
                row.name = name;
                for (const char* column : {"real", "select", "hand"})
                    if (cases.contains(column))
                        row.programs[column] = std::make_unique<Timed>(cases[column], call, is_vector, poses);
                std::string all = "n[0]";
                for (int k = 1; k < poses.per_case; ++k)
                    all += " + n[" + std::to_string(k) + "]";
                row.programs["loop"] = std::make_unique<Timed>("precision highp float;",
                                                               is_vector ? "vec3(" + all + ")" : all, is_vector, poses);
                row.poses = std::move(kept);
            }
            if (const GLenum error = glGetError(); error != GL_NO_ERROR)
                throw std::runtime_error(name + ": OpenGL reports error " + std::to_string(error));
        }
        if (has_times)
            print_times(timed);
        else if (argc == 2)
            std::puts("\nNo times: a processor draws, or OpenGL has no clock.");
        return failed ? 1 : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gonio-shader-gpu: %s\n", error.what());
        return 1;
    }
}
