// The ranges of C-planes of the symmetries.
#pragma once

#include <gonio/web/web.hpp>

namespace gonio {

struct AngleRange {
    double low = 0.0;
    double high = 0.0;
};

// The range of C, in degrees, of the stored planes of a symmetry: the full circle for axial and none.
constexpr AngleRange plane_range(Symmetry stored) {
    switch (stored) {
    case Symmetry::quadrant:
        return {0.0, 90.0};
    case Symmetry::bilateral_0_180:
        return {0.0, 180.0};
    case Symmetry::bilateral_90_270:
        return {90.0, 270.0};
    case Symmetry::axial:
    case Symmetry::none:
        break;
    }
    return {0.0, 360.0};
}

} // namespace gonio
