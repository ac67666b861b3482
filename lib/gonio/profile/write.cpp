#include <gonio/profile/write.hpp>

namespace gonio {

namespace {

std::string written(const IesFile& file) {
    return write_ies(file);
}

std::string written(const LdtFile& file) {
    return write_ldt(file);
}

std::string written(const Tm33File& file) {
    return write_tm33(file);
}

} // namespace

std::string write_profile(const Profile& profile) {
    return std::visit([](const auto& file) { return written(file); }, profile.file);
}

std::optional<std::string> write_with_tilt_factors(const Profile& profile) {
    const auto* const ies = std::get_if<IesFile>(&profile.file);
    if (ies == nullptr || ies->tilt.factors.empty() || ies->tilt_keyword == "INCLUDE") return std::nullopt;
    IesFile made = *ies;
    made.tilt_keyword = "INCLUDE";
    return write_ies(made);
}

std::string_view profile_ending(const Profile& profile) {
    return std::holds_alternative<IesFile>(profile.file)   ? "ies"
           : std::holds_alternative<LdtFile>(profile.file) ? "ldt"
                                                           : "xml";
}

} // namespace gonio
