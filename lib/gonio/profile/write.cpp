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

} // namespace gonio
