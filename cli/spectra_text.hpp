// The spectra of a profile, and what they say about its light beside what the file states: part of `gonio info
// --figures`.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/light_quality.hpp>
#include <gonio/profile/profile.hpp>

#include "json_text.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace gonio::cli {

struct ProfileSpectrum {
    std::size_t emitter = 0; // in the profile's order
    Tm33Emitter stated;      // without its tables
    LightQuality quality;    // its diagnostics are those of reading the spectrum too
};

// Empty for profiles without spectra. Fails as the readers of spectra do.
Result<std::vector<ProfileSpectrum>> profile_spectra(const Profile& profile);

// A table for each, with a newline at the end of each line.
std::string spectra_text(const std::vector<ProfileSpectrum>& spectra);

Json spectra_json(const std::vector<ProfileSpectrum>& spectra);

} // namespace gonio::cli
