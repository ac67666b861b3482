#include <gonio/base/frame.hpp>
#include <gonio/base/gauss_legendre.hpp>
#include <gonio/light/far_field.hpp>
#include <gonio/light/luminances.hpp>
#include <gonio/web/quick_web.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <variant>
#include <vector>

namespace gonio {

namespace {

constexpr double golden_angle = 2.399963229728653;
constexpr double share_of_light = 0.95;

// A small piece of a face.
struct Element {
    glm::dvec3 position;
    glm::dvec3 normal;
    double area_m2;
};

glm::dvec3 on_spiral(int i, int count) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    return {r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z};
}

// On [-1, 1].
constexpr auto along_side = gauss_legendre<4>();
constexpr auto rings = gauss_legendre<3>();
constexpr auto rings_of_cap = gauss_legendre<4>();
constexpr int points_of_ring = 8;

// work(node, cosine and sine of the azimuth, share of all points) for the points of rings, each turned against the one
// before.
template<class Rule, class Work>
void for_each_on_rings(const Rule& rule, const Work& work) {
    double turn = 0.0;
    for (const QuadratureNode& ring : rule) {
        for (int i = 0; i < points_of_ring; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + turn) / points_of_ring;
            work(ring.at, std::cos(angle), std::sin(angle), 0.5 * ring.weight / points_of_ring);
        }
        turn = 0.5 - turn;
    }
}

// The part of a sphere about the middle that a receiver in a direction sees, in `points_of_cap` elements: rings about
// the direction, so that none is at the edge of what is seen.
constexpr std::size_t points_of_cap = rings_of_cap.size() * points_of_ring;
void find_cap(const SphereShape& sphere, double area_m2, const glm::dvec3& direction, double distance_m, Element* to) {
    const Frame about = aimed_frame(glm::dvec3(0.0), direction, {0.0, 0.0, 1.0});
    const double least = std::min(sphere.radius.value / distance_m, 1.0); // cosine to the direction
    const double half = 0.5 * (1.0 - least);
    for_each_on_rings(rings_of_cap, [&](double at, double cosine, double sine, double share) {
        const double z = least + half * (1.0 + at);
        const double r = std::sqrt((1.0 - z) * (1.0 + z));
        const glm::dvec3 normal = z * direction + r * (cosine * about.x + sine * about.y);
        *to++ = {sphere.radius.value * normal, normal, half * share * area_m2};
    });
}

struct ElementsOf {
    const LuminousFace& face;
    std::vector<Element>& to;

    void operator()(const RectShape& rect) const {
        for (const QuadratureNode& x : along_side)
            for (const QuadratureNode& y : along_side)
                add(0.5 * x.at * rect.width.value, 0.5 * y.at * rect.height.value, 0.25 * x.weight * y.weight);
    }
    void operator()(const DiskShape& disk) const { round(disk.radius.value, disk.radius.value); }
    void operator()(const EllipseShape& ellipse) const { round(0.5 * ellipse.width.value, 0.5 * ellipse.height.value); }
    // Room for those that find_cap() finds.
    void operator()(const SphereShape& /*sphere*/) const { to.resize(to.size() + points_of_cap); }
    template<class Kind>
    void operator()(const Kind& /*no face*/) const {}

private:
    // Rings that are uniform in area.
    void round(double half_x, double half_y) const {
        for_each_on_rings(rings, [&](double at, double cosine, double sine, double share) {
            const double r = std::sqrt(0.5 * (1.0 + at));
            add(half_x * r * cosine, half_y * r * sine, share);
        });
    }
    void add(double x, double y, double share) const {
        to.push_back({face.frame.origin + x * face.frame.x + y * face.frame.y, face.normal, face.area_m2 * share});
    }
};

// How far a face reaches from the middle of the body [m].
struct FarthestOf {
    const LuminousFace& face;

    double operator()(const RectShape& rect) const {
        double farthest_m = 0.0;
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
                farthest_m = std::max(farthest_m, distance_m(x * rect.width.value, y * rect.height.value));
        return farthest_m;
    }
    double operator()(const DiskShape& disk) const { return of_rim(disk.radius.value, disk.radius.value); }
    double operator()(const EllipseShape& ellipse) const {
        return of_rim(0.5 * ellipse.width.value, 0.5 * ellipse.height.value);
    }
    double operator()(const SphereShape& sphere) const { return sphere.radius.value; }
    template<class Kind>
    double operator()(const Kind& /*no face*/) const {
        return 0.0;
    }

private:
    double of_rim(double half_x, double half_y) const {
        constexpr int points = 32;
        double farthest_m = 0.0;
        for (int i = 0; i < points; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / points;
            farthest_m = std::max(farthest_m, distance_m(half_x * std::cos(angle), half_y * std::sin(angle)));
        }
        return farthest_m;
    }
    double distance_m(double x, double y) const {
        return glm::length(face.frame.origin + x * face.frame.x + y * face.frame.y);
    }
};

// The faces' elements as a receiver sees them.
class Elements {
public:
    Elements(const LuminousBody& body, const Web& web) : body_(body), quick_(web) {
        for (const LuminousFace& face : body.faces()) {
            std::vector<Element> elements;
            std::visit(ElementsOf{face, elements}, face.shape);
            size_m_ = std::max(size_m_, 2.0 * std::visit(FarthestOf{face}, face.shape));
            faces_.push_back({&face, all_.size(), all_.size() + elements.size()});
            all_.insert(all_.end(), elements.begin(), elements.end());
        }
        for (std::vector<double>* const numbers : {&x_, &y_, &z_, &distance_m_, &projected_m3_, &candela_, &weights_})
            numbers->resize(all_.size());
    }

    [[nodiscard]] double size_m() const { return size_m_; }

    // The illuminance of a receiver that faces the middle, from a direction with some light, over that of a point. The
    // distance is above half the size, so no element is behind the receiver.
    [[nodiscard]] double over_point(const glm::dvec3& direction, double candela, double distance_m) {
        std::size_t count = 0;
        for (const Face& face : faces_) {
            // All elements of a flat face are as far in front of the receiver or behind it, but for rounding.
            const bool is_flat = face.of->is_flat;
            const double in_front_m = glm::dot(distance_m * direction - face.of->frame.origin, face.of->normal);
            if (is_flat && in_front_m < -1e-9 * size_m_) continue;
            const bool is_surely_lit = is_flat && in_front_m > 1e-9 * size_m_;
            if (const auto* const sphere = std::get_if<SphereShape>(&face.of->shape))
                find_cap(*sphere, face.of->area_m2, direction, distance_m, all_.data() + face.first);
            for (std::size_t i = face.first; i < face.end; ++i) {
                const Element& element = all_[i];
                const glm::dvec3 away = distance_m * direction - element.position;
                const double at_light_m = glm::dot(away, element.normal);
                if (!is_surely_lit && !(at_light_m > 0.0)) continue;
                x_[count] = away.x;
                y_[count] = away.y;
                z_[count] = away.z;
                weights_[count] = at_light_m * glm::dot(away, direction) * element.area_m2;
                ++count;
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            distance_m_[i] = std::sqrt(x_[i] * x_[i] + y_[i] * y_[i] + z_[i] * z_[i]);
        const auto some = [count](std::vector<double>& numbers) { return std::span(numbers.data(), count); };
        projected_areas(body_, some(x_), some(y_), some(z_), some(distance_m_), some(projected_m3_));
        quick_.candela(some(x_), some(y_), some(z_), some(candela_));
        for (std::size_t i = 0; i < count; ++i) {
            const double r = distance_m_[i];
            weights_[i] *= std::max(candela_[i], 0.0) / (projected_m3_[i] * (r * r * r));
        }
        double lx = 0.0;
        for (std::size_t i = 0; i < count; ++i)
            lx += weights_[i];
        return lx * distance_m * distance_m / candela;
    }

private:
    struct Face {
        const LuminousFace* of;
        std::size_t first; // of its elements
        std::size_t end;
    };

    const LuminousBody& body_;
    QuickWeb quick_;
    std::vector<Element> all_;
    std::vector<Face> faces_;
    double size_m_ = 0.0;
    // Of the elements that shine on the receiver: the way to it, and what their light is multiplied by.
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> z_;
    std::vector<double> distance_m_;
    std::vector<double> projected_m3_;
    std::vector<double> candela_;
    std::vector<double> weights_;
};

// The directions of the sphere in which there is light, and which of them see the elements as a point.
class Directions {
public:
    Directions(Elements& elements, const Web& web) : elements_(elements) {
        constexpr int directions = 120;
        for (int i = 0; i < directions; ++i) {
            const glm::dvec3 direction = on_spiral(i, directions);
            const double candela = web.candela(direction);
            if (!(candela > 0.0)) continue;
            lit_.push_back({direction, candela, 0.0});
            all_ += candela;
        }
    }

    // The error that the directions of at most 5 % of the light exceed, estimated from every third of them.
    double estimate(double distance_m) {
        std::vector<Lit> some;
        double all = 0.0;
        for (std::size_t i = 0; i < lit_.size(); i += 3) {
            Lit& towards = lit_[i];
            towards.error = error_of(towards, distance_m);
            all += towards.candela;
            some.push_back(towards);
        }
        return quantile(some, all);
    }

    // The same from all of them.
    double error_at(double distance_m) {
        for (Lit& towards : lit_)
            towards.error = error_of(towards, distance_m);
        return quantile(lit_, all_);
    }

    // error_at() ≤ tolerance, by as few directions as decide it. Those that had the greatest errors come first: a
    // distance that is too near is found after a few.
    bool is_far(double distance_m, double tolerance) {
        sort();
        const double most = (1.0 - share_of_light) * all_;
        const double rounding = 1e-9 * all_; // of the sums
        double above = 0.0;
        double within = 0.0;
        for (Lit& towards : lit_) {
            towards.error = error_of(towards, distance_m);
            (towards.error <= tolerance ? within : above) += towards.candela;
            if (above > most + rounding) return false;
            if (all_ - within < most - rounding) return true;
        }
        return quantile(lit_, all_) <= tolerance;
    }

private:
    struct Lit {
        glm::dvec3 direction;
        double candela;
        double error; // when it was last looked at
    };

    static double quantile(std::vector<Lit>& directions, double all) {
        std::sort(directions.begin(), directions.end(), [](const Lit& a, const Lit& b) {
            return a.error > b.error || (a.error == b.error && a.candela > b.candela);
        });
        double above = 0.0;
        for (const Lit& towards : directions) {
            above += towards.candela;
            if (above > (1.0 - share_of_light) * all) return towards.error;
        }
        return 0.0;
    }

    void sort() {
        std::stable_sort(lit_.begin(), lit_.end(), [](const Lit& a, const Lit& b) { return a.error > b.error; });
    }

    [[nodiscard]] double error_of(const Lit& towards, double distance_m) {
        return std::abs(elements_.over_point(towards.direction, towards.candela, distance_m) - 1.0);
    }

    Elements& elements_;
    std::vector<Lit> lit_;
    double all_ = 0.0;
};

} // namespace

Meters point_distance(const LuminousBody& body, const Web& web, double tolerance) {
    Elements elements(body, web);
    Directions directions(elements, web);
    // Among steps of 5 % from 64 sizes, which count as far, down to one, the last that is far: the error is taken to
    // fall with the distance. It falls by nearly the square of it, which guesses the step.
    const double step = 1.05;
    const auto distance_after = [&](int count) { return 64.0 * elements.size_m() / std::pow(step, count); };
    int far = 0;
    int near = static_cast<int>(std::log(64.0) / std::log(step)) + 1;
    int next = (far + near) / 2;
    const auto guess = [&](double error) {
        const double more = 0.5 * std::log(error / tolerance) / std::log(step); // steps back to where it is far
        if (std::isfinite(more)) next = static_cast<int>(std::clamp(next - std::ceil(more), far + 1.0, near - 1.0));
    };
    guess(directions.estimate(distance_after(next)));
    const double error = directions.error_at(distance_after(next));
    (error <= tolerance ? far : near) = next;
    bool far_is_seen = far > 0;
    bool near_is_seen = !far_is_seen;
    if (near - far > 1) guess(error);
    // From the guess by strides that double until the last that is far lies between two.
    for (int stride = 1; near - far > 1; stride *= 2) {
        const bool is_far = directions.is_far(distance_after(next), tolerance);
        (is_far ? far : near) = next;
        (is_far ? far_is_seen : near_is_seen) = true;
        if (far_is_seen && near_is_seen)
            next = near - far > 8 ? (far + near) / 2 : near - 1; // what is near is found sooner
        else
            next = is_far ? std::min(far + stride, near - 1) : std::max(near - stride, far + 1);
    }
    return Meters(distance_after(far));
}

} // namespace gonio
