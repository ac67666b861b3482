#include <gonio/base/file.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/detail/light_resolver.hpp>
#include <gonio/scene/detail/rig_expand.hpp>
#include <gonio/scene/detail/rig_plain.hpp>
#include <gonio/scene/detail/rig_reader.hpp>
#include <gonio/scene/detail/rig_stage.hpp>
#include <gonio/scene/detail/rig_stream.hpp>
#include <gonio/scene/detail/rig_values.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/web/smooth.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>

namespace gonio {

namespace {

using detail::angle_of;
using detail::Json;
using detail::keep;
using detail::nonzero_vector_of;
using detail::placed;
using detail::position_of;
using detail::positive_length;
using detail::text_of;
using detail::type_of;
using detail::unit_hint;

constexpr std::string_view schema_name = "gonio.rig/1";
constexpr std::array<std::string_view, 9> top_keys{"schema", "luminaires", "lights",    "maintenance", "sky",
                                                   "stage",  "camera",     "materials", "emits"};
constexpr std::array<std::string_view, 16> light_keys{
    "name",   "shape", "luminaire", "intensity", "color", "position", "positions",   "direction",
    "target", "up",    "rotate",    "smooth",    "range", "dimming",  "maintenance", "array"};
constexpr std::array<std::string_view, 4> camera_keys{"position", "target", "up", "fov"};
constexpr std::size_t most_remembered = 1U << 16U; // shapes and files; a rig with more reads some of them again

// Where a shape stores the name of its profile or mask, and the web or the image read from it.
struct FileOfShape {
    std::string* file = nullptr;
    std::shared_ptr<const Web>* web = nullptr;
    std::shared_ptr<const LightImage>* image = nullptr;
};

// What a file gave: a mask has no opening, and is a web or an image.
struct RememberedFile {
    std::shared_ptr<const Web> web;
    std::shared_ptr<const Opening> declared;
    std::shared_ptr<const LightImage> image;
};

FileOfShape file_of(Shape& shape) {
    return std::visit(
        [](auto& kind) -> FileOfShape {
            if constexpr (requires { kind.image; })
                return {&kind.mask_file, &kind.mask, &kind.image};
            else if constexpr (requires { kind.mask_file; })
                return {&kind.mask_file, &kind.mask};
            else if constexpr (requires { kind.file; })
                return {&kind.file, &kind.web};
            else
                return {};
        },
        shape);
}

class Reader {
public:
    Reader(std::string source, FileScope files) : files_(std::move(files)) { rig_.source = std::move(source); }

    // Reads lights as PlainLight where it can. A failure says only that the other way is needed, for its message. With
    // a sink, lights go there, resolved.
    Result<Rig> read_plain(std::string_view text, unsigned threads, LightsSink* sink_of_lights = nullptr) {
        is_plain_ = true;
        lights_sink_ = sink_of_lights;
        resolver_.emplace(rig_.source, threads);
        text_ = text;
        threads_ = threads;
        const detail::RigSink sink{{},
                                   [this](const std::string& key, const Json& json) -> Result<void> {
                                       // The other way reads luminaires first, and reports what it notices in this
                                       // order.
                                       if (key == "luminaires" && !rig_.diagnostics.empty()) return other_way();
                                       return member(key, json);
                                   },
                                   [this](std::size_t bracket) { return plain_lights(bracket); }};
        Result<void> streamed = detail::stream_rig(text, rig_.source, sink);
        // Which colours are not remembered any more, and remarked upon again, depends on the order of all of them.
        if (remarked_color_ && known_.colors.size() == most_remembered) return other_way();
        Result<Rig> rig = finish(std::move(streamed));
        if (!rig || lights_sink_ == nullptr) return rig;
        rig_.source = rig->source; // was moved, and what resolves lights names it
        if (Result<void> passed = pass_lights(rig->lights); !passed) return pass_on(passed);
        rig->places.clear();
        const Diagnostics noticed = resolver_->noticed();
        rig->diagnostics.insert(rig->diagnostics.end(), noticed.begin(), noticed.end());
        return rig;
    }

    // The way of values: every light as a tree of them, with the place of each mistake.
    Result<Rig> read(std::string_view text) {
        // Lights may stand before the luminaires that they name.
        constexpr std::string_view luminaires_key = R"("luminaires")";
        if (text.find(luminaires_key) != std::string_view::npos)
            if (Result<void> found = find_luminaires(text); !found) return pass_on(found);
        const detail::RigSink sink{[this](std::size_t index, const Json& json) { return lights(index, json); },
                                   [this](const std::string& key, const Json& json) { return member(key, json); }};
        return finish(detail::stream_rig(text, rig_.source, sink));
    }

private:
    Result<Rig> finish(Result<void> streamed) {
        if (streamed && !schema_seen_)
            streamed = detail::rig_error("RIG0104", rig_.source, {}, "the key 'schema' is missing",
                                         fmt::format(R"(write "schema": "{}")", schema_name));
        if (streamed) streamed = check_stage();
        if (!streamed) return pass_on(streamed);
        for (LightDescription& light : rig_.lights)
            light.level *= maintenance_;
        rig_.files.assign(files_.named().begin(), files_.named().end());
        return std::move(rig_);
    }

    Unexpected refuse(RigCode code, std::string_view path, std::string message, std::string hint = {}) const {
        return detail::rig_error(code, rig_.source, path, std::move(message), std::move(hint));
    }

    // What is not a rig is left to the reading after this one: its content is not reported.
    Result<void> find_luminaires(std::string_view text) {
        bool is_rig = false;
        const detail::RigSink sink{[](std::size_t /*index*/, const Json& /*json*/) { return Result<void>(); },
                                   [&](const std::string& key, const Json& json) -> Result<void> {
                                       if (key == "schema") is_rig = json == Json(schema_name);
                                       return key == "luminaires" && is_rig ? luminaires(json) : Result<void>();
                                   }};
        return detail::stream_rig(text, rig_.source, sink);
    }

    Result<void> luminaires(const Json& json) {
        if (luminaires_seen_) return {};
        Result<detail::Luminaires> read = detail::read_luminaires(json, rig_.source);
        if (!read) return pass_on(read);
        luminaires_ = std::move(*read);
        luminaires_seen_ = true;
        for (const auto& [name, luminaire] : luminaires_)
            if (Result<LightDescription> sound = described(luminaire))
                known_.luminaires.emplace(name, std::move(*sound));
            else
                return pass_on(sound);
        return {};
    }

    static Unexpected other_way() { return fail(Failure::malformed, "the rig is read by its values"); }

    // Reads the array from its opening bracket on, and returns where it ends.
    Result<std::size_t> plain_lights(std::size_t bracket) {
        const std::optional<std::size_t> first = detail::first_element(text_, bracket);
        if (!first) return other_way();
        known_.written_luminaires = &luminaires_;
        constexpr std::size_t bytes = std::size_t{1} << 18U; // of a piece, some thousand lights
        constexpr std::size_t most_together = 32; // their lights take 14 times as much memory as their text at most
        const std::size_t together =
            std::min(4 * std::size_t{threads_ == 0 ? available_threads() : threads_}, most_together);
        std::size_t element = *first;
        std::size_t index = 0;
        // The first piece is short and alone: files that its lights name are known to all after it.
        std::vector<std::size_t> ends{std::min(element + bytes / 16, text_.size())};
        while (true) {
            std::vector<detail::PlainPiece> pieces(ends.size());
            parallel_for(pieces.size(), threads_, [&](std::size_t p) {
                const std::size_t begin = p == 0 ? element : detail::likely_element(text_, ends[p - 1], ends[p]);
                // What begins at a wrong place could go on to the end of the text.
                const std::string_view text = p == 0 ? text_ : text_.substr(0, ends[p] + bytes);
                if (begin < ends[p]) pieces[p] = detail::read_plain(text, begin, ends[p], known_);
            });
            for (std::size_t p = 0; p < pieces.size(); ++p) {
                if (element >= ends[p]) continue; // one before it is longer than this piece
                detail::PlainPiece& piece = pieces[p];
                if (piece.begin != element || piece.is_broken)
                    piece = detail::read_plain(text_, element, ends[p], known_);
                if (piece.is_broken) return other_way();
                if (Result<void> taken = take(piece, index); !taken) return pass_on(taken);
                remember(piece);
                if (piece.is_closed) return piece.end;
                element = piece.end;
            }
            if (lights_sink_ != nullptr) {
                for (LightDescription& light : rig_.lights)
                    light.level *= maintenance_;
                if (Result<void> passed = pass_lights(rig_.lights); !passed) return pass_on(passed);
            }
            ends.clear();
            for (std::size_t p = 1; p <= together; ++p)
                ends.push_back(std::min(element + p * bytes, text_.size()));
        }
    }

    // The elements of a piece in their order; `index` is that of the next one.
    Result<void> take(detail::PlainPiece& piece, std::size_t& index) {
        std::size_t taken = 0;
        for (const detail::PlainPiece::Values& other : piece.others) {
            for (; taken < other.behind; ++taken)
                if (Result<void> light = take(piece.lights[taken], index++); !light) return light;
            if (Result<void> values = take_values(other.text, index++); !values) return values;
        }
        for (; taken < piece.lights.size(); ++taken)
            if (Result<void> light = take(piece.lights[taken], index++); !light) return light;
        return {};
    }

    Result<void> take_values(std::string_view text, std::size_t index) {
        const detail::RigSink sink{[&](std::size_t /*alone*/, const Json& json) { return lights(index, json); },
                                   [](const std::string& /*key*/, const Json& /*json*/) { return Result<void>(); }};
        return detail::stream_rig(fmt::format(R"({{"lights":[{}]}})", text), rig_.source, sink);
    }

    Result<void> take(detail::PlainLight& plain, std::size_t index) {
        if (!expander_.count_single()) return other_way();
        if (!plain.is_named) plain.light.name = detail::usual_name(plain.luminaire, index);
        if (!rig_.places.empty() && lights_sink_ == nullptr) note_place(fmt::format("lights[{}]", index));
        rig_.lights.push_back(std::move(plain.light));
        return {};
    }

    // The descriptions are gone then.
    Result<void> pass_lights(std::vector<LightDescription>& descriptions) {
        Result<std::vector<Light>> resolved =
            resolver_->resolve(descriptions, [](std::size_t /*index*/) { return std::string(); });
        if (!resolved) return pass_on(resolved);
        descriptions.clear();
        has_passed_lights_ = true;
        lights_sink_->add(std::move(*resolved));
        return {};
    }

    void remember(const detail::PlainPiece& piece) {
        for (const auto& [text, color] : piece.colors)
            if (known_.colors.size() < most_remembered) known_.colors.emplace(text, color);
        for (const auto& [text, shape] : piece.shapes)
            if (known_.shapes.size() < most_remembered) known_.shapes.emplace(text, shape);
    }

    // The lights that an element of "lights" stands for.
    Result<void> lights(std::size_t index, const Json& json) {
        written_.clear();
        return expander_.expand(json, index, [this](const detail::SingleLight& single) { return light(single); });
    }

    Result<void> light(const detail::SingleLight& single) {
        const detail::WrittenLight& written = single.written;
        if (!single.repeated) {
            Result<LightDescription> read = described(written);
            if (!read) return pass_on(read);
            return place(single, std::move(*read));
        }
        if (written.number >= written_.size()) written_.resize(written.number + 1);
        std::optional<LightDescription>& known = written_[written.number];
        if (!known) {
            Result<LightDescription> read = described(written);
            if (!read) return pass_on(read);
            known = std::move(*read);
        }
        return place(single, *known);
    }

    Result<void> place(const detail::SingleLight& single, LightDescription light) {
        light.name = single.name;
        light.position = single.position;
        if (single.target)
            light.direction = *single.target - single.position;
        else if (single.direction)
            light.direction = *single.direction;
        if (single.up) light.up = *single.up;
        light.level = single.dimming * single.maintenance;
        note_place(single);
        rig_.lights.push_back(std::move(light));
        return {};
    }

    // Once an element has made several lights, the index of a light is no longer its place.
    void note_place(const detail::SingleLight& single) {
        if (single.repeated || !rig_.places.empty()) note_place(single.written.path);
    }

    void note_place(const std::string& path) {
        if (rig_.places.empty() || rig_.places.back().path != path) rig_.places.push_back({rig_.lights.size(), path});
    }

    // The keys that do not place the light: first those of its luminaire, then its own.
    Result<LightDescription> described(const detail::WrittenLight& written) {
        Description read;
        if (written.luminaire != nullptr)
            if (Result<void> keys = describe(written.luminaire->keys, path_of(*written.luminaire), read); !keys)
                return pass_on(keys);
        if (Result<void> keys = describe(*written.keys, written.path, read); !keys) return pass_on(keys);
        return finished(std::move(read), written.path);
    }

    Result<LightDescription> described(const detail::Luminaire& luminaire) {
        Description read;
        if (Result<void> keys = describe(luminaire.keys, path_of(luminaire), read); !keys) return pass_on(keys);
        return finished(std::move(read), path_of(luminaire));
    }

    static std::string path_of(const detail::Luminaire& luminaire) {
        return fmt::format("luminaires.{}", luminaire.name);
    }

    struct Description {
        LightDescription light;
        bool has_shape = false;
        std::optional<Radians> smooth;
    };

    Result<void> describe(const Json& json, const std::string& path, Description& target) {
        LightDescription& light = target.light;
        for (const auto& [key, value] : json.items()) {
            Result<void> read;
            if (key == "shape") {
                target.has_shape = true;
                Result<std::string> text = text_of(value, "for example \"sphere:r=10cm\"");
                read = text ? shape(*text, light.shape) : pass_on(text);
            } else if (key == "intensity") {
                Result<std::string> text = text_of(value, unit_hint(value, "lm"));
                read = text ? keep(parse_photometric_value(*text, &files_), light.intensity) : pass_on(text);
            } else if (key == "color") {
                Result<std::string> text = text_of(value, R"(for example "2700K" or "#ffd9a0")");
                read = text ? color(*text, light.color, fmt::format("{}.color", path)) : pass_on(text);
            } else if (key == "rotate") {
                read = keep(angle_of(value), light.rotation);
            } else if (key == "smooth") {
                read = keep(angle_of(value), target.smooth);
            } else if (key == "range") {
                read = keep(positive_length(value), light.range);
            }
            if (!read) return placed(read.error(), rig_.source, fmt::format("{}.{}", path, key));
        }
        return {};
    }

    Result<LightDescription> finished(Description read, const std::string& path) {
        if (!read.has_shape)
            return refuse("RIG0104", path, "the key 'shape' is missing", R"(for example "shape": "sphere:r=10cm")");
        if (read.smooth)
            if (Result<void> done = smooth_profile(read.light.shape, to_degrees(*read.smooth), path + ".smooth"); !done)
                return pass_on(done);
        return std::move(read.light);
    }

    // Lights with the same table and step share one smooth table, too.
    Result<void> smooth_profile(Shape& shape, double step_deg, const std::string& path) {
        auto* const profile = std::get_if<ProfileShape>(&shape);
        if (profile == nullptr)
            return refuse("RIG0106", path, fmt::format("is for the table of a profile, not for a {}", kind_of(shape)));
        std::shared_ptr<const Web>& known = smooth_[{profile->web, step_deg}];
        if (!known) {
            Result<Web> web = smoothed(*profile->web, step_deg, profile->file, rig_.diagnostics);
            if (!web) return placed(web.error(), rig_.source, path);
            smooth_intensities_ += web->horizontal_deg().size() * web->vertical_deg().size();
            if (smooth_intensities_ > limit("rig-smooth").value)
                return refuse("RIG0108", path,
                              fmt::format("makes the smooth tables larger than {}", to_text(limit("rig-smooth"))),
                              std::string(limits_hint));
            known = std::make_shared<const Web>(std::move(*web));
        }
        profile->web = known;
        return {};
    }

    // Colour texts repeat too: remarks about a colour are reported where it first occurs.
    Result<void> color(const std::string& text, glm::dvec3& target, const std::string& path) {
        if (const auto known = known_.colors.find(text); known != known_.colors.end()) {
            target = known->second;
            return {};
        }
        Diagnostics said;
        Result<glm::dvec3> parsed = parse_light_color(text, &said, &files_);
        if (!parsed) return pass_on(parsed);
        target = *parsed;
        if (known_.colors.size() < most_remembered) known_.colors.emplace(text, target);
        remarked_color_ = remarked_color_ || !said.empty();
        for (Diagnostic& diagnostic : said) {
            diagnostic.location.file = rig_.source;
            diagnostic.message = fmt::format("{}: {}", path, diagnostic.message);
            rig_.diagnostics.push_back(std::move(diagnostic));
        }
        return {};
    }

    // Shape texts repeat; a shape that was parsed once, with its file read, is copied.
    Result<void> shape(const std::string& text, Shape& target) {
        if (const auto known = known_.shapes.find(text); known != known_.shapes.end()) {
            target = known->second;
            return {};
        }
        Result<Shape> parsed = parse_shape(text);
        if (!parsed) return pass_on(parsed);
        if (Result<void> loaded = load(*parsed); !loaded) return pass_on(loaded);
        target = *parsed;
        if (known_.shapes.size() < most_remembered) known_.shapes.emplace(text, std::move(*parsed));
        return {};
    }

    Result<void> load(Shape& shape) {
        const FileOfShape of = file_of(shape);
        if (of.file == nullptr || of.file->empty()) return {};
        Result<std::string> path = files_.path_of(*of.file);
        if (!path) return pass_on(path);
        *of.file = std::move(*path);
        // A mask may be stored in another form than a profile of the same file.
        const bool mask = !std::holds_alternative<ProfileShape>(shape);
        const auto key = std::pair(mask, *of.file);
        auto* const profile = std::get_if<ProfileShape>(&shape);
        // A pipe cannot be read again by the other way.
        if (is_plain_ && file_exists(*of.file) && file_identity(*of.file).empty()) return other_way();
        if (const auto known = webs_.find(key); known != webs_.end()) {
            *of.web = known->second.web;
            if (of.image != nullptr) *of.image = known->second.image;
            if (profile != nullptr) profile->declared = known->second.declared;
            return load_profile(shape, rig_.diagnostics); // refuses an image that the shape does not take
        }
        if (Result<void> loaded = load_profile(shape, rig_.diagnostics); !loaded) return pass_on(loaded);
        const FileOfShape read = file_of(shape);
        if (webs_.size() < most_remembered)
            webs_.emplace(key, RememberedFile{*read.web, profile != nullptr ? profile->declared : nullptr,
                                              read.image != nullptr ? *read.image : nullptr});
        return {};
    }

    Result<void> member(const std::string& key, const Json& json) {
        Result<void> read;
        if (key == "schema") {
            schema_seen_ = true;
            const Result<std::string> text = text_of(json);
            if (!text)
                return refuse("RIG0105", "schema", fmt::format("must be \"{}\", not {}", schema_name, type_of(json)));
            if (*text != schema_name) {
                Unexpected other = refuse("RIG0102", "schema",
                                          fmt::format("must be \"{}\", not {}", schema_name,
                                                      text->starts_with("gonio.") ? '"' + *text + '"' : "another"));
                other.value().failure = Failure::unsupported;
                return other;
            }
        } else if (key == "sky") {
            Result<std::string> text = text_of(json, "for example \"cie:12,sun=180/40,horizontal=20klx\"");
            Result<SkyDescription> sky =
                text ? parse_sky_description(*text, &rig_.diagnostics, &files_) : Result<SkyDescription>(pass_on(text));
            if (!sky) return placed(sky.error(), rig_.source, "sky");
            rig_.sky = std::move(*sky);
        } else if (key == "stage") {
            Result<Stage> stage = detail::read_rig_stage(json, {rig_.source, files_, rig_.diagnostics});
            if (!stage) return pass_on(stage);
            rig_.stage = std::move(*stage);
        } else if (key == "luminaires") {
            return luminaires(json);
        } else if (key == "maintenance") {
            if (has_passed_lights_) return other_way(); // they do not have the factor
            Result<void> kept = keep(detail::maintenance_of(json), maintenance_);
            if (!kept) return placed(kept.error(), rig_.source, "maintenance");
        } else if (key == "camera") {
            return camera(json);
        } else if (key == "materials") {
            return materials(json);
        } else if (key == "emits") {
            return emits(json);
        } else if (!schema_seen_ && nearest(key, top_keys).empty()) {
            // This may be any JSON text: do not report its content.
            return refuse("RIG0101", {}, "not a rig: it begins with another key",
                          fmt::format(R"(write "schema": "{}" first)", schema_name));
        } else {
            return placed(unknown_name("key", key, top_keys).value(), rig_.source, {});
        }
        return {};
    }

    Result<void> camera(const Json& json) {
        if (!json.is_object())
            return refuse("RIG0105", "camera", fmt::format("must be an object, not {}", type_of(json)));
        Camera camera;
        for (const auto& [key, value] : json.items()) {
            Result<void> read;
            if (key == "position") {
                read = keep(position_of(value), camera.position);
            } else if (key == "target") {
                read = keep(position_of(value), camera.target);
            } else if (key == "up") {
                read = keep(nonzero_vector_of(value), camera.up);
            } else if (key == "fov") {
                Result<double> angle = angle_of(value);
                if (angle) camera.vertical_fov_deg = to_degrees(Radians(*angle));
                if (angle && !(camera.vertical_fov_deg > 0.0 && camera.vertical_fov_deg < 180.0))
                    read = detail::rig_value_error("RIG0106", "must lie between 0deg and 180deg");
                else
                    read = angle ? Result<void>() : pass_on(angle);
            } else {
                return placed(unknown_name("key", key, camera_keys).value(), rig_.source, "camera");
            }
            if (!read) return placed(read.error(), rig_.source, fmt::format("camera.{}", key));
        }
        if (camera.position == camera.target) return refuse("RIG0106", "camera", "must not be at its own target");
        rig_.camera = camera;
        return {};
    }

    Result<void> materials(const Json& json) {
        if (!json.is_object())
            return refuse("RIG0105", "materials", fmt::format("must be an object, not {}", type_of(json)),
                          R"(for example { "floor": "lambert:albedo=0.5" })");
        for (const auto& [key, value] : json.items()) {
            Result<std::string> text = text_of(value, "for example \"lambert:albedo=0.5\"");
            Result<Material> material = text ? parse_material(*text) : Result<Material>(pass_on(text));
            if (!material) return placed(material.error(), rig_.source, fmt::format("materials.{}", key));
            rig_.materials.push_back({key, *material});
        }
        return {};
    }

    Result<void> emits(const Json& json) {
        if (!json.is_object())
            return refuse("RIG0105", "emits", fmt::format("must be an object, not {}", type_of(json)),
                          R"(for example { "sphere": "500nt" })");
        for (const auto& [key, value] : json.items()) {
            Result<SurfaceEmission> emission =
                detail::read_emission(value, {rig_.source, files_, rig_.diagnostics}, fmt::format("emits.{}", key));
            if (!emission) return pass_on(emission);
            rig_.emits.push_back({key, *emission});
        }
        return {};
    }

    // At the end, because the stage may follow its materials and camera.
    Result<void> check_stage() const {
        const Result<Stage> stage = rig_.stage ? Result<Stage>(*rig_.stage) : make_stage(stage_kinds().front().name);
        if (!stage) return Unexpected(stage.error());
        const std::vector<std::string_view> names = surface_names(*stage);
        for (const SurfaceMaterial& material : rig_.materials)
            if (std::find(names.begin(), names.end(), material.surface) == names.end())
                return placed(unknown_name("surface", material.surface, names, stage->name).value(), rig_.source,
                              "materials");
        if (const auto lights = emissive_lights(rig_); !lights) return Unexpected(lights.error());
        const Result<void> stands = check_camera(*stage, rig_.camera.value_or(stage->camera));
        if (!stands) return placed(stands.error(), rig_.source, "camera");
        return {};
    }

    FileScope files_;
    Rig rig_;
    bool schema_seen_ = false;
    bool luminaires_seen_ = false;
    detail::Luminaires luminaires_;
    double maintenance_ = 1.0;
    detail::RigExpander expander_{rig_.source, luminaires_};
    std::vector<std::optional<LightDescription>> written_; // of the element of "lights" that is read
    detail::KnownTexts known_;
    bool remarked_color_ = false;
    std::map<std::pair<bool, std::string>, RememberedFile> webs_;
    std::map<std::pair<std::shared_ptr<const Web>, double>, std::shared_ptr<const Web>> smooth_; // by table and step
    std::size_t smooth_intensities_ = 0;
    bool is_plain_ = false; // read_plain()
    std::string_view text_; // for it
    LightsSink* lights_sink_ = nullptr;
    std::optional<detail::LightResolver> resolver_;
    bool has_passed_lights_ = false;
    unsigned threads_ = 0;
};

} // namespace

namespace {

FileScope files_of(const std::string& folder, const RigReadOptions& options) {
    return options.allow_outside ? FileScope::anywhere(folder) : FileScope::under(folder, options.outside_hint);
}

// A spectrum may be a pipe, which cannot be read twice. Its name may have escapes.
bool may_read_twice(std::string_view text, const RigReadOptions& options) {
    return !options.allow_outside ||
           (text.find(spectrum_prefix) == std::string_view::npos && text.find("\\u") == std::string_view::npos);
}

} // namespace

Result<Rig> detail::read_rig_by_values(std::string_view text, const std::string& source, const std::string& folder,
                                       const RigReadOptions& options) {
    return Reader(source, files_of(folder, options)).read(text);
}

Result<Rig> detail::read_rig_plainly(std::string_view text, const std::string& source, const std::string& folder,
                                     const RigReadOptions& options) {
    return Reader(source, files_of(folder, options)).read_plain(text, options.threads);
}

Result<Rig> read_rig(std::string_view text, const std::string& source, const std::string& folder,
                     const RigReadOptions& options) {
    if (may_read_twice(text, options))
        if (Result<Rig> rig = detail::read_rig_plainly(text, source, folder, options)) return rig;
    return detail::read_rig_by_values(text, source, folder, options);
}

namespace {

Result<std::string> text_of_rig(const std::string& path) {
    return path == "-" ? read_standard_input(limit("rig-bytes")) : read_file(path, limit("rig-bytes"));
}

} // namespace

Result<Rig> read_rig_file(const std::string& path, const RigReadOptions& options) {
    Result<std::string> text = text_of_rig(path);
    if (!text) return pass_on(text);
    return read_rig(*text, path, folder_of_file(path), options);
}

Result<Rig> stream_rig_file(const std::string& path, const RigReadOptions& options, LightsSink& sink,
                            Diagnostics& diagnostics) {
    Result<std::string> text = text_of_rig(path);
    if (!text) return pass_on(text);
    const std::string folder = folder_of_file(path);
    sink.restart();
    if (may_read_twice(*text, options)) {
        Result<Rig> rig = Reader(path, files_of(folder, options)).read_plain(*text, options.threads, &sink);
        if (rig) {
            const Diagnostics said = std::exchange(rig->diagnostics, {});
            diagnostics.insert(diagnostics.end(), said.begin(), said.end());
            return rig;
        }
        sink.restart();
    }
    Result<Rig> rig = detail::read_rig_by_values(*text, path, folder, options);
    if (!rig) return rig;
    Rig of_lights;
    of_lights.source = rig->source;
    of_lights.lights = std::exchange(rig->lights, {});
    of_lights.places = std::exchange(rig->places, {});
    of_lights.diagnostics = std::exchange(rig->diagnostics, {});
    Result<std::vector<Light>> lights = resolve_lights(std::move(of_lights), diagnostics, options.threads);
    if (!lights) return pass_on(lights);
    sink.add(std::move(*lights));
    return rig;
}

std::span<const std::string_view> rig_keys() {
    return top_keys;
}
std::span<const std::string_view> rig_light_keys() {
    return light_keys;
}
std::span<const std::string_view> rig_camera_keys() {
    return camera_keys;
}

Result<Stage> stage_of(const Rig& rig) {
    if (rig.stage) return *rig.stage;
    return make_stage(stage_kinds().front().name);
}

Result<std::vector<LightDescription>> emissive_lights(const Rig& rig) {
    Result<Stage> stage = stage_of(rig);
    if (!stage) return pass_on(stage);
    for (const NamedEmission& named : rig.emits)
        if (Result<void> set = let_emit(*stage, named); !set)
            return detail::placed(set.error(), rig.source, fmt::format("emits.{}", named.surface));
    return emissive_lights(*stage);
}

Unexpected failed_sky(const Rig& rig, const Error& error) {
    return placed(error, rig.source, "sky");
}

Result<void> require_lights(const Rig& rig) {
    if (!rig.lights.empty()) return {};
    Result<std::vector<LightDescription>> emitted = emissive_lights(rig);
    if (!emitted) return pass_on(emitted);
    if (!emitted->empty()) return {};
    return detail::rig_error("RIG0104", rig.source, "lights", "must be an array of at least one light here",
                             R"(for example [{"shape": "point", "intensity": "800lm"}])");
}

} // namespace gonio
