#include "profile_input.hpp"

#include <gonio/base/archive.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/smooth.hpp>

#include "smooth_step.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <utility>

namespace gonio::cli {

namespace {

// Many formats are XML. A file that cannot be read is kept: reading it reports why.
bool is_other_xml(const std::string& file) {
    constexpr std::size_t looked_at = 8192;
    if (!ends_with_any_case(file, ".xml")) return false;
    const Result<std::string> start = read_file_start(file, looked_at);
    return start && !begins_as_tm33(*start);
}

Result<void> add_input(const std::string& name, std::vector<std::string>& files) {
    if (!is_folder(name)) {
        files.push_back(name);
        return {};
    }
    Result<std::vector<std::string>> inside = files_in(name, profile_extensions);
    if (!inside) return pass_on(inside);
    std::erase_if(*inside, is_other_xml);
    if (inside->empty())
        return fail("USE0104", "the folder holds no profiles",
                    fmt::format("profiles end in .{}; XML files must be TM-33", fmt::join(profile_extensions, ", .")),
                    name);
    files.insert(files.end(), std::make_move_iterator(inside->begin()), std::make_move_iterator(inside->end()));
    return {};
}

Result<void> add_list(const std::string& list, std::vector<std::string>& files) {
    Result<std::string> names =
        list == "-" ? read_standard_input(limit("list-bytes")) : read_file(list, limit("list-bytes"));
    if (!names) return pass_on(names);
    std::string_view rest = *names;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        std::string_view line = rest.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (!line.empty()) {
            Result<void> added = add_input(std::string(line), files);
            if (!added) return added;
        }
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return {};
}

} // namespace

Result<ProfileInputOptions> profile_input(const Arguments& arguments) {
    ProfileInputOptions options;
    // The content alone shows that a file is GLDF.
    if (const auto format = arguments.value("--from"); format && *format != "gldf") {
        constexpr std::array formats{Named{"ies", ProfileFormat::ies}, Named{"ldt", ProfileFormat::ldt},
                                     Named{"tm33", ProfileFormat::tm33}};
        Result<ProfileFormat> named = find_value("format", *format, formats);
        if (!named) return pass_on(named);
        options.read.format = *named;
    }
    options.read.strict = arguments.has("--strict");
    options.resolve.as_candela = arguments.has("--as-candela");
    options.read.choice = {arguments.value("--variant").value_or(""), arguments.value("--emitter").value_or("")};
    if (const auto text = arguments.value("--lamp-set")) {
        const char* const end = text->data() + text->size();
        const auto [stop, error] = std::from_chars(text->data(), end, options.resolve.lamp_set);
        if (error != std::errc() || stop != end || options.resolve.lamp_set < 1)
            return fail("USE0105", fmt::format("--lamp-set takes a number of 1 or more, not '{}'", *text));
    }
    if (const auto name = arguments.value("--azimuth")) {
        constexpr std::array conventions{Named{"ies", AzimuthConvention::lm63},
                                         Named{"eulumdat", AzimuthConvention::eulumdat}};
        Result<AzimuthConvention> named = find_value("azimuth", *name, conventions);
        if (!named) return pass_on(named);
        options.resolve.azimuth = *named;
    }
    Result<std::optional<double>> smooth = smooth_step(arguments);
    if (!smooth) return pass_on(smooth);
    options.smooth_deg = *smooth;
    if (const auto text = arguments.value("--tilt")) {
        Result<double> tilt = parse_amount(*text, Dimension::angle, "--tilt");
        if (!tilt) return pass_on(tilt);
        options.resolve.tilt_deg = to_degrees(Radians(*tilt));
    }
    return options;
}

std::string recipe_of(const ProfileInputOptions& options) {
    const ResolveOptions& resolve = options.resolve;
    std::string text;
    if (options.read.format) text += fmt::format(" from={}", to_text(*options.read.format));
    if (!options.read.choice.variant.empty()) text += fmt::format(" variant={}", options.read.choice.variant);
    if (!options.read.choice.emitter.empty()) text += fmt::format(" emitter={}", options.read.choice.emitter);
    if (options.read.strict) text += " strict";
    if (resolve.as_candela) text += " as-candela";
    if (resolve.lamp_set != 1) text += fmt::format(" lamp-set={}", resolve.lamp_set);
    if (resolve.tilt_deg != 0.0) text += fmt::format(" tilt={}deg", resolve.tilt_deg);
    if (resolve.azimuth == AzimuthConvention::lm63) text += " azimuth=ies";
    if (resolve.azimuth == AzimuthConvention::eulumdat) text += " azimuth=eulumdat";
    if (options.smooth_deg) text += fmt::format(" smooth={}deg", *options.smooth_deg);
    return text;
}

Result<std::vector<std::string>> input_files(const Arguments& arguments) {
    std::vector<std::string> files;
    for (const std::string& word : arguments.positional()) {
        Result<void> added = word.starts_with('@') ? add_list(word.substr(1), files) : add_input(word, files);
        if (!added) return pass_on(added);
    }
    if (files.empty()) return fail("USE0104", "no input file is given", "name one, or '-' for stdin");
    return files;
}

std::string_view luminaire_name(const ProfileHeader& header) {
    const std::string_view name = keyword_text(header, "LUMINAIRE");
    return name.empty() ? keyword_text(header, "LUMCAT") : name;
}

Result<LoadedProfile> load(const std::string& file, const ProfileInputOptions& options) {
    Result<std::string> bytes =
        file == "-" ? read_standard_input(limit("archive-bytes")) : read_file(file, limit_of_profile(file));
    if (!bytes) return pass_on(bytes);
    return load_bytes(std::move(*bytes), file, options);
}

Result<LoadedProfile> load_bytes(std::string bytes, const std::string& file, const ProfileInputOptions& options) {
    const Limit& most = is_archive(bytes) ? limit("archive-bytes") : limit("profile-bytes");
    if (bytes.size() > most.value)
        return fail("FIL0104", fmt::format("larger than {}", to_text(most)), std::string(limits_hint), file);
    if (!is_archive(bytes) && !(options.read.choice.variant.empty() && options.read.choice.emitter.empty()))
        return fail("USE0107", "--variant and --emitter are for GLDF", "leave them out", file);
    ReadOptions read = options.read;
    if (file != "-") read.read_beside = reader_beside(file);
    Result<Profile> profile = read_profile(bytes, file, read);
    if (!profile) return pass_on(profile);
    if (options.photometric && !options.resolve.as_candela)
        if (Result<void> checked = require_candela(*profile, "add --as-candela to take its numbers as candela");
            !checked)
            return pass_on(checked);
    Diagnostics diagnostics = profile->diagnostics;
    Result<ResolvedWeb> resolved = resolve_web(*profile, options.resolve);
    if (!resolved) {
        Error error = std::move(resolved.error());
        error.diagnostics.insert(error.diagnostics.begin(), diagnostics.begin(), diagnostics.end());
        return Unexpected(std::move(error));
    }
    diagnostics.insert(diagnostics.end(), std::make_move_iterator(resolved->diagnostics.begin()),
                       std::make_move_iterator(resolved->diagnostics.end()));
    LoadedProfile loaded{std::move(bytes), std::move(*profile), std::move(resolved->web), std::move(diagnostics)};
    if (options.smooth_deg) {
        Result<Web> smooth = smoothed(loaded.web, *options.smooth_deg, file, loaded.diagnostics);
        if (!smooth) return pass_on(smooth);
        loaded.web = std::move(*smooth);
    }
    return loaded;
}

} // namespace gonio::cli
