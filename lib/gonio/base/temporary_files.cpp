#include <gonio/base/detail/temporary_files.hpp>
#include <gonio/base/file_set.hpp>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <pthread.h>
#include <unistd.h>

namespace gonio {

namespace detail {

namespace {

static_assert(std::atomic<int>::is_always_lock_free && std::atomic<Temporary*>::is_always_lock_free,
              "a signal's handler may only touch what has no lock");

std::atomic<Temporary*> first{nullptr};
std::atomic<unsigned> last_number{0};
std::atomic<bool> closed{false}; // the process is ending: no more temporary files

Temporary& take_entry() {
    for (Temporary* entry = first.load(); entry != nullptr; entry = entry->next.load()) {
        int expected = Temporary::free;
        if (entry->state.compare_exchange_strong(expected, Temporary::opening)) return *entry;
    }
    auto* const entry = new Temporary; // NOLINT(cppcoreguidelines-owning-memory): entries live as long as the process
    entry->state = Temporary::opening;
    Temporary* head = first.load();
    do
        entry->next = head;
    while (!first.compare_exchange_weak(head, entry));
    return *entry;
}

// While this object lives, no handler runs on this thread: a handler that waits for an opening file would wait for
// ever.
class SignalsHeld {
public:
    SignalsHeld() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    sigset_t before_{};
};

} // namespace

Temporary* make_temporary(int folder, const std::function<bool(const char* name)>& make) {
    const SignalsHeld held;
    Temporary& entry = take_entry();
    entry.folder = folder;
    bool made = false;
    int error = EINTR;
    // Skips files left by a killed process with the same number.
    for (int attempt = 0; attempt < 100 && !made && !closed.load(); ++attempt) {
        (void)std::snprintf(entry.name.data(), entry.name.size(), ".gonio-%d-%u.tmp", static_cast<int>(::getpid()),
                            last_number.fetch_add(1));
        made = make(entry.name.data());
        error = errno;
        if (!made && error != EEXIST) break;
    }
    entry.state = made ? Temporary::there : Temporary::free;
    errno = error;
    return made ? &entry : nullptr;
}

void forget(Temporary& temporary) {
    temporary.state = Temporary::free;
}

void discard(Temporary& temporary) {
    ::unlinkat(temporary.folder, temporary.name.data(), 0);
    forget(temporary);
}

} // namespace detail

void remove_temporary_files() noexcept {
    using detail::Temporary;
    const int error = errno;
    detail::closed = true;
    for (Temporary* entry = detail::first.load(); entry != nullptr; entry = entry->next.load()) {
        // Another thread is about to open it; that takes no longer than the file system does.
        for (int wait = 0; wait < 1000 && entry->state.load() == Temporary::opening; ++wait) {
            const timespec millisecond{0, 1'000'000};
            ::nanosleep(&millisecond, nullptr);
        }
        if (entry->state.load() == Temporary::there) ::unlinkat(entry->folder, entry->name.data(), 0);
    }
    errno = error;
}

} // namespace gonio
