#include "sweep_files.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/folder.hpp>

#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "picture.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

// "03-cct-2000K.png": sorts in order by name, and is valid on every file system.
std::string file_of(const Sweep& sweep, std::size_t cell, const std::string& folder, std::string_view extension) {
    std::string name;
    for (std::size_t a = 0; a < sweep.axes.size(); ++a)
        name += (a > 0 ? "_" : "") + sweep.axes[a].label(sweep.value_of(cell, a));
    for (char& c : name) {
        const bool plain =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' || c == '_';
        if (!plain) c = '-';
    }
    const std::size_t digits = std::to_string(sweep.cells() - 1).size();
    return fmt::format("{}/{:0{}}-{}.{}", folder, cell, digits, name.substr(0, 120), extension);
}

} // namespace

Result<std::vector<std::string>> plan_sweep_files(const Arguments& arguments, const Sweeper& sweeper) {
    const std::string folder = arguments.value("--output-dir").value_or("");
    if (!is_folder(folder)) return fail(Failure::io, "is not a folder", "create it first", folder);
    FilesInUse in_use(sweeper.request().lights.files);
    std::vector<std::string> files;
    for (std::size_t cell = 0; cell < sweeper.sweep().cells(); ++cell) {
        files.push_back(file_of(sweeper.sweep(), cell, folder, sweeper.request().format->extensions.front()));
        if (Result<void> free = in_use.take(files.back()); !free) return pass_on(free);
        if (!arguments.has("--overwrite") && file_exists(files.back()))
            return fail("USE0108", "already exists", "add --overwrite to replace it", files.back());
    }
    return files;
}

Result<void> make_sweep_files(Sweeper& sweeper, const std::vector<std::string>& files, const Console& console) {
    const RenderOptions& size = sweeper.request().render;
    return sweeper.render_all(size.width, size.height, [&](Cell cell, std::size_t index) -> Result<void> {
        Result<EncodedPicture> picture = encode_picture(std::move(cell.rendering), cell.request, cell.lights, console);
        if (!picture) return pass_on(picture);
        sweeper.cells_json().back()["file"] = files[index];
        return write_output(files[index], picture->bytes);
    });
}

} // namespace gonio::cli
