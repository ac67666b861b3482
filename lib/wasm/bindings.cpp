// The module for JavaScript: profiles read, checked, measured and drawn. README.md shows its use.
//
// Names of numbers are those of `gonio info --json`. Failures are thrown as an Error with the message of the tool and
// all diagnostics.
#include <gonio/base/path.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/repetitions.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/symmetry.hpp>

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
using wasm::to_js;

val to_js(const std::optional<double>& number) {
    return number ? val(*number) : val::null();
}

val to_js(const std::optional<Radians>& angle) {
    return angle ? val(to_degrees(*angle)) : val::null();
}

// A profile and its web.
class JsProfile {
public:
    JsProfile(const std::string& name, Profile profile, ResolvedWeb resolved)
        : label_(file_name(name)),
          profile_(std::move(profile)),
          web_(std::move(resolved.web)),
          diagnostics_(profile_.diagnostics) {
        diagnostics_.insert(diagnostics_.end(), std::make_move_iterator(resolved.diagnostics.begin()),
                            std::make_move_iterator(resolved.diagnostics.end()));
    }

    val diagnostics() const { return to_js(diagnostics_); }

    val info() const {
        const std::optional<double> declared = declared_flux_lm(profile_, {});
        const Peak brightest = peak(web_);
        val facts = val::object();
        facts.set("symmetry", std::string(to_text(detected_symmetry(web_))));
        facts.set("declared_symmetry", std::string(to_text(web_.stored_symmetry())));
        facts.set("flux_lm", flux(web_).value);
        facts.set("zonal_flux_lm", zonal_flux(web_).value);
        facts.set("declared_flux_lm", to_js(declared));
        facts.set("absolute", !declared);
        facts.set("peak_cd", brightest.intensity.value);
        facts.set("peak_c_deg", brightest.c_deg);
        facts.set("peak_gamma_deg", brightest.gamma_deg);
        facts.set("beam_angle_deg", to_js(spread_angle(web_, 0.0, 0.5)));
        facts.set("field_angle_deg", to_js(spread_angle(web_, 0.0, 0.1)));
        facts.set("beam_angle_c90_deg", to_js(spread_angle(web_, 90.0, 0.5)));
        facts.set("field_angle_c90_deg", to_js(spread_angle(web_, 90.0, 0.1)));
        facts.set("center_beam_cd", center_beam(web_).value);
        facts.set("beam_angle_cie_deg", to_js(cie_beam_angle(web_, 0.0)));
        facts.set("beam_angle_cie_c90_deg", to_js(cie_beam_angle(web_, 90.0)));
        return facts;
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
        const PlottedWeb plotted{label_, &web_, std::string(luminaire)};
        return to_svg(value_of(found->draw({&plotted, 1}, options)));
    }

private:
    std::string label_;
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
    report.set("diagnostics", to_js(found));
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
        .function("diagram", &JsProfile::diagram);
}

} // namespace gonio::wasm
