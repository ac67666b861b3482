#include <gonio/light/light_color.hpp>
#include <gonio/preview/exposure.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio {

namespace {

// One in so many pixels of an automatic exposure is white, at most and at least.
constexpr double most_white = 40.0;
constexpr double least_white = 200.0;

// Of the weight of all lit pixels.
constexpr double least_share_of_subject = 0.5;

struct Metered {
    double luminance;
    bool is_subject;
};

// Lit pixels with weights that add up to their number.
class MeteredPixels {
public:
    explicit MeteredPixels(std::vector<Metered> pixels) : pixels_(std::move(pixels)), rest_(pixels_.begin()) {
        const double of_subject = subjects(pixels_.begin(), pixels_.end());
        const bool is_small = of_subject > 0.0 && of_subject < least_share_of_subject * count();
        if (!is_small) return;
        subject_weight_ = least_share_of_subject * count() / of_subject;
        other_weight_ = (1.0 - least_share_of_subject) * count() / (count() - of_subject);
    }

    double count() const { return static_cast<double>(pixels_.size()); }

    double geometric_mean() const {
        Logarithms of_subject;
        Logarithms of_others;
        for (const Metered& pixel : pixels_)
            (pixel.is_subject ? of_subject : of_others).add(pixel.luminance);
        return std::exp((subject_weight_ * of_subject.sum() + other_weight_ * of_others.sum()) / count());
    }

    // The luminance that one in `share` of the weight is above; each call with a greater share than the one before. It
    // divides the pixels instead of sorting them.
    double below_one_in(double share) {
        const double below = (count() - 1.0) * (share - 1.0) / share;
        auto last = pixels_.end();
        while (last - rest_ > 1) {
            const auto middle = rest_ + (last - rest_) / 2;
            std::nth_element(rest_, middle, last,
                             [](const Metered& a, const Metered& b) { return a.luminance < b.luminance; });
            const double lower = weight(rest_, middle);
            if (left_ + lower > below) {
                last = middle;
            } else {
                left_ += lower;
                rest_ = middle;
            }
        }
        return rest_->luminance;
    }

private:
    using Pixels = std::vector<Metered>;

    // The sum of many logarithms as that of their products: all luminances are floats.
    class Logarithms {
    public:
        void add(double luminance) {
            product_ *= luminance;
            if (++factors_ == 4) take_product();
        }
        double sum() {
            take_product();
            return sum_;
        }

    private:
        void take_product() {
            sum_ += std::log(product_);
            product_ = 1.0;
            factors_ = 0;
        }

        double sum_ = 0.0;
        double product_ = 1.0;
        int factors_ = 0;
    };

    static double subjects(Pixels::const_iterator first, Pixels::const_iterator last) {
        return static_cast<double>(std::count_if(first, last, [](const Metered& pixel) { return pixel.is_subject; }));
    }
    double weight(Pixels::const_iterator first, Pixels::const_iterator last) const {
        const double of_subject = subjects(first, last);
        return subject_weight_ * of_subject + other_weight_ * (static_cast<double>(last - first) - of_subject);
    }

    Pixels pixels_;
    double subject_weight_ = 1.0;
    double other_weight_ = 1.0;
    Pixels::iterator rest_; // all before it are at most as bright, and weigh `left_`
    double left_ = 0.0;
};

} // namespace

Nits white_luminance(Ev100 ev) {
    return Nits(1.2 * std::exp2(ev.value));
}

Ev100 auto_exposure(const Image& rgb_nits, std::span<const std::uint8_t> left_out,
                    std::span<const std::uint8_t> subject) {
    std::vector<Metered> lit;
    lit.reserve(rgb_nits.pixels.size() / 3);
    for (std::size_t i = 0; i + 2 < rgb_nits.pixels.size(); i += 3) {
        if (!left_out.empty() && left_out[i / 3] != 0) continue;
        const glm::dvec3 rgb(rgb_nits.pixels[i], rgb_nits.pixels[i + 1], rgb_nits.pixels[i + 2]);
        const double y = glm::dot(rgb, rec709_luminance);
        if (y > 0.0) lit.push_back({y, !subject.empty() && subject[i / 3] != 0});
    }
    if (lit.empty()) return left_out.empty() ? Ev100(0.0) : auto_exposure(rgb_nits);
    MeteredPixels pixels(std::move(lit));
    constexpr double middle_grey = 0.18;
    const double from_mean = pixels.geometric_mean() / middle_grey;
    const double least = pixels.below_one_in(most_white);
    const double most = pixels.below_one_in(least_white);
    return Ev100(std::log2(std::clamp(from_mean, least, most) / 1.2));
}

Ev100 exposure_of_card(Lux on_card) {
    return Ev100(std::log2(on_card.value / (1.2 * std::numbers::pi)));
}

Lux card_illuminance(Ev100 ev) {
    return Lux(std::numbers::pi * white_luminance(ev).value);
}

void expose(Image& image, Ev100 ev) {
    const double factor = 1.0 / white_luminance(ev).value;
    const auto scale = static_cast<float>(factor);
    if (std::isfinite(scale)) {
        for (float& value : image.pixels)
            value *= scale;
        return;
    }
    for (float& value : image.pixels) // almost no light: black stays black
        value = static_cast<float>(static_cast<double>(value) * factor);
}

} // namespace gonio
