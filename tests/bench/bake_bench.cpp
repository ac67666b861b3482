// Google Benchmark of bake_texture, on one thread.
//
// How to read it: times vary with the machine; ratios within one run are stable. The web has 24 planes by 37 γ, without
// any symmetry and with light everywhere, so nothing is skipped unless a row says so; every row makes a whole texture
// with its totals and errors. The baseline is `lookup`: the web's bilinear interpolant at the centre of each texel of a
// latlong texture and nothing else, which is what other programs bake; of the same size, or of 1024 × 512 for other
// layouts. The table at the end shows the ratios; `items_per_second` counts texels.
#include <gonio/bake/bake.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gonio;

std::vector<double> steps(double first, double last, int count) {
    std::vector<double> angles;
    for (int i = 0; i < count; ++i)
        angles.push_back(first + (last - first) * i / (count - 1));
    return angles;
}

// 24 planes all around, and a 25th that closes the circle; 37 γ.
Web without_symmetry() {
    std::mt19937 random(1);
    std::vector<double> candela(std::size_t{25} * 37);
    for (double& cd : candela)
        cd = static_cast<double>(1 + random() % 1000);
    std::copy_n(candela.begin(), 37, candela.end() - 37);
    return *Web::create(Symmetry::none, steps(0, 360, 25), steps(0, 180, 37), candela);
}

Web of_symmetry(Symmetry stored, int planes, double last_gamma) {
    std::mt19937 random(2);
    std::vector<double> candela(static_cast<std::size_t>(planes) * 37);
    for (double& cd : candela)
        cd = static_cast<double>(1 + random() % 1000);
    const double last = stored == Symmetry::quadrant ? 90.0 : 180.0;
    return *Web::create(stored, planes == 1 ? std::vector<double>{0.0} : steps(0, last, planes),
                        steps(0, last_gamma, 37), candela);
}

void lookup(benchmark::State& state, const Web& web, int width, int height) {
    for (auto _ : state) {
        Image image(width, height, 1);
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i)
                *image.at(i, j) =
                    static_cast<float>(web.candela((i + 0.5) / width * 360.0, (j + 0.5) / height * 180.0));
        benchmark::DoNotOptimize(image.pixels.data());
    }
    state.SetItemsProcessed(state.iterations() * width * height);
}

void bake(benchmark::State& state, const Web& web, const BakeOptions& options) {
    for (auto _ : state) {
        const Result<Texture> texture = bake_texture(web, options);
        benchmark::DoNotOptimize(texture->image.pixels.data());
    }
    state.SetItemsProcessed(state.iterations() * options.width * options.height);
}

// After the rows, prints how much faster than the look-up each row is, per texel.
class Ratios : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration)
                rates_.emplace_back(run.benchmark_name(), run.counters.at("items_per_second").value);
        ConsoleReporter::ReportRuns(runs);
    }

    void Finalize() override {
        std::printf("\n%-44s %16s %18s\n", "", "M texels/s", "times a look-up");
        const auto rate_of = [&](const std::string& wanted) {
            for (const auto& [name, rate] : rates_)
                if (name == wanted) return rate;
            return 0.0;
        };
        for (const auto& [name, rate] : rates_) {
            double baseline = rate_of(name.substr(0, name.find('/')) + "/lookup");
            if (baseline == 0.0) baseline = rate_of("latlong-1024x512/lookup");
            std::printf("%-44s %16.2f %18.2f\n", name.c_str(), rate * 1e-6, rate / baseline);
        }
        ConsoleReporter::Finalize();
    }

private:
    std::vector<std::pair<std::string, double>> rates_;
};

} // namespace

int main(int argc, char** argv) {
    const Web web = without_symmetry();
    const Web quadrant = of_symmetry(Symmetry::quadrant, 7, 90.0);
    const Web axial = of_symmetry(Symmetry::axial, 1, 90.0);
    const auto add = [](const std::string& name, const Web& of, const BakeOptions& options) {
        benchmark::RegisterBenchmark(name.c_str(),
                                     [&of, options](benchmark::State& state) { bake(state, of, options); });
    };
    BakeOptions options;
    options.threads = 1;
    for (const auto& [width, height] : {std::pair{256, 128}, {1024, 512}, {4096, 2048}}) {
        options.width = width;
        options.height = height;
        const std::string size = std::to_string(width) + "x" + std::to_string(height);
        benchmark::RegisterBenchmark(
            ("latlong-" + size + "/lookup").c_str(),
            [&web, w = width, h = height](benchmark::State& state) { lookup(state, web, w, h); });
        add("latlong-" + size + "/float", web, options);
        if (width != 1024) continue;
        options.texel_type = TexelType::half;
        add("latlong-" + size + "/half", web, options);
        options.normalization = Normalization::peak;
        options.texel_type = TexelType::uint8;
        add("latlong-" + size + "/uint8", web, options);
        options.normalization = Normalization::none;
        options.texel_type = TexelType::float32;
        add("latlong-" + size + "/quadrant", quadrant, options);
        add("latlong-" + size + "/axial", axial, options);
    }
    for (const LayoutInfo& layout : layouts()) {
        if (layout.layout == Layout::latlong || layout.layout == Layout::v180) continue;
        options.layout = layout.layout;
        const TextureSize size = usual_size(layout.layout);
        options.width = size.width;
        options.height = size.height;
        add(std::string(layout.name) + "/float", web, options);
        if (layout.layout != Layout::octahedral) continue;
        add(std::string(layout.name) + "/quadrant", quadrant, options);
        add(std::string(layout.name) + "/axial", axial, options);
        options.skip = false;
        add(std::string(layout.name) + "/axial-no-skip", axial, options);
        options.skip = true;
    }
    benchmark::Initialize(&argc, argv);
    Ratios reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
}
