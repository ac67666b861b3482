// The HTML of a report, made of its parts.
#pragma once

#include "interactive_page.hpp"
#include "profile_section.hpp"
#include "rig_section.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gonio::cli {

enum class Paper { a4, letter };

struct ReportParts {
    std::string title;
    Paper paper = Paper::a4;
    std::string remark; // about the whole report, such as missing pictures; may be empty
    std::span<const ProfilePart> profiles;
    std::span<const std::string> names; // of the profiles, for the interactive page
    const RigPart* rig = nullptr;
    const InteractivePage* page = nullptr;
};

// One file that needs no other. Equal parts give equal bytes.
std::string report_html(const ReportParts& parts);

} // namespace gonio::cli
