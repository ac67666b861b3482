// Conversions per second: value to emission to another unit, for each shape, next to the same conversion with the
// shape's constants prepared once, and to the bare arithmetic of a point light, which is the baseline.
#include <gonio/base/unit_text.hpp>
#include <gonio/light/photometry.hpp>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <numbers>
#include <string>

namespace {

using namespace gonio;

struct Question {
    const char* name;
    const char* shape;
    const char* value;
    const char* wanted;
};

constexpr Question questions[] = {
    {"point lm to cd", "point", "800lm", "cd"},
    {"spot lm to cd", "spot:inner=25deg,outer=40deg", "800lm", "cd"},
    {"spot by angle lm to lx@2m", "spot:inner=25deg,outer=40deg,falloff=smoothstep-angle", "800lm", "lx@2m"},
    {"frustum lm to cd", "frustum:h=60deg,v=40deg", "800lm", "cd"},
    {"sphere lm to nt", "sphere:r=3cm", "800lm", "nt"},
    {"disk lm to lx@2m", "disk:r=3cm", "800lm", "lx@2m"},
    {"rect lm to lx@2m", "rect:w=60cm,h=30cm", "800lm", "lx@2m"},
    {"tube lm to lx@2m", "tube:r=1.3cm,l=1.2m", "800lm", "lx@2m"},
    {"tube lm to ev", "tube:r=1.3cm,l=1.2m", "800lm", "ev"},
    {"sun lx to nt", "sun:angle=0.53deg", "100klx", "nt"},
    {"profile lm to cd", "ies:" GONIO_TEST_SOURCE "/profiles/downlight.ies", "800lm", "cd"},
};

template<class T>
T must(Result<T> result) {
    if (!result) std::abort();
    return std::move(*result);
}

void baseline(benchmark::State& state) {
    double lumens = 800.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(lumens);
        benchmark::DoNotOptimize(lumens / (4.0 * std::numbers::pi));
    }
    state.SetItemsProcessed(state.iterations());
}

struct Asked {
    Shape shape;
    PhotometricValue value;
    PhotometricUnit wanted;
};

Asked asked(const Question& question) {
    Asked made{must(parse_shape(question.shape)), must(parse_photometric_value(question.value)),
               must(parse_photometric_unit(question.wanted))};
    Diagnostics ignored;
    if (!load_profile(made.shape, ignored)) std::abort();
    return made;
}

void each_alone(benchmark::State& state, const Question& question) {
    const Asked ask = asked(question);
    for (auto _ : state) {
        const Emission emission = must(emission_of(ask.shape, ask.value));
        benchmark::DoNotOptimize(must(express(ask.shape, emission, ask.wanted)));
    }
    state.SetItemsProcessed(state.iterations());
}

void prepared(benchmark::State& state, const Question& question) {
    const Asked ask = asked(question);
    ShapePhotometry photometry = must(ShapePhotometry::of(ask.shape));
    for (auto _ : state) {
        const Emission emission = must(photometry.emission_of(ask.value));
        benchmark::DoNotOptimize(must(photometry.express(emission, ask.wanted)));
    }
    state.SetItemsProcessed(state.iterations());
}

void from_text(benchmark::State& state, const Question& question) {
    for (auto _ : state) {
        const Asked ask = asked(question);
        const Emission emission = must(emission_of(ask.shape, ask.value));
        benchmark::DoNotOptimize(must(express(ask.shape, emission, ask.wanted)));
    }
    state.SetItemsProcessed(state.iterations());
}

} // namespace

int main(int argc, char** argv) {
    benchmark::RegisterBenchmark("baseline: 800 / 4 pi", baseline);
    for (const Question& question : questions) {
        benchmark::RegisterBenchmark((std::string(question.name) + ", prepared").c_str(), prepared, question);
        benchmark::RegisterBenchmark((std::string(question.name) + ", alone").c_str(), each_alone, question);
        benchmark::RegisterBenchmark((std::string(question.name) + ", from text").c_str(), from_text, question);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
