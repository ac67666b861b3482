#include <gonio/base/parallel.hpp>
#include <gonio/base/stop.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

namespace gonio {

namespace {

// Threads that loops have yet to start: a caller that asks for its own threads meanwhile must not count on these.
std::atomic<unsigned> threads_to_come{0};

thread_local const std::atomic<bool>* stop_flag = nullptr; // of this thread's StopLoops

// Threads that are joined at the end of the scope. (Not every standard library has std::jthread.)
class Pool {
public:
    Pool() = default;
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    ~Pool() {
        for (std::thread& thread : threads_)
            thread.join();
    }

    void reserve(std::size_t count) { threads_.reserve(count); }
    template<class Work>
    void start(Work&& work) {
        threads_.emplace_back(std::forward<Work>(work));
    }

private:
    std::vector<std::thread> threads_;
};

} // namespace

StopLoops::StopLoops(const std::atomic<bool>& flag) : before_(stop_flag) {
    stop_flag = &flag;
}

StopLoops::~StopLoops() {
    stop_flag = before_;
}

unsigned available_threads() {
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
    return 1; // hardware_concurrency() counts the machine, but none can be started
#else
#if defined(__linux__)
    // hardware_concurrency() counts the machine; a container or taskset may have given us less.
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) {
        const int count = CPU_COUNT(&set);
        if (count > 0) return static_cast<unsigned>(count);
    }
#endif
    return std::max(1U, std::thread::hardware_concurrency());
#endif
}

bool can_start_threads(unsigned count) {
    std::atomic<bool> over{false};
    bool all = true;
    {
        Pool pool;
        try {
            const unsigned all_told = count + threads_to_come.load();
            pool.reserve(all_told);
            for (unsigned t = 0; t < all_told; ++t)
                pool.start([&over] { over.wait(false); });
        } catch (const std::exception&) {
            all = false;
        }
        over.store(true);
        over.notify_all();
    }
    return all;
}

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
    if (threads == 0) threads = available_threads();
    const auto helpers = static_cast<unsigned>(std::min<std::size_t>(threads, count));
    if (helpers <= 1) {
        for (std::size_t i = 0; i < count; ++i) {
            if (stop_flag != nullptr && *stop_flag) throw LoopsStopped();
            work(i);
        }
        return;
    }

    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto drain = [&, stop = stop_flag] {
        for (std::size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) {
            try {
                if (stop != nullptr && *stop) throw LoopsStopped();
                work(i);
            } catch (...) {
                const std::scoped_lock lock(failure_mutex);
                if (!failure) failure = std::current_exception();
                next.store(count);
            }
        }
    };
    {
        Pool pool;
        pool.reserve(helpers - 1);
        unsigned to_come = helpers - 1;
        threads_to_come.fetch_add(to_come);
        try {
            for (; to_come > 0; --to_come) {
                pool.start(drain);
                threads_to_come.fetch_sub(1);
            }
        } catch (const std::exception&) {
            // No more threads, or no memory for their stacks: those that were started do the work.
            threads_to_come.fetch_sub(to_come);
        }
        drain();
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace gonio
