// Shape: what emits. The grammar of "sphere:r=3cm" and the parameters that each shape needs.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

class LightImage;
class Web;
struct Opening;

// Punctual shapes emit from a point and have no luminance. A mask multiplies their intensity by a web over its peak, or
// before a spot or a frustum by an image over its brightest pixel (gonio/light/light_image.hpp).

// Emits the same intensity in every direction.
struct PointShape {
    std::string mask_file;           // empty: none
    std::shared_ptr<const Web> mask; // nullptr until load_profile() has read the file
};

// How the intensity of a spot falls from 1 at the inner half angle to 0 at the outer one. Linear and smoothstep are
// functions of the cosine or of the angle; `frostbite` squares the linear falloff in the cosine, as glTF and Filament
// do.
enum class Falloff { frostbite, hard, linear_cos, smoothstep_cos, linear_angle, smoothstep_angle };

// A falloff by its name in text.
struct FalloffName {
    std::string_view name; // "smoothstep-cos"
    Falloff falloff;
    std::string_view summary;
};

// All of them.
std::span<const FalloffName> falloffs();

// Its name in text, and back. Fails (usage) on names other than those of falloffs().
const char* to_text(Falloff falloff);
Result<Falloff> parse_falloff(std::string_view name);

// 0 ≤ inner ≤ outer ≤ π/2, half angles from the axis; inner = outer is `hard`. An outer angle of 0 is a ray: it has an
// intensity and no flux.
struct SpotShape {
    Radians outer;
    Radians inner;
    Falloff falloff = Falloff::frostbite;
    std::string mask_file;
    std::shared_ptr<const Web> mask;
    std::shared_ptr<const LightImage> image = {}; // instead of `mask`, if the file is an image
};

// The same intensity inside a right pyramid; full apex angles in (0, π), `horizontal` about Y (its width runs along X).
struct FrustumShape {
    Radians horizontal;
    Radians vertical;
    std::string mask_file;
    std::shared_ptr<const Web> mask;
    std::shared_ptr<const LightImage> image = {};
};

// Where the light of a measured luminaire leaves it.
enum class ProfileSize {
    unsaid, // a point, unless the user of the shape prefers the opening
    point,
    opening,  // the luminous opening that the file declares, or another one (gonio/light/luminous_body.hpp)
    declared, // the same, and no remark if there is none
};

// A measured luminaire: emits according to its web, from a point or from its luminous opening.
struct ProfileShape {
    std::string file;
    std::shared_ptr<const Web> web; // nullptr until load_profile() has read the file
    ProfileSize size = ProfileSize::unsaid;
    std::shared_ptr<const Opening> given = {};    // "opening=rect:w=1.2m,h=0.3m"; nullptr: the declared one
    std::shared_ptr<const Opening> declared = {}; // read with the web

    // The opening if `size` asks for it; nullptr: a point, or not loaded.
    const Opening* opening() const {
        if (size != ProfileSize::opening && size != ProfileSize::declared) return nullptr;
        return given != nullptr ? given.get() : declared.get();
    }
};

// Area shapes are Lambertian: the same luminance in every direction that they emit to. A mask multiplies the luminance
// of every point of the shape by a web over its peak, looked up by the direction in the light's frame; an image on a
// rectangle multiplies each point of it by its pixel there over the brightest one, in all directions alike.

// A sphere that emits the same luminance everywhere.
struct SphereShape {
    Meters radius; // > 0
    std::string mask_file = {};
    std::shared_ptr<const Web> mask = {};
};

// Emits along its direction; if two_sided, also in the opposite direction.
struct DiskShape {
    Meters radius; // > 0
    bool two_sided = false;
    std::string mask_file = {};
    std::shared_ptr<const Web> mask = {};
};

// `width` along X, `height` along Y: full axes.
struct EllipseShape {
    Meters width;  // > 0
    Meters height; // > 0
    bool two_sided = false;
    std::string mask_file = {};
    std::shared_ptr<const Web> mask = {};
};

// `width` along X, `height` along Y.
struct RectShape {
    Meters width;  // > 0
    Meters height; // > 0
    bool two_sided = false;
    std::string mask_file = {};
    std::shared_ptr<const Web> mask = {};
    std::shared_ptr<const LightImage> image = {};
};

// A capsule: a cylinder of `length` along X without its caps, and a hemisphere at each end.
struct TubeShape {
    Meters radius; // > 0
    Meters length; // > 0
    std::string mask_file = {};
    std::shared_ptr<const Web> mask = {};
};

// The side of a cylinder along X: luminous outside, without caps, so that it is dark seen along its axis.
struct CylinderShape {
    Meters radius; // > 0
    Meters length; // > 0
    std::string mask_file = {};
    std::shared_ptr<const Web> mask = {};
};

// A uniform disk at infinity.
struct SunShape {
    Radians diameter; // angular, in (0, π]
};

// What emits: one of the shapes above.
using Shape = std::variant<PointShape, SpotShape, FrustumShape, ProfileShape, SphereShape, DiskShape, EllipseShape,
                           RectShape, TubeShape, CylinderShape, SunShape>;

// The class of a shape: a point to every receiver, a luminous surface, or a source at infinity.
enum class ShapeClass { punctual, area, sun };

// The class of a shape.
ShapeClass class_of(const Shape& shape);

// Whether the shape is a flat surface, which emits to one side or to both.
bool is_flat(const Shape& shape);

// A kind of shape, as `gonio list shapes` shows it.
struct ShapeKind {
    std::string_view kind;    // "sphere"
    std::string_view grammar; // "sphere:r=LENGTH"
    std::string_view summary;
};

// All of them.
std::span<const ShapeKind> shape_kinds();

// Angles and lengths need units; "cone", the full outer angle of a spot, may replace "outer". Fails (usage) on an
// unknown kind, key or falloff, a missing key, or a length or an angle outside the range of its shape. Reads no file.
// The file name of a mask ends at a comma; the file name of "ies:FILE" does not, but for ",opening" and
// ",opening=OPENING" at its end (parse_opening(); "opening=off" is a point).
Result<Shape> parse_shape(std::string_view text);

// Reads the file of a ProfileShape or of a mask, and resolves its web; other shapes, and webs and images that are
// already loaded, are left alone. Warnings and notes are appended to `diagnostics`. Fails as read_profile_file(),
// resolve_web() and read_light_image() do, and (usage) on an image before a shape that takes none.
Result<void> load_profile(Shape& shape, Diagnostics& diagnostics);

// What all that a light emits by direction or by place comes from: the web of a profile, or the web or the image of a
// mask; nullptr without one, or before it is loaded. Lights with the same one may share what is made of it.
const void* pattern_of(const Shape& shape);

// The mask of a shape: its file (nullptr: none), and its web or its image (nullptr: none, or not loaded). Points into
// the shape.
struct Mask {
    const std::string* file = nullptr;
    const Web* web = nullptr;
    const LightImage* image = nullptr;

    bool is_loaded() const { return web != nullptr || image != nullptr; }
};

// The mask of a shape.
Mask mask_of(const Shape& shape);

// The file of a ProfileShape or of a mask; nullptr: none. Points into the shape.
const std::string* file_of(const Shape& shape);

// The values of the keys of its grammar, in their order; files are left out.
struct ShapeValue {
    std::string_view key;
    std::variant<Meters, Radians, bool, Falloff> value;
};
// The parameters of a shape.
std::vector<ShapeValue> values_of(const Shape& shape);

// Sets a parameter of a sweep ("radius", "size", "outer"; gonio/scene/parameter.hpp) from text of the grammar. Returns
// false if the shape has no parameter of that name. Fails (usage) as parse_shape() does.
Result<bool> set_shape_parameter(Shape& shape, std::string_view name, const std::string& value);

// The kinds that have the parameter: "sphere, disk, tube".
std::string kinds_with_parameter(std::string_view name);

const char* kind_of(const Shape& shape); // "sphere"

} // namespace gonio
#pragma GCC visibility pop
