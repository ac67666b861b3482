// libFuzzer: for any bytes, the rig reader does not crash and allocates no memory for items that are only announced; a
// failure is one error that names the source; a rig that is read resolves or fails with an error, and is the same when
// read again, also with its groups and arrays expanded. Both ways of reading give the same rig or the same message.
#include <gonio/scene/detail/rig_reader.hpp>
#include <gonio/scene/rig.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

namespace {

using namespace gonio;

void check_failure(const Error& error) {
    if (error.diagnostics.empty() || error.diagnostics.back().severity != Severity::error) std::abort();
}

bool are_same(const LightDescription& a, const LightDescription& b) {
    const auto is_same_amount = [](const PhotometricValue& x, const PhotometricValue& y) {
        return x.number == y.number && x.unit.unit == y.unit.unit;
    };
    return a.name == b.name && a.shape.index() == b.shape.index() &&
           a.intensity.has_value() == b.intensity.has_value() &&
           (!a.intensity || is_same_amount(*a.intensity, *b.intensity)) && a.color == b.color &&
           a.position == b.position && a.direction == b.direction && a.up == b.up &&
           a.rotation.value == b.rotation.value && a.range.has_value() == b.range.has_value() &&
           (!a.range || a.range->value == b.range->value) && a.level == b.level;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as text
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    // Files that lights name are searched for in a folder that does not exist; their readers have their own fuzz
    // targets.
    const std::string folder = "no such folder";
    Result<Rig> rig = read_rig(text, "fuzz.json", folder);
    const Result<Rig> by_values = detail::read_rig_by_values(text, "fuzz.json", folder);
    if (rig.has_value() != by_values.has_value()) std::abort();
    if (!rig) {
        check_failure(rig.error());
        if (to_text(rig.error().diagnostics.back()) != to_text(by_values.error().diagnostics.back())) std::abort();
        return 0;
    }
    if (rig->lights.size() != by_values->lights.size()) std::abort();
    for (std::size_t i = 0; i < rig->lights.size(); ++i)
        if (!are_same(rig->lights[i], by_values->lights[i])) std::abort();
    const Result<Rig> again = read_rig(text, "fuzz.json", folder);
    if (!again || again->lights.size() != rig->lights.size() || again->materials.size() != rig->materials.size())
        std::abort();
    const std::size_t lights = rig->lights.size();
    constexpr std::size_t most_resolved = 2000; // an array is a few bytes
    if (lights > most_resolved) return 0;
    const Result<std::string> expanded = expand_rig(text, "fuzz.json");
    if (!expanded) std::abort();
    const Result<Rig> single = read_rig(*expanded, "fuzz.json", folder);
    if (!single || single->lights.size() != lights) std::abort();
    for (std::size_t i = 0; i < lights; ++i)
        if (single->lights[i].name != rig->lights[i].name || single->lights[i].position != rig->lights[i].position ||
            single->lights[i].level != rig->lights[i].level)
            std::abort();
    Diagnostics diagnostics;
    const Result<std::vector<Light>> resolved = resolve_lights(*std::move(rig), diagnostics, 1);
    if (!resolved) {
        check_failure(resolved.error());
    } else if (resolved->size() != lights) {
        std::abort();
    }
    return 0;
}
