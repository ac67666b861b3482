#include "sum_while_reading.hpp"

#include <gonio/base/file.hpp>
#include <gonio/scene/rig.hpp>

#include "../options/light_input.hpp"
#include "../options/rig_input.hpp"
#include "../stopwatch.hpp"
#include "probe_report.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::size_t least_bytes = std::size_t{4} << 20U; // some tens of thousands of lights

bool asks_for_sums(const Arguments& arguments, const ProbeRequest& request) {
    constexpr std::array others{
        "--profile-size", "--indirect", "--sky", "--stage", "--emits", "--json", "--jsonl",
        // What is left to the usual way is read again, which a pipe that a light names cannot be.
        "--allow-outside"};
    return std::none_of(others.begin(), others.end(), [&](std::string_view o) { return arguments.has(o); }) &&
           request.is_planar() && !request.compare && !request.glare && !request.task && !request.drawing &&
           !request.points.workplane && request.points.receivers.size() <= points_at_once;
}

class Summer final : public LightsSink {
public:
    explicit Summer(const ProbeRequest& request) : request_(request) { restart(); }

    void add(std::vector<Light> lights) override {
        const Stopwatch evaluation;
        if (sum_ && !sum_->add(lights)) sum_.reset();
        milliseconds_ += evaluation.milliseconds();
    }

    void restart() override {
        ProbeOptions options = request_.options;
        options.method = request_.methods.front();
        Result<ProbeSum> sum = ProbeSum::of(request_.points.receivers, options);
        sum_.reset();
        if (sum) sum_.emplace(std::move(*sum));
    }

    // Empty: the sum failed.
    std::optional<SummedLight> result() const {
        if (!sum_) return std::nullopt;
        return SummedLight{sum_->result(), sum_->remarked(), sum_->lights(), milliseconds_};
    }

private:
    const ProbeRequest& request_;
    std::optional<ProbeSum> sum_;
    double milliseconds_ = 0.0;
};

} // namespace

Result<bool> sum_while_reading(const Arguments& arguments, ProbeRequest& request) {
    const auto rig_file = arguments.value("--rig");
    if (!rig_file || !given_light_option(arguments).empty() || !arguments.positional().empty()) return false;
    if (*rig_file == "-" || !asks_for_sums(arguments, request) || size_of_file(*rig_file) < least_bytes) return false;
    Summer summer(request);
    Diagnostics said;
    Result<Rig> rig = stream_rig_file(*rig_file, rig_read_options(arguments), summer, said);
    // With its line it is a mistake in the text, which the usual way would come to first, too.
    if (!rig && !rig.error().diagnostics.empty() && rig.error().diagnostics.back().location.line > 0)
        return pass_on(rig);
    if (!rig || rig->sky || !rig->emits.empty()) return false;
    if (rig->stage && !emissive_lights(*rig).value_or(std::vector<LightDescription>(1)).empty()) return false;
    std::optional<SummedLight> summed = summer.result();
    // The shares of few lights are listed.
    if (!summed || summed->count <= lights_listed) return false;
    request.rig = *rig_file;
    request.summed = std::move(summed);
    request.diagnostics.insert(request.diagnostics.end(), said.begin(), said.end());
    return true;
}

} // namespace gonio::cli
