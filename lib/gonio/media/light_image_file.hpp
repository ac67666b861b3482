// Images as masks of lights, from picture files.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light_image.hpp>

#include <string>

#pragma GCC visibility push(default)
namespace gonio::media {

// OpenEXR, Radiance HDR and floating-point TIFF hold linear values, in the space that an OpenEXR file states by its
// chromaticities, else in Rec.709. PNG, JPEG and TIFF with integers hold sRGB. Alpha darkens integers, and is part of
// the values of the others already. A picture without colour becomes one channel. Needs the modules as image_file.hpp
// does. Fails (io) on a file that cannot be read, (malformed) on an incomplete one and as LightImage::create() does,
// (unsupported), before the pixels are read, on more values than the limit light-image-values.
Result<LightImage> read_light_image_file(const std::string& file, Diagnostics& diagnostics);

// Has load_profile() and all that calls it read images: a program that uses them calls it once.
void enable_light_images();

} // namespace gonio::media
#pragma GCC visibility pop
