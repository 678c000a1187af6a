// Debug views of which light shadow rays ask.
#include "layers/light_layers.h"

#include <algorithm>
#include <unordered_map>

#include "base/film_pixel.h"

namespace aips {
namespace {

struct LikeliestLight {
    float number = 0;  ///< from 1
    float share = 0;
};

LikeliestLight likeliest(const DiscreteDistribution& choice) {
    LikeliestLight best;
    for (std::size_t i = 0; i < choice.size(); ++i) {
        const float share = choice.pdf(i);
        if (share > best.share) best = {float(i + 1), share};
    }
    return best;
}

}  // namespace

LightLayers::LightLayers(Film& film) : film_(film) {
    const std::size_t pixels = std::size_t{film.width()} * film.height();
    lights_.resize(pixels);
    shares_.resize(pixels);
}

void LightLayers::show(const EyeImage& image, const DirectLight& lights) {
    std::fill(lights_.begin(), lights_.end(), 0.0f);
    std::fill(shares_.begin(), shares_.end(), 0.0f);
    // Many points share a choice, and there may be many lights.
    std::unordered_map<const DiscreteDistribution*, LikeliestLight> known;
    for (const VisiblePoint& point : image.visible_points) {
        const DiscreteDistribution& choice =
            lights.choice_at(point.position, point.geometric_normal);
        const auto [entry, added] = known.try_emplace(&choice);
        if (added) entry->second = likeliest(choice);
        const std::size_t pixel =
            film_pixel(image.positions[point.sample], film_.width(), film_.height());
        lights_[pixel] = entry->second.number;
        shares_[pixel] = entry->second.share;
    }
    film_.set_layer("lightchoice", lights_);
    film_.set_layer("lightshare", shares_);
}

std::size_t LightLayers::memory_bytes() const {
    return (lights_.capacity() + shares_.capacity()) * sizeof(float);
}

std::size_t LightLayers::memory_bound_bytes(std::size_t pixels) {
    return 2 * pixels * sizeof(float);
}

}  // namespace aips
