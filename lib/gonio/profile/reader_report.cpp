#include <gonio/profile/reader_report.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <utility>

namespace gonio::profile_detail {

namespace {

// Line and column of ascending offsets. A line ends with CR LF, LF or CR: all three may occur within one file.
class LineCounter {
public:
    explicit LineCounter(std::string_view bytes) : bytes_(bytes) {}

    FieldPlace at(std::size_t offset) {
        offset = std::min(offset, bytes_.size());
        if constexpr (std::endian::native == std::endian::little)
            while (next_ + 8 <= offset && next_ + 8 < bytes_.size())
                take_eight();
        for (; next_ < offset; ++next_) {
            const char c = bytes_[next_];
            const bool cr_of_crlf = c == '\r' && next_ + 1 < bytes_.size() && bytes_[next_ + 1] == '\n';
            if (c == '\n' || (c == '\r' && !cr_of_crlf)) {
                ++line_;
                line_start_ = next_ + 1;
            }
        }
        return {line_, static_cast<std::uint32_t>(offset - line_start_ + 1)};
    }

private:
    // Eight bytes, each a high bit where a line ends; a ninth follows them.
    void take_eight() {
        constexpr std::uint64_t high = 0x8080808080808080U;
        std::uint64_t word = 0;
        std::memcpy(&word, bytes_.data() + next_, sizeof word);
        const auto equals = [&](std::uint64_t eight_times) {
            const std::uint64_t x = word ^ eight_times;
            return ~(((x & ~high) + ~high) | x) & high;
        };
        const std::uint64_t lf = equals(0x0A0A0A0A0A0A0A0AU);
        const std::uint64_t cr = equals(0x0D0D0D0D0D0D0D0DU);
        const std::uint64_t lf_behind = lf >> 8U | (bytes_[next_ + 8] == '\n' ? std::uint64_t{1} << 63U : 0);
        const std::uint64_t ends = lf | (cr & ~lf_behind);
        if (ends != 0) {
            line_ += static_cast<std::uint32_t>((ends >> 7U) * 0x0101010101010101U >> 56U);
            line_start_ = next_ + 8 - static_cast<std::size_t>(std::countl_zero(ends)) / 8;
        }
        next_ += 8;
    }

    std::string_view bytes_;
    std::size_t next_ = 0; // everything before it is counted
    std::size_t line_start_ = 0;
    std::uint32_t line_ = 1;
};

} // namespace

Report::Report(std::string_view bytes, std::string source, bool strict)
    : bytes_(bytes), source_(std::move(source)), strict_(strict) {
    marks_.fill(no_place);
}

Location Report::locate(std::size_t offset) const {
    if (offset == no_place) return {source_, 0, 0};
    const FieldPlace place = LineCounter(bytes_).at(offset);
    return {source_, place.line, place.column};
}

FieldPlaces Report::places() const {
    // In the order of the file, by insertion: fields are nearly in that order.
    std::array<std::size_t, profile_field_count> order{};
    std::size_t count = 0;
    for (std::size_t field = 0; field < profile_field_count; ++field) {
        if (marks_[field] == no_place) continue;
        std::size_t at = count++;
        for (; at > 0 && marks_[order[at - 1]] > marks_[field]; --at)
            order[at] = order[at - 1];
        order[at] = field;
    }
    FieldPlaces places;
    LineCounter lines(bytes_);
    for (std::size_t i = 0; i < count; ++i)
        places[static_cast<ProfileField>(order[i])] = lines.at(marks_[order[i]]);
    return places;
}

void Report::add(ProfileCode code, std::size_t offset, const char* message, const char* hint) {
    add(code, offset, std::string(message), hint);
}

void Report::add(ProfileCode code, std::size_t offset, const std::string& message, const std::string& hint) {
    if (code->strict == Strict::only && !strict_) return;
    const auto said = std::find_if(diagnostics_.begin(), diagnostics_.end(),
                                   [&](const Diagnostic& d) { return d.code == code->code; });
    if (said != diagnostics_.end()) {
        ++repeats_[static_cast<std::size_t>(said - diagnostics_.begin())];
        return;
    }
    const Severity severity = strict_ ? code->strict_severity() : code->severity;
    has_error_ = has_error_ || severity == Severity::error;
    diagnostics_.push_back({std::string(code->code), severity, locate(offset), message, hint});
    repeats_.push_back(0);
}

// In the order of the file; reports about the whole file come first.
void Report::order() {
    close_counts();
    std::stable_sort(diagnostics_.begin(), diagnostics_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.location.line, a.location.column) < std::pair(b.location.line, b.location.column);
    });
    std::move(of_other_.begin(), of_other_.end(), std::back_inserter(diagnostics_));
    of_other_.clear();
}

void Report::add_of_other(Diagnostics diagnostics) {
    std::move(diagnostics.begin(), diagnostics.end(), std::back_inserter(of_other_));
}

Unexpected Report::fail_of_other(Diagnostics diagnostics) {
    add_of_other(std::move(diagnostics));
    order();
    return Unexpected(Error{Failure::malformed, std::move(diagnostics_)});
}

Unexpected Report::fail(ProfileCode code, std::size_t offset, const char* message, const char* hint) {
    return fail(code, offset, std::string(message), hint);
}

Unexpected Report::fail(ProfileCode code, std::size_t offset, const std::string& message, const std::string& hint,
                        Failure failure) {
    order();
    diagnostics_.push_back({std::string(code->code), Severity::error, locate(offset), message, hint});
    return Unexpected(Error{failure, std::move(diagnostics_)});
}

Unexpected Report::failure() {
    // The reason of an Error is its last error: warnings that came later move before it.
    order();
    std::stable_partition(diagnostics_.begin(), diagnostics_.end(),
                          [](const Diagnostic& d) { return d.severity != Severity::error; });
    return Unexpected(Error{Failure::malformed, std::move(diagnostics_)});
}

Diagnostics Report::take() {
    order();
    return std::move(diagnostics_);
}

void Report::close_counts() {
    for (std::size_t i = 0; i < diagnostics_.size() && i < repeats_.size(); ++i)
        if (repeats_[i] > 0) diagnostics_[i].message += " (and " + std::to_string(repeats_[i]) + " more)";
    repeats_.assign(diagnostics_.size(), 0);
}

} // namespace gonio::profile_detail
