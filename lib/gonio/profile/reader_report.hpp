// Report: the diagnostics of a reader about one file, each with its place. Internal to the profile room.
//
// A reader works with byte offsets; line and column are computed when something is reported. Only the first occurrence
// of each code is kept and the others are counted: a file with ten thousand negative values gives one sentence.
#pragma once

#include <gonio/base/codes/profile.hpp>
#include <gonio/base/result.hpp>
#include <gonio/profile/field_places.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::profile_detail {

// "the whole file": no line and column are given.
inline constexpr std::size_t no_place = static_cast<std::size_t>(-1);

class Report {
public:
    // `bytes` is the whole file, byte order mark included; offsets count from its start.
    Report(std::string_view bytes, std::string source, bool strict);

    // Reports it with the severity that the table gives to the code.
    void add(ProfileCode code, std::size_t offset, const char* message, const char* hint = "");
    void add(ProfileCode code, std::size_t offset, const std::string& message, const std::string& hint = {});

    // Reports it and returns the failure of the whole reading, with everything reported before.
    Unexpected fail(ProfileCode code, std::size_t offset, const char* message, const char* hint = "");
    Unexpected fail(ProfileCode code, std::size_t offset, const std::string& message, const std::string& hint = {},
                    Failure failure = Failure::malformed);

    // Adds the diagnostics of another file that this one refers to, after everything else.
    void add_of_other(Diagnostics diagnostics);

    // The failure of the whole reading because of the other file's diagnostics; the last of them is the error.
    Unexpected fail_of_other(Diagnostics diagnostics);

    // Stores the place of a field; `no_place` if it is missing.
    void mark(ProfileField field, std::size_t offset) { marks_[static_cast<std::size_t>(field)] = offset; }

    // Line and column of every field that was marked.
    [[nodiscard]] FieldPlaces places() const;

    // Whether anything reported so far is an error, which happens only under `strict`.
    [[nodiscard]] bool has_error() const { return has_error_; }

    // The failure made of the diagnostics so far; for has_error().
    Unexpected failure();

    Diagnostics take();

    [[nodiscard]] bool strict() const { return strict_; }
    [[nodiscard]] std::string_view bytes() const { return bytes_; }
    [[nodiscard]] const std::string& source() const { return source_; }

private:
    [[nodiscard]] Location locate(std::size_t offset) const;
    void close_counts();
    void order();

    std::string_view bytes_;
    std::string source_;
    Diagnostics diagnostics_;
    Diagnostics of_other_;
    std::vector<std::size_t> repeats_; // per diagnostic
    std::array<std::size_t, profile_field_count> marks_;
    bool strict_;
    bool has_error_ = false;
};

} // namespace gonio::profile_detail
