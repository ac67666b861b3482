// The poses of measure/hostile_poses.hpp under the names of the tests.
#pragma once

#include "area_truth.hpp"

#include <array>

namespace area {

using gonio::measure::hostile::random_light;
using gonio::measure::hostile::receiver;
using gonio::measure::hostile::Stratum;
using gonio::measure::hostile::stratum_count;
using gonio::measure::hostile::stratum_names;

} // namespace area
