// The module for JavaScript: profiles read, checked, measured, drawn and baked. README.md shows its use.
//
// Names of numbers are those of `gonio info --json`. Failures are thrown as an Error with the message of the tool and
// all diagnostics.
#include <gonio/asset/facts_record.hpp>
#include <gonio/bake/bake_choice.hpp>
#include <gonio/base/path.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/repetitions.hpp>
#include <gonio/web/resolve.hpp>

#include "to_js.hpp"

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::wasm {

namespace {

using emscripten::val;

template<class T>
std::optional<T> option(const val& asked, const char* name) {
    const val value = asked[name];
    if (value.isUndefined() || value.isNull()) return std::nullopt;
    return value.as<T>();
}

BakeOptions bake_options(const val& asked) {
    return value_of(gonio::bake_options(
        {option<std::string>(asked, "layout"), option<std::string>(asked, "engine"), option<int>(asked, "width"),
         option<int>(asked, "height"), option<std::string>(asked, "normalization"),
         option<std::string>(asked, "texel_type"), option<double>(asked, "cone_deg"), option<int>(asked, "border")}));
}

Texture baked(const Web& web, const val& asked) {
    const BakeOptions options = bake_options(asked);
    const auto max_error_cd = option<double>(asked, "max_error_cd");
    return value_of(max_error_cd ? bake_smallest(web, options, Candelas(*max_error_cd)) : bake_texture(web, options));
}

val to_js(const Texture& texture) {
    val made = val::object();
    made.set("layout", texture.layout);
    made.set("texel_convention", texture.texel_convention);
    made.set("width", texture.image.width);
    made.set("height", texture.image.height);
    made.set("channels", texture.image.channels);
    made.set("data",
             val::global("Float32Array")
                 .new_(emscripten::typed_memory_view(texture.image.pixels.size(), texture.image.pixels.data())));
    made.set("cd_per_unit", texture.cd_per_unit);
    made.set("peak_cd", texture.peak.value);
    made.set("flux_lm", texture.flux.value);
    made.set("texture_flux_lm", texture.texture_flux.value);
    made.set("max_error_cd", texture.max_error.value);
    made.set("solid_angle_sr", texture.solid_angle.value);
    return made;
}

// A profile and its web.
class JsProfile {
public:
    JsProfile(const std::string& name, Profile profile, ResolvedWeb resolved)
        : name_(name), profile_(std::move(profile)), web_(std::move(resolved.web)), diagnostics_(profile_.diagnostics) {
        diagnostics_.insert(diagnostics_.end(), std::make_move_iterator(resolved.diagnostics.begin()),
                            std::make_move_iterator(resolved.diagnostics.end()));
    }

    val diagnostics() const { return wasm::to_js(diagnostics_); }

    // All facts of `gonio info --json`.
    val info() const {
        const std::string record = facts_record(name_, profile_facts(profile_, web_), diagnostics_);
        return val::global("JSON").call<val>("parse", record);
    }

    double candela(double c_deg, double gamma_deg) const { return web_.candela(c_deg, gamma_deg); }

    // Float64Array of the intensities along gamma in one plane.
    val sample(double c_deg, const val& gammas_deg) const {
        std::vector<double> candela = emscripten::convertJSArrayToNumberVector<double>(gammas_deg);
        for (double& each : candela)
            each = web_.candela(c_deg, each);
        return val::global("Float64Array").new_(emscripten::typed_memory_view(candela.size(), candela.data()));
    }

    // A kind of `gonio list diagrams`, as an SVG document.
    std::string diagram(const std::string& kind, int width_px, int height_px) const {
        const DiagramKind* const found = value_of(find_diagram(kind));
        if (found->draw == nullptr)
            throw_js(fail(Failure::unsupported, "the diagram '" + kind + "' is of lights, not of a web").value());
        PlotOptions options;
        options.width_px = width_px;
        options.height_px = height_px;
        const ProfileHeader header = header_of(profile_, {});
        std::string_view luminaire = keyword_text(header, "LUMINAIRE");
        if (luminaire.empty()) luminaire = keyword_text(header, "LUMCAT");
        const PlottedWeb plotted{file_name(name_), &web_, std::string(luminaire)};
        return to_svg(value_of(found->draw({&plotted, 1}, options)));
    }

    // As `gonio bake`: {layout | engine, width, height, cone_deg, border, normalization, texel_type, max_error_cd}, all
    // but one of the first two optional. Texels of float32, rounded to what the texel type holds; candela are texel ×
    // cd_per_unit.
    val bake(const val& asked) const { return to_js(baked(web_, asked)); }

private:
    std::string name_;
    Profile profile_;
    Web web_;
    Diagnostics diagnostics_;
};

// `bytes` is a string, an ArrayBuffer or a Uint8Array; `name` is for messages and for an ambiguous format.
std::shared_ptr<JsProfile> read(const std::string& bytes, const std::string& name) {
    Profile profile = value_of(read_profile(bytes, name));
    ResolvedWeb resolved = value_of(resolve_web(profile));
    return std::make_shared<JsProfile>(name, std::move(profile), std::move(resolved));
}

// What `gonio check` finds: {readable, diagnostics}. Throws nothing.
val check(const std::string& bytes, const std::string& name) {
    val report = val::object();
    Diagnostics found;
    const auto add = [&found](const Diagnostics& more) { found.insert(found.end(), more.begin(), more.end()); };
    bool readable = false;
    if (Result<Profile> profile = read_profile(bytes, name); !profile) {
        add(profile.error().diagnostics);
    } else {
        add(profile->diagnostics);
        if (const Result<ResolvedWeb> resolved = resolve_web(*profile); !resolved) {
            add(resolved.error().diagnostics);
        } else {
            readable = true;
            found = report_of(std::move(found), *profile, *resolved);
        }
    }
    report.set("readable", readable);
    report.set("diagnostics", wasm::to_js(found));
    return report;
}

} // namespace

EMSCRIPTEN_BINDINGS(gonio) {
    emscripten::function("read", &read);
    emscripten::function("check", &check);
    emscripten::class_<JsProfile>("Profile")
        .smart_ptr<std::shared_ptr<JsProfile>>("ProfilePointer")
        .property("diagnostics", &JsProfile::diagnostics)
        .function("info", &JsProfile::info)
        .function("candela", &JsProfile::candela)
        .function("sample", &JsProfile::sample)
        .function("diagram", &JsProfile::diagram)
        .function("bake", &JsProfile::bake);
}

} // namespace gonio::wasm
