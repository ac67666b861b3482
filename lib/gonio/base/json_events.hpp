// A JSON text as a series of events, for readers that do not keep all of it or have limits.
#pragma once

#include <gonio/base/json.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio::detail {

// What happens in the text, in its order. Reading stops where an event returns false.
class JsonHandler {
public:
    JsonHandler() = default;
    JsonHandler(const JsonHandler&) = delete;
    JsonHandler& operator=(const JsonHandler&) = delete;
    virtual ~JsonHandler() = default;

    virtual bool scalar(Json value) = 0; // null, a boolean, a number or a string
    virtual bool key(std::string name) = 0;
    virtual bool start_object() = 0;
    virtual bool start_array() = 0;
    virtual bool end() = 0; // of the innermost object or array

    // The text is not JSON. The diagnostic has the general code of malformed inputs.
    virtual void broken(Diagnostic complaint) = 0;

protected:
    // Within an event: line and column of the last byte that was read. It ends the token that the event is about, or,
    // for a number, is the byte after it.
    Location place() const;

    // The text that is read, how many bytes of it were read so far, and the line and column of a byte.
    std::string_view text() const { return text_; }
    std::size_t bytes_read() const { return static_cast<std::size_t>(read_ - text_.data()); }
    Location place_at(std::size_t offset) const;

    // Within the event of an opening bracket: goes on at this byte, which is behind it. The places of what follows are
    // right, but for that of broken().
    void skip_to(std::size_t offset) { read_ = text_.data() + offset; }

private:
    friend void read_json(std::string_view text, const std::string& source, bool comments, JsonHandler& handler);

    std::string_view text_;
    const std::string* source_ = nullptr;
    const char* read_ = nullptr;
};

// `comments`: the text may have comments as in C++.
void read_json(std::string_view text, const std::string& source, bool comments, JsonHandler& handler);

} // namespace gonio::detail
