// Profiles as lights on a stage, each in a picture of its own: for sheets and reports.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/stage.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace gonio::cli {

class ProfileStages {
public:
    // `is_chosen`: every profile is shown on this stage. Otherwise a luminaire that shines mostly upwards is shown in a
    // room, because the usual stage has no ceiling. The stage must outlive this.
    ProfileStages(const Stage& stage, bool is_chosen) : stage_(stage), is_chosen_(is_chosen) {}

    struct Shown {
        const Stage* stage = nullptr;
        Light light;
        Rendering rendering;
    };

    // Shows a profile, which is loaded, where the light of the stage is. Remarks go to `diagnostics`. Safe to call from
    // any thread. Fails as resolve_light() and render() do.
    Result<Shown> show(const std::string& name, ProfileShape profile, RenderOptions options, Diagnostics& diagnostics);

private:
    const Stage& stage_;
    bool is_chosen_;
    // What interreflection needs of each stage, whichever picture computes it first: it is the same for all.
    std::mutex mutex_;
    std::map<const Stage*, std::shared_ptr<const Interreflection>> known_;
};

} // namespace gonio::cli
