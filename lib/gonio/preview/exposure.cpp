#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/preview/exposure.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

// The sum of many logarithms as that of their products: all luminances are floats.
class Logarithms {
public:
    void add(double luminance) {
        product_ *= luminance;
        if (++factors_ == 6) take_product(); // of one more, a denormal number might be lost
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

// Lit pixels with weights that add up to their number. A picture is read again for a quantile: a copy of its luminances
// would take longer to write.
class MeteredPixels {
public:
    MeteredPixels(const Image& rgb_nits, std::span<const std::uint8_t> left_out, std::span<const std::uint8_t> subject,
                  unsigned threads)
        : rgb_nits_(rgb_nits),
          left_out_(left_out),
          subject_(subject),
          count_of_pixels_(rgb_nits.pixels.size() / 3),
          threads_(threads),
          bins_(bin_count) {
        struct Sums {
            std::vector<Bin> bins;
            Logarithms of_subject, of_others;
        };
        std::vector<Sums> of_pieces(pieces());
        parallel_for(pieces(), threads_, [&](std::size_t piece) {
            Sums sums;
            sums.bins.resize(bin_count);
            for_each(piece, [&](double luminance, bool is_subject) {
                ++sums.bins[bin_of(luminance)].count[is_subject ? 1 : 0];
                (is_subject ? sums.of_subject : sums.of_others).add(luminance);
            });
            of_pieces[piece] = std::move(sums);
        });
        double of_subject = 0.0;
        double of_others = 0.0;
        Bin all;
        for (Sums& sums : of_pieces) {
            of_subject += sums.of_subject.sum();
            of_others += sums.of_others.sum();
            for (std::size_t i = 0; i < bin_count; ++i)
                for (std::size_t k = 0; k < 2; ++k) {
                    bins_[i].count[k] += sums.bins[i].count[k];
                    all.count[k] += sums.bins[i].count[k];
                }
        }
        const auto subjects = static_cast<double>(all.count[1]);
        count_ = static_cast<double>(all.count[0]) + subjects;
        if (subjects > 0.0 && subjects < least_share_of_subject * count_) {
            subject_weight_ = least_share_of_subject * count_ / subjects;
            other_weight_ = (1.0 - least_share_of_subject) * count_ / (count_ - subjects);
        }
        logarithms_ = subject_weight_ * of_subject + other_weight_ * of_others;
    }

    // The rest is for pictures with lit pixels.
    double count() const { return count_; }
    double geometric_mean() const { return std::exp(logarithms_ / count_); }

    // The luminance, but at least and at most those that one in so many of the weight is above.
    double between_one_in(double least_share, double most_share, double luminance) const {
        const Quantile least = quantile(least_share);
        const Quantile most = quantile(most_share);
        const std::size_t bin = bin_of(luminance);
        if (bin >= most.bin) luminance = std::min(luminance, below(most));
        if (bin <= least.bin) luminance = std::max(luminance, below(least));
        return luminance;
    }

private:
    struct Metered {
        double luminance;
        bool is_subject;
    };
    using Pixels = std::vector<Metered>;
    struct Bin {
        std::array<std::size_t, 2> count{}; // of others, and of the subject
    };
    // A luminance in a bin below which its pixels weigh `left`.
    struct Quantile {
        std::size_t bin = 0;
        double left = 0.0;
    };

    // By the exponent and the first bits of the fraction of a luminance as a float: eight bins for an octave.
    static constexpr std::size_t bin_count = 2048;
    static std::size_t bin_of(double luminance) {
        return __builtin_bit_cast(std::uint32_t, static_cast<float>(luminance)) >> 20U;
    }

    // The same ones at any number of threads.
    static constexpr std::size_t piece_size = 1 << 16;
    std::size_t pieces() const { return (count_of_pixels_ + piece_size - 1) / piece_size; }

    // work(luminance, whether it is of the subject)
    template<class Work>
    void for_each(std::size_t piece, const Work& work) const {
        const float* const values = rgb_nits_.pixels.data();
        const std::size_t end = std::min((piece + 1) * piece_size, count_of_pixels_);
        for (std::size_t i = piece * piece_size; i < end; ++i) {
            if (!left_out_.empty() && left_out_[i] != 0) continue;
            const double y =
                glm::dot(glm::dvec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]), rec709_luminance);
            if (y > 0.0) work(y, !subject_.empty() && subject_[i] != 0);
        }
    }

    double weight_of(const Bin& bin) const {
        return subject_weight_ * static_cast<double>(bin.count[1]) + other_weight_ * static_cast<double>(bin.count[0]);
    }
    double weight_of(Pixels::const_iterator first, Pixels::const_iterator last) const {
        Bin bin;
        for (; first != last; ++first)
            ++bin.count[first->is_subject ? 1 : 0];
        return weight_of(bin);
    }

    // That one in `share` of the weight is above.
    Quantile quantile(double share) const {
        double left = (count_ - 1.0) * (share - 1.0) / share; // the weight of what is below
        Quantile found;
        for (std::size_t i = 0; i < bin_count; ++i) {
            if (bins_[i].count[0] + bins_[i].count[1] == 0) continue;
            found = {i, left};
            const double weight = weight_of(bins_[i]);
            if (weight > left) break;
            left -= weight;
        }
        return found;
    }

    // Divides the pixels of the bin instead of sorting them.
    double below(const Quantile& quantile) const {
        std::vector<Pixels> of_pieces(pieces());
        parallel_for(pieces(), threads_, [&](std::size_t piece) {
            Pixels in_bin;
            for_each(piece, [&](double luminance, bool is_subject) {
                if (bin_of(luminance) == quantile.bin) in_bin.push_back({luminance, is_subject});
            });
            of_pieces[piece] = std::move(in_bin);
        });
        Pixels pixels;
        for (const Pixels& of_piece : of_pieces)
            pixels.insert(pixels.end(), of_piece.begin(), of_piece.end());
        double left = quantile.left;
        auto first = pixels.begin();
        auto last = pixels.end();
        while (last - first > 1) {
            const auto middle = first + (last - first) / 2;
            std::nth_element(first, middle, last,
                             [](const Metered& a, const Metered& b) { return a.luminance < b.luminance; });
            const double lower = weight_of(first, middle);
            if (lower > left) {
                last = middle;
            } else {
                left -= lower;
                first = middle;
            }
        }
        return first->luminance;
    }

    const Image& rgb_nits_;
    std::span<const std::uint8_t> left_out_, subject_;
    std::size_t count_of_pixels_;
    unsigned threads_;
    std::vector<Bin> bins_;
    double count_ = 0.0;
    double subject_weight_ = 1.0;
    double other_weight_ = 1.0;
    double logarithms_ = 0.0;
};

} // namespace

Nits white_luminance(Ev100 ev) {
    return Nits(1.2 * std::exp2(ev.value));
}

Ev100 auto_exposure(const Image& rgb_nits, std::span<const std::uint8_t> left_out,
                    std::span<const std::uint8_t> subject, unsigned threads) {
    const MeteredPixels pixels(rgb_nits, left_out, subject, threads);
    if (!(pixels.count() > 0.0)) return left_out.empty() ? Ev100(0.0) : auto_exposure(rgb_nits, {}, {}, threads);
    constexpr double middle_grey = 0.18;
    const double white = pixels.between_one_in(most_white, least_white, pixels.geometric_mean() / middle_grey);
    return Ev100(std::log2(white / 1.2));
}

Ev100 exposure_of_card(Lux on_card) {
    return Ev100(std::log2(on_card.value / (1.2 * std::numbers::pi)));
}

Lux card_illuminance(Ev100 ev) {
    return Lux(std::numbers::pi * white_luminance(ev).value);
}

bool reaches(const Image& rgb_nits, Nits nits) {
    const auto least = static_cast<float>(nits.value);
    unsigned any = 0; // not left early, so that it runs in packs
    for (const float value : rgb_nits.pixels)
        any |= value >= least ? 1U : 0U;
    return any != 0;
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
