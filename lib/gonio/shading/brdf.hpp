// All materials of the shading core: brdf_sample.hpp says what they have in common.
#pragma once

#include <gonio/shading/brdf_blinn.hpp>
#include <gonio/shading/brdf_eon.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/brdf_kulla_conty.hpp>
#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_ue4.hpp>
