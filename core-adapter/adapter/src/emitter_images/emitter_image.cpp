// Ellipses on the film.
#include "emitter_images/emitter_image.h"

#include <algorithm>
#include <cmath>

#include "aips/core/sampling/sampling.h"

namespace aips {
namespace {

double determinant(const std::array<float, 4>& m) {
    return double(m[0]) * double(m[3]) - double(m[1]) * double(m[2]);
}

}  // namespace

double EmitterImage::area() const {
    return double(kPi) * std::abs(determinant(axes));
}

double EmitterImage::choice_volume() const {
    double volume = 1;
    for (std::size_t i = 0; i < low.size(); ++i)
        volume *= double(high[i]) - double(low[i]);
    return volume;
}

double EmitterImage::pdf(Vec2 film, const SpecularChoices& choices) const {
    for (std::size_t i = 0; i < low.size(); ++i) {
        if (!(choices[i] >= low[i] && choices[i] < high[i])) return 0;
    }
    const double x = double(film.x) - double(centre.x), y = double(film.y) - double(centre.y);
    const double d = determinant(axes);
    const double u = (double(axes[3]) * x - double(axes[1]) * y) / d;
    const double v = (double(axes[0]) * y - double(axes[2]) * x) / d;
    return u * u + v * v <= 1 ? 1 / (double(kPi) * std::abs(d) * choice_volume()) : 0;
}

Vec2 EmitterImage::reach() const {
    return {std::hypot(axes[0], axes[1]), std::hypot(axes[2], axes[3])};
}

Vec2 EmitterImage::film_at(Vec2 disc) const {
    return {centre.x + axes[0] * disc.x + axes[1] * disc.y,
            centre.y + axes[2] * disc.x + axes[3] * disc.y};
}

SpecularChoices EmitterImage::choices_at(const SpecularChoices& u) const {
    SpecularChoices at;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const float x = low[i] + (high[i] - low[i]) * u[i];
        at[i] = std::clamp(x, low[i], std::nextafter(high[i], 0.0f));
    }
    return at;
}

}  // namespace aips
