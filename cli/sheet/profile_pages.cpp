#include "profile_pages.hpp"

#include <gonio/base/path.hpp>
#include <gonio/web/profile_header.hpp>

#include <string_view>
#include <utility>

namespace gonio::cli {

ProfilePages profile_pages(const std::string& file, const LoadedProfile& loaded, const ResolveOptions& resolve,
                           const DataSheetOptions& options) {
    const ProfileHeader header = header_of(loaded.profile, resolve);
    const auto text = [&](std::string_view keyword) { return std::string(keyword_text(header, keyword)); };
    DataSheetContent content;
    content.file = file == "-" ? "stdin" : file_name(file);
    content.name = text("LUMINAIRE");
    content.maker = text("MANUFAC");
    content.catalogue_number = text("LUMCAT");
    content.cct = text("_CCT");
    content.cri = text("_CRI");
    content.report = text("TEST");
    content.date = text("ISSUEDATE");
    if (content.date.empty()) content.date = text("DATE");
    content.web = &loaded.web;
    content.opening = opening_of(loaded.profile);
    content.facts = profile_facts(loaded.profile, loaded.web, resolve);
    content.figures = luminaire_figures(loaded.profile, loaded.web, resolve);
    ProfilePages pages;
    pages.sheet = data_sheet(content, options);
    pages.name = content.name.empty() ? content.catalogue_number : content.name;
    if (pages.name.empty()) pages.name = content.file;
    pages.maker = std::move(content.maker);
    return pages;
}

} // namespace gonio::cli
