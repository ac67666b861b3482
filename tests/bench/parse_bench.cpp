// Google Benchmark of the profile readers, over files in memory, on one thread.
//
// How to read it: times vary with the machine; ratios within one run are stable. The baseline of each group is
// `strtod`: the C library's conversion over the number sections of the same files and nothing else, the cost that most
// readers of these formats have. `fast_float` is that library over the same sections, the upper limit for a reader that
// uses it. `read` is read_profile; `resolve` is read_profile followed by resolve_web, which takes over the table.
// `plain` reads number by number, as a reference for tests does; `scalar`, `avx2` and so on are `read` with the kernels
// of one instruction set. Memory management is left to the allocator, including pages that it fetches again. The table
// at the end shows the ratios; rates count whole files.
//
// The group `files` reads 10,000 small files of a folder on all processors: `bytes` only reads their bytes, `resolve`
// reads and resolves them. Its rates count files, and its times are those of the clock.
#include <gonio/base/file.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/token_kernels.hpp>
#include <gonio/web/resolve.hpp>

#include <benchmark/benchmark.h>
#include <fast_float/fast_float.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace gonio;
namespace fs = std::filesystem;

struct File {
    std::string name;
    std::string bytes;       // ends in NUL, which stops strtod
    std::size_t numbers = 0; // where the number section begins
};

using Files = std::vector<File>;

std::size_t behind_lines(std::string_view bytes, std::size_t count) {
    std::size_t at = 0;
    for (; count > 0 && at < bytes.size(); ++at)
        if (bytes[at] == '\n' || (bytes[at] == '\r' && (at + 1 == bytes.size() || bytes[at + 1] != '\n'))) --count;
    return at;
}

// After the TILT line of LM-63; after the lamp sets of EULUMDAT, where every line is one number.
std::size_t number_section(const File& file, const Profile& profile) {
    if (const auto* ldt = std::get_if<LdtFile>(&profile.file))
        return behind_lines(file.bytes, 26 + 6 * ldt->lamp_sets.size());
    std::size_t tilt = file.bytes.find("TILT");
    while (tilt != std::string::npos && tilt > 0 && file.bytes[tilt - 1] != '\n' && file.bytes[tilt - 1] != '\r')
        tilt = file.bytes.find("TILT", tilt + 1);
    if (tilt == std::string::npos) return 0;
    return tilt + behind_lines(std::string_view(file.bytes).substr(tilt), 1);
}

Files files_of(const fs::path& folder, const std::string& extension) {
    Files files;
    if (!fs::is_directory(folder)) return files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != extension) continue;
        Result<std::string> bytes = read_file(entry.path().string());
        if (!bytes) continue;
        File file{entry.path().string(), std::move(*bytes), 0};
        const Result<Profile> profile = read_profile(file.bytes, file.name);
        if (!profile) continue;
        file.numbers = number_section(file, *profile);
        files.push_back(std::move(file));
    }
    std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.name < b.name; });
    return files;
}

std::int64_t bytes_of(const Files& files) {
    std::int64_t sum = 0;
    for (const File& file : files)
        sum += static_cast<std::int64_t>(file.bytes.size());
    return sum;
}

bool separates(char c) {
    return c == ' ' || c == ',' || (c >= '\t' && c <= '\r');
}

void with_strtod(benchmark::State& state, const Files& files) {
    for (auto _ : state)
        for (const File& file : files) {
            const char* at = file.bytes.c_str() + file.numbers;
            const char* const end = file.bytes.c_str() + file.bytes.size();
            double sum = 0.0;
            while (at < end) {
                char* stop = nullptr;
                sum += std::strtod(at, &stop);
                at = stop == at ? at + 1 : stop;
            }
            benchmark::DoNotOptimize(sum);
        }
    state.SetBytesProcessed(state.iterations() * bytes_of(files));
}

void with_fast_float(benchmark::State& state, const Files& files) {
    for (auto _ : state)
        for (const File& file : files) {
            const char* at = file.bytes.data() + file.numbers;
            const char* const end = file.bytes.data() + file.bytes.size();
            double sum = 0.0;
            for (;;) {
                while (at < end && separates(*at))
                    ++at;
                if (at >= end) break;
                double value = 0.0;
                const fast_float::from_chars_result read = fast_float::from_chars(at, end, value);
                sum += value;
                at = read.ptr == at ? at + 1 : read.ptr;
            }
            benchmark::DoNotOptimize(sum);
        }
    state.SetBytesProcessed(state.iterations() * bytes_of(files));
}

void only_read(benchmark::State& state, const Files& files) {
    for (auto _ : state)
        for (const File& file : files) {
            const Result<Profile> profile = read_profile(file.bytes, file.name);
            benchmark::DoNotOptimize(&profile);
        }
    state.SetBytesProcessed(state.iterations() * bytes_of(files));
}

void read_with(benchmark::State& state, const Files& files, const profile_detail::TokenKernels* kernels) {
    const profile_detail::UseTokenKernels use(kernels);
    only_read(state, files);
}

void read_and_resolve(benchmark::State& state, const Files& files) {
    for (auto _ : state)
        for (const File& file : files) {
            Result<Profile> profile = read_profile(file.bytes, file.name);
            const Result<ResolvedWeb> web = resolve_web(std::move(*profile));
            benchmark::DoNotOptimize(&web);
        }
    state.SetBytesProcessed(state.iterations() * bytes_of(files));
}

// Prints the ratios of the rows after them.
class Ratios : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration) {
                double& best = seconds_[run.benchmark_name()];
                const double time = run.cpu_accumulated_time / static_cast<double>(run.iterations);
                best = best == 0.0 ? time : std::min(best, time);
            }
        ConsoleReporter::ReportRuns(runs);
    }

    void Finalize() override {
        std::printf("\n%-28s %12s\n", "times as fast as strtod", "");
        for (const auto& [name, time] : seconds_) {
            const std::string group = name.substr(0, name.find('/'));
            const auto baseline = seconds_.find(group + "/strtod");
            if (baseline != seconds_.end() && name != baseline->first)
                std::printf("%-28s %12.2f\n", name.c_str(), baseline->second / time);
        }
        ConsoleReporter::Finalize();
    }

private:
    std::map<std::string, double> seconds_;
};

void register_group(const std::string& group, const Files& files) {
    if (files.empty()) {
        std::fprintf(stderr, "%s: no files, left out\n", group.c_str());
        return;
    }
    const auto add = [&](const char* row, void (*run)(benchmark::State&, const Files&)) {
        benchmark::RegisterBenchmark((group + "/" + row).c_str(),
                                     [run, &files](benchmark::State& state) { run(state, files); });
    };
    add("strtod", with_strtod);
    add("fast_float", with_fast_float);
    add("read", only_read);
    add("resolve", read_and_resolve);
    const auto add_with = [&](const std::string& row, const profile_detail::TokenKernels* kernels) {
        benchmark::RegisterBenchmark((group + "/" + row).c_str(),
                                     [kernels, &files](benchmark::State& state) { read_with(state, files, kernels); });
    };
    add_with("plain", nullptr);
    for (const simd::InstructionSet set : simd::available_sets())
        add_with(simd::to_text(set), &profile_detail::token_kernels(set));
}

// --- Many small files.

// A folder of the authored profiles of about 5 KB, again and again; removed at the end.
class SmallFiles {
public:
    static constexpr std::size_t count = 10000;

    explicit SmallFiles(const Files& from) : folder_(fs::temp_directory_path() / "gonio-bench-parse-files") {
        Files small;
        for (const File& file : from)
            if (file.bytes.size() > 3500 && file.bytes.size() < 8000) small.push_back(file);
        if (small.empty()) return;
        fs::create_directories(folder_);
        for (std::size_t i = 0; i < count; ++i) {
            const File& file = small[i % small.size()];
            paths_.push_back((folder_ / (std::to_string(i) + fs::path(file.name).extension().string())).string());
            std::ofstream(paths_.back(), std::ios::binary) << file.bytes;
        }
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;
    ~SmallFiles() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    const std::vector<std::string>& paths() const { return paths_; }

private:
    fs::path folder_;
    std::vector<std::string> paths_;
};

template<class Work>
void register_files(const char* row, const SmallFiles& files, Work work) {
    benchmark::RegisterBenchmark(row, [&files, work](benchmark::State& state) {
        for (auto _ : state)
            parallel_for(files.paths().size(), 0, [&](std::size_t i) { work(files.paths()[i]); });
        state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(files.paths().size()));
    })->UseRealTime();
}

Files largest_of(const Files& files) {
    const auto largest = std::max_element(files.begin(), files.end(),
                                          [](const File& a, const File& b) { return a.bytes.size() < b.bytes.size(); });
    return largest == files.end() ? Files{} : Files{*largest};
}

} // namespace

int main(int argc, char** argv) {
    const fs::path corpus = fs::path(GONIO_TEST_CORPUS) / "good";
    const fs::path authored = fs::path(GONIO_TEST_SOURCE) / "profiles";
    const Files corpus_ies = files_of(corpus, ".ies");
    const Files corpus_ldt = files_of(corpus, ".ldt");
    const Files authored_ies = files_of(authored, ".ies");
    const Files authored_ldt = files_of(authored, ".ldt");
    const Files largest_ies = largest_of(corpus_ies);
    const Files largest_ldt = largest_of(corpus_ldt);
    register_group("corpus-ies", corpus_ies);
    register_group("corpus-ldt", corpus_ldt);
    register_group("largest-ies", largest_ies);
    register_group("largest-ldt", largest_ldt);
    register_group("authored-ies", authored_ies);
    register_group("authored-ldt", authored_ldt);
    const SmallFiles small(authored_ies);
    if (!small.paths().empty()) {
        register_files("files/bytes", small, [](const std::string& path) {
            const Result<std::string> bytes = read_file(path);
            benchmark::DoNotOptimize(&bytes);
        });
        register_files("files/resolve", small, [](const std::string& path) {
            Result<Profile> profile = read_profile_file(path);
            if (!profile) return;
            const Result<ResolvedWeb> web = resolve_web(std::move(*profile));
            benchmark::DoNotOptimize(&web);
        });
    }
    benchmark::Initialize(&argc, argv);
    Ratios reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
}
