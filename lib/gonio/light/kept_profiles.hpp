// Profiles that were read, for those who read the same files again and again: pictures one after another.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/web/web.hpp>

#include <map>
#include <memory>
#include <string>

namespace gonio::detail {

// What load_profile() takes from a file.
struct LoadedWeb {
    std::shared_ptr<const Web> web;
    std::shared_ptr<const Opening> opening;
    Diagnostics diagnostics;
};

// By file name; the files must not change meanwhile.
using KeptProfiles = std::map<std::string, LoadedWeb>;

// While it lives, load_profile() on this thread reads no file that is in `kept`, and adds what it reads.
class KeepingProfiles {
public:
    explicit KeepingProfiles(KeptProfiles& kept);
    KeepingProfiles(const KeepingProfiles&) = delete;
    KeepingProfiles& operator=(const KeepingProfiles&) = delete;
    ~KeepingProfiles();

private:
    KeptProfiles* before_;
};

} // namespace gonio::detail
