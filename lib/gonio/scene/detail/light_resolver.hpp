// Lights of a rig resolved a part at a time: what the lights of one part share is kept for the next.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/light/luminaire.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace gonio::detail {

class LightResolver {
public:
    // Where the rig has a light of a part.
    using Place = std::function<std::string(std::size_t)>;

    // `source` is the rig's, and must outlive this. 0 threads = all hardware threads.
    LightResolver(const std::string& source, unsigned threads) : source_(source), threads_(threads) {}

    // Resolves the lights, which are moved from. Fails as resolve_lights() does, with the first light that fails; of
    // lights with a web or an image the first of each kind is looked at before all others.
    Result<std::vector<Light>> resolve(std::span<LightDescription> lights, const Place& place);

    // What was noticed: in webs and images first, then in the lights in their order.
    Diagnostics noticed();

private:
    // Everything that determines how much a light with a web or an image emits.
    using Emitter = std::tuple<std::size_t, std::vector<double>, const void*, const Opening*, std::string_view, double,
                               double, double, double>;

    void make_bodies(std::span<const LightDescription> lights, std::span<const std::size_t> of);

    static std::optional<Emitter> emitter_of(const LightDescription& light);

    const std::string& source_;
    unsigned threads_;
    // The flux and the peak of a web need a pass over it: lights with the same emission share one.
    std::map<Emitter, std::size_t> known_;
    std::vector<Light> prototypes_; // of each kind of emitter
    OpeningBodies bodies_;          // of their openings
    Diagnostics noticed_in_webs_;
    Diagnostics noticed_;
};

} // namespace gonio::detail
