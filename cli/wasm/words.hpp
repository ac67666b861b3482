// The words of a command line from an array of JavaScript.
#pragma once

#include <emscripten/val.h>
#include <span>
#include <string>
#include <vector>

namespace gonio::cli {

class Words {
public:
    explicit Words(const emscripten::val& list) : words_(emscripten::vecFromJSArray<std::string>(list)) {
        for (std::string& word : words_)
            pointers_.push_back(word.data());
    }

    // They live as long as this.
    std::span<char* const> pointers() { return pointers_; }

private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

} // namespace gonio::cli
