#include <gonio/base/parallel.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace gonio {
namespace {

TEST(ThreadsParallel, EveryPieceRunsOnce) {
    for (const unsigned threads : {0U, 1U, 2U, 7U}) {
        std::vector<int> runs(1000, 0);
        parallel_for(runs.size(), threads, [&](std::size_t i) { ++runs[i]; });
        EXPECT_EQ(runs, std::vector<int>(1000, 1)) << threads;
    }
    parallel_for(0, 4, [](std::size_t) { FAIL(); });
}

// Runs in a process of another user that may not start more threads; root has no limit.
int in_limited_process() {
    constexpr unsigned nobody = 61234;
    const rlimit none{1, 1};
    if (::setgid(nobody) != 0 || ::setuid(nobody) != 0 || ::setrlimit(RLIMIT_NPROC, &none) != 0) return 2;
    if (can_start_threads(1)) return 3;
    std::vector<int> runs(1000, 0);
    parallel_for(runs.size(), 8, [&](std::size_t i) { ++runs[i]; });
    return runs == std::vector<int>(1000, 1) ? 0 : 4;
}

TEST(ThreadsParallel, WithoutThreadsTheCallerDoesAll) {
    EXPECT_TRUE(can_start_threads(0));
    EXPECT_TRUE(can_start_threads(5));
    if (::geteuid() != 0) GTEST_SKIP() << "needs root, to become a user who is bound by a limit";
    EXPECT_EXIT(std::_Exit(in_limited_process()), testing::ExitedWithCode(0), "");
}

TEST(ThreadsParallel, AnExceptionReachesTheCallerAndStopsTheRest) {
    std::atomic<int> runs{0};
    // The other calls take long enough for the throwing thread to get time while they run: on a busy machine that
    // thread may be stopped for longer than a million empty calls take.
    const auto work = [&](std::size_t i) {
        ++runs;
        if (i == 3) throw std::runtime_error("three");
        std::this_thread::sleep_for(std::chrono::microseconds(50));
    };
    EXPECT_THROW(parallel_for(1000000, 4, work), std::runtime_error);
    EXPECT_LT(runs.load(), 1000000);
}

} // namespace
} // namespace gonio
