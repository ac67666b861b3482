#include <gonio/base/gauss_legendre.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/light/lobe.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

namespace gonio {

namespace {

using std::numbers::pi;

std::size_t index_of(int column, int row, int width) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
}

double projected(const glm::dvec2& covered, const ImagePlane& image, const glm::dvec3& direction) {
    if (!(direction.z < 0.0)) return 0.0;
    const double x = -direction.x / direction.z / covered.x;
    const double y = -direction.y / direction.z / covered.y;
    // A direction on the outline may lie outside by rounding.
    constexpr double most = 1.0 + 1e-9;
    if (!(std::abs(x) <= most && std::abs(y) <= most)) return 0.0;
    return image.smooth({0.5 + 0.5 * x, 0.5 - 0.5 * y});
}

struct PlaceInImage {
    int column = 0;
    int row = 0;
};

std::optional<PlaceInImage> first_bad(const Image& image) {
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const float* const pixel = image.at(column, row);
            if (!std::all_of(pixel, pixel + image.channels, [](float v) { return std::isfinite(v) && v >= 0.0F; }))
                return PlaceInImage{column, row};
        }
    return std::nullopt;
}

// In polar coordinates, so that the edges of the lobe are lines of the sum. The rule is of low order, because the image
// has kinks everywhere.
Steradians solid_angle_of(const SpotShape& spot, const ImagePlane& image) {
    const double covered = covered_by_image(spot).x;
    const int side = std::clamp(4 * std::max(image.width(), image.height()), 256, 1024);
    const int azimuths = 4 * side;
    static constexpr auto rule = gauss_legendre<2>();
    std::vector<double> cosines;
    std::vector<double> sines;
    for (int k = 0; k < azimuths; ++k) {
        const double phi = 2.0 * pi * (k + 0.5) / azimuths;
        cosines.push_back(std::cos(phi));
        sines.push_back(std::sin(phi));
    }
    double sum = 0.0;
    const auto add_ring = [&](double from, double to) {
        const int rings = std::max(static_cast<int>(std::ceil(0.5 * side * (to - from) / spot.outer.value)), 1);
        const double width = (to - from) / rings;
        for (int i = 0; i < rings; ++i)
            for (const QuadratureNode& node : rule) {
                const double theta = from + width * (i + 0.5 + 0.5 * node.at);
                const double weight = lobe(spot, Radians(theta)) * std::sin(theta) * 0.5 * width * node.weight;
                const double reach = std::tan(theta) / covered;
                double around = 0.0;
                for (int k = 0; k < azimuths; ++k)
                    around += image.smooth({0.5 + 0.5 * reach * cosines[static_cast<std::size_t>(k)],
                                            0.5 - 0.5 * reach * sines[static_cast<std::size_t>(k)]});
                sum += weight * around * (2.0 * pi / azimuths);
            }
    };
    if (spot.inner.value > 0.0) add_ring(0.0, spot.inner.value);
    if (spot.inner.value < spot.outer.value) add_ring(spot.inner.value, spot.outer.value);
    return Steradians(sum);
}

// Between the centres of pixels the image is bilinear; cos³θ, the solid angle of the plane before the light, is smooth.
Steradians solid_angle_of(const FrustumShape& frustum, const ImagePlane& image) {
    const glm::dvec2 covered = covered_by_image(frustum);
    static constexpr auto rule = gauss_legendre<2>();
    struct Node {
        double place;
        double slope;
        double weight;
    };
    const auto axis = [](int pixels, double covered_slope, double sense) {
        // Edges at 0, the centres of pixels and 1; each piece in parts, so that there are enough of them.
        constexpr int enough = 128;
        std::vector<double> edges{0.0};
        for (int i = 0; i < pixels; ++i)
            edges.push_back((i + 0.5) / pixels);
        edges.push_back(1.0);
        const int parts = std::max((enough + pixels - 1) / pixels, 1);
        std::vector<Node> nodes;
        for (std::size_t i = 0; i + 1 < edges.size(); ++i)
            for (int part = 0; part < parts; ++part) {
                const double width = (edges[i + 1] - edges[i]) / parts;
                const double middle = edges[i] + width * (part + 0.5);
                for (const QuadratureNode& node : rule) {
                    const double place = middle + 0.5 * width * node.at;
                    nodes.push_back(
                        {place, sense * (2.0 * place - 1.0) * covered_slope, width * node.weight * covered_slope});
                }
            }
        return nodes;
    };
    const std::vector<Node> columns = axis(image.width(), covered.x, 1.0);
    const std::vector<Node> rows = axis(image.height(), covered.y, -1.0);
    double sum = 0.0;
    for (const Node& row : rows) {
        double along = 0.0;
        for (const Node& column : columns) {
            const double square = 1.0 + column.slope * column.slope + row.slope * row.slope;
            along += column.weight * image.smooth({column.place, row.place}) / (square * std::sqrt(square));
        }
        sum += row.weight * along;
    }
    return Steradians(sum);
}

Steradians solid_angle_of(const RectShape& rect, const ImagePlane& image) {
    return Steradians((rect.two_sided ? 2.0 : 1.0) * pi * image.mean());
}

template<class Kind>
Steradians solid_angle_of(const Kind& /*takes no image*/, const ImagePlane& /*image*/) {
    return {};
}

std::atomic<LightImageReader> the_reader = nullptr;

} // namespace

ImagePlane::ImagePlane(int width, int height, std::vector<float> values)
    : width_(width),
      height_(height),
      pixels_(std::move(values)),
      peak_(static_cast<double>(*std::max_element(pixels_.begin(), pixels_.end()))) {
    double sum = 0.0;
    for (float& pixel : pixels_) {
        pixel = static_cast<float>(static_cast<double>(pixel) / peak_);
        sum += static_cast<double>(pixel);
    }
    mean_ = sum / static_cast<double>(pixels_.size());
}

double ImagePlane::smooth(glm::dvec2 at) const {
    const auto axis = [](double place, int count) {
        const double position = std::clamp(place * count - 0.5, 0.0, static_cast<double>(count - 1));
        const int first = std::min(static_cast<int>(position), std::max(count - 2, 0));
        return std::pair(first, position - first);
    };
    const auto [column, right] = axis(at.x, width_);
    const auto [row, down] = axis(at.y, height_);
    const auto along = [&, column = column, right = right](int of_row) {
        const float* const pixel = pixels_.data() + index_of(column, of_row, width_);
        const auto here = static_cast<double>(pixel[0]);
        return right > 0.0 ? here + right * (static_cast<double>(pixel[1]) - here) : here;
    };
    const double upper = along(row);
    return down > 0.0 ? upper + down * (along(row + 1) - upper) : upper;
}

double ImagePlane::pixel(glm::dvec2 at) const {
    const auto nearest = [](double place, int count) {
        return static_cast<int>(std::clamp(place * count, 0.0, static_cast<double>(count - 1)));
    };
    return static_cast<double>(pixels_[index_of(nearest(at.x, width_), nearest(at.y, height_), width_)]);
}

void ImagePlane::sum_up() const {
    const std::size_t columns = static_cast<std::size_t>(width_) + 1;
    sums_.assign(columns * (static_cast<std::size_t>(height_) + 1), 0.0);
    for (int row = 0; row < height_; ++row) {
        double sum = 0.0;
        for (int column = 0; column < width_; ++column) {
            sum += static_cast<double>(pixels_[index_of(column, row, width_)]);
            sums_[index_of(column + 1, row + 1, width_ + 1)] = sums_[index_of(column + 1, row, width_ + 1)] + sum;
        }
    }
}

double ImagePlane::sum_before(double column, double row) const {
    const int x = std::min(static_cast<int>(column), width_ - 1);
    const int y = std::min(static_cast<int>(row), height_ - 1);
    const double* const upper = sums_.data() + index_of(x, y, width_ + 1);
    const double* const lower = upper + width_ + 1;
    const double right = column - x;
    const double top = upper[0] + right * (upper[1] - upper[0]);
    return top + (row - y) * (lower[0] + right * (lower[1] - lower[0]) - top);
}

double ImagePlane::mean(glm::dvec2 low, glm::dvec2 high) const {
    std::call_once(summed_up_, [&] { sum_up(); });
    const glm::dvec2 size(width_, height_);
    const glm::dvec2 first = glm::clamp(low, 0.0, 1.0) * size;
    const glm::dvec2 last = glm::clamp(high, 0.0, 1.0) * size;
    const double area = (last.x - first.x) * (last.y - first.y);
    // Sums have 16 digits of the whole image: a tiny part of a pixel has none left.
    if (!(area > 1e-6)) return pixel(0.5 * (low + high));
    const double sum = sum_before(last.x, last.y) - sum_before(first.x, last.y) - sum_before(last.x, first.y) +
                       sum_before(first.x, first.y);
    return std::clamp(sum / area, 0.0, 1.0);
}

Result<LightImage> LightImage::create(const Image& image) {
    if ((image.channels != 1 && image.channels != 3) || image.width < 1 || image.height < 1 ||
        image.pixels.size() != image.index(0, image.height))
        return fail(Failure::internal, "the image of a light has one or three channels and a buffer of its size");
    if (const std::optional<PlaceInImage> bad = first_bad(image))
        return fail(Failure::malformed,
                    fmt::format("the pixel in column {}, row {} cannot be light: it is negative or not finite",
                                bad->column + 1, bad->row + 1),
                    "clean the image first");
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto plane = [&](const auto& value_of) -> std::shared_ptr<const ImagePlane> {
        std::vector<float> values(count);
        bool is_black = true;
        for (std::size_t i = 0; i < count; ++i) {
            values[i] = static_cast<float>(value_of(i));
            is_black = is_black && !(values[i] > 0.0F);
        }
        return is_black ? nullptr : std::make_shared<const ImagePlane>(image.width, image.height, std::move(values));
    };
    LightImage made;
    if (image.channels == 1) {
        made.luminance_ = plane([&](std::size_t i) { return image.pixels[i]; });
    } else {
        const auto of = [&](std::size_t i, std::size_t c) { return static_cast<double>(image.pixels[3 * i + c]); };
        made.luminance_ = plane([&](std::size_t i) {
            return of(i, 0) * rec709_luminance.x + of(i, 1) * rec709_luminance.y + of(i, 2) * rec709_luminance.z;
        });
        for (std::size_t i = 0; i < count && !made.is_colored_; ++i)
            made.is_colored_ = of(i, 0) != of(i, 1) || of(i, 1) != of(i, 2);
    }
    if (made.luminance_ == nullptr)
        return fail(Failure::malformed, "the image is black: no light passes it",
                    "white lets all of the light through");
    if (!made.is_colored_) return made;
    for (std::size_t c = 0; c < made.colors_.size(); ++c) {
        ImageColor& color = made.colors_.at(c);
        color.plane = plane([&](std::size_t i) { return image.pixels[3 * i + c]; });
        if (color.plane == nullptr) continue;
        color.share = color.plane->peak() * rec709_luminance[static_cast<int>(c)] / made.luminance_->peak();
    }
    return made;
}

bool names_image(std::string_view file) {
    const std::size_t dot = file.rfind('.');
    if (dot == std::string_view::npos) return false;
    std::string extension(file.substr(dot + 1));
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    // Those of gonio/media/image_file.hpp: a test compares.
    constexpr std::array<std::string_view, 7> known{"exr", "png", "tif", "tiff", "hdr", "jpg", "jpeg"};
    return std::find(known.begin(), known.end(), extension) != known.end();
}

void set_light_image_reader(LightImageReader reader) {
    the_reader = reader;
}

Result<LightImage> read_light_image(const std::string& file, Diagnostics& diagnostics) {
    const LightImageReader reader = the_reader;
    if (reader == nullptr)
        return fail(Failure::unsupported, "images as masks need a reader of picture files",
                    "gonio::media::enable_light_images() sets one", file);
    return reader(file, diagnostics);
}

glm::dvec2 covered_by_image(const Shape& shape) {
    if (const auto* const spot = std::get_if<SpotShape>(&shape)) return glm::dvec2(std::tan(spot->outer.value));
    if (const auto* const frustum = std::get_if<FrustumShape>(&shape))
        return {std::tan(0.5 * frustum->horizontal.value), std::tan(0.5 * frustum->vertical.value)};
    return glm::dvec2(0.0);
}

double image_share(const Shape& shape, const ImagePlane& image, const glm::dvec3& direction) {
    if (std::holds_alternative<RectShape>(shape)) return image.mean();
    return projected(covered_by_image(shape), image, direction);
}

Steradians image_solid_angle(const Shape& shape, const ImagePlane& image) {
    return std::visit([&](const auto& kind) { return solid_angle_of(kind, image); }, shape);
}

glm::dvec2 place_on(const RectShape& rect, double x_m, double y_m) {
    return {0.5 - x_m / rect.width.value, 0.5 - y_m / rect.height.value};
}

} // namespace gonio
