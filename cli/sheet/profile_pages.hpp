// The pages of a profile.
#pragma once

#include <gonio/plot/data_sheet.hpp>

#include "../options/profile_input.hpp"

#include <string>

namespace gonio::cli {

// What a sheet says of the whole file, and its pages.
struct ProfilePages {
    std::string name; // of the luminaire; as the file has it
    std::string maker;
    DataSheet sheet;
};

ProfilePages profile_pages(const std::string& file, const LoadedProfile& loaded, const ResolveOptions& resolve,
                           const DataSheetOptions& options);

} // namespace gonio::cli
