#include "batch.hpp"

#include <gonio/base/parallel.hpp>

#include "progress.hpp"
#include "unexpected.hpp"

#include <fmt/format.h>

#include <deque>
#include <mutex>
#include <utility>

namespace gonio::cli {

namespace {

// Takes outcomes in any order and prints them in the order of the inputs.
class Narrator {
public:
    Narrator(const Batch& batch, ReportKind kind, Console& console)
        : batch_(batch), kind_(kind), console_(console), progress_(batch.inputs.size(), console.shows_progress()) {}

    void take(std::size_t index, Outcome outcome) {
        const std::scoped_lock lock(mutex_);
        if (index - next_ >= waiting_.size()) waiting_.resize(index - next_ + 1);
        waiting_[index - next_] = std::move(outcome);
        if (waiting_.front().has_value()) progress_.clear();
        for (; !waiting_.empty() && waiting_.front().has_value(); ++next_) {
            say(batch_.inputs[next_], *waiting_.front());
            waiting_.pop_front();
            status_ = console_.flush(status_);
        }
        ++taken_;
        progress_.show(taken_, batch_.inputs[index]);
    }

    int close() {
        progress_.clear();
        const std::size_t count = batch_.inputs.size();
        if (kind_ == ReportKind::json && count != 1) console_.print(reported_ == 0 ? "[]\n" : "\n]\n");
        if (count > 1) console_.note(closing_line(count));
        return status_;
    }

private:
    std::string closing_line(std::size_t count) const {
        if (failed_ + unchanged_ == 0) return fmt::format("{} files {}", count, batch_.done);
        std::string line = fmt::format("{} files: {} {}", count, count - failed_ - unchanged_, batch_.done);
        if (unchanged_ > 0) line += fmt::format(", {} up to date", unchanged_);
        if (failed_ > 0) line += fmt::format(", {} failed", failed_);
        return line;
    }

    void say(const std::string& input, Outcome& outcome) {
        for (const std::string& remark : outcome.remarks)
            console_.remark(remark);
        if (outcome.error) {
            ++failed_;
            name_input(*outcome.error, input);
            status_ = worse(status_, console_.fail(*outcome.error));
            console_.print(outcome.words);
            // A file that could not be read still has its entry in a report of several.
            outcome.report = {{"schema", batch_.schema},
                              {"file", input},
                              {"diagnostics", diagnostics_json(outcome.error->diagnostics)}};
        } else {
            if (outcome.unchanged) ++unchanged_;
            console_.say(outcome.diagnostics);
            status_ = worse(status_, outcome.status);
            console_.print(kind_ == ReportKind::words ? outcome.words : std::string());
        }
        if (outcome.report.is_null()) return;
        if (kind_ == ReportKind::jsonl) console_.print(dump(outcome.report, -1));
        if (kind_ != ReportKind::json) return;
        if (batch_.inputs.size() == 1) {
            console_.print(dump(outcome.report, 2));
        } else {
            // An array, of which each element is written as soon as it is there: a catalogue's is never held as a
            // whole.
            console_.print(reported_++ == 0 ? "[\n  " : ",\n  ");
            console_.print(dump_element(outcome.report));
        }
    }

    // In a batch, a message without a file name would not show which input it is about.
    void name_input(Error& error, const std::string& input) const {
        if (batch_.inputs.size() == 1) return;
        for (Diagnostic& diagnostic : error.diagnostics)
            if (diagnostic.location.file.empty()) diagnostic.location.file = input;
    }

    const Batch& batch_;
    ReportKind kind_;
    Console& console_;
    std::mutex mutex_;
    Progress progress_;
    // From the input to print next up to the last that is done: a catalogue's are never held as a whole.
    std::deque<std::optional<Outcome>> waiting_;
    std::size_t next_ = 0; // the input to print next
    std::size_t taken_ = 0;
    std::size_t failed_ = 0;
    std::size_t unchanged_ = 0;
    int status_ = 0;
    std::size_t reported_ = 0; // elements of the array that were written
};

} // namespace

ReportKind report_kind(const Arguments& arguments) {
    if (arguments.has("--jsonl")) return ReportKind::jsonl;
    return arguments.has("--json") ? ReportKind::json : ReportKind::words;
}

int run_batch(const Batch& batch, ReportKind kind, Console& console, const std::function<Outcome(std::size_t)>& work) {
    Narrator narrator(batch, kind, console);
    // An exception from one input is the error of that input; the others continue.
    const auto outcome_of = [&](std::size_t index) {
        try {
            return work(index);
        } catch (...) {
            Outcome failed;
            failed.error = unexpected_error(batch.inputs[index]);
            return failed;
        }
    };
    parallel_for(batch.inputs.size(), batch.threads,
                 [&](std::size_t index) { narrator.take(index, outcome_of(index)); });
    return narrator.close();
}

} // namespace gonio::cli
