// Films and samples for tests of the film's sums.
#pragma once

#include <memory>
#include <random>
#include <vector>

#include "lxs/imaging/imaging.h"
#include "scene_options.h"

namespace lxs::test {

inline std::unique_ptr<FileFilm> make(const SceneContents& contents) {
    RecordedDiagnostics diagnostics;
    return make_film(contents, diagnostics);
}

struct Samples {
    std::vector<Vec2> positions;
    std::vector<Rgb> radiance;

    PassSamples pass(double weight = 1, std::uint32_t groups = 1) const {
        return {positions, radiance, groups, weight};
    }
};

/// `count` samples at random places; radiance of each group from `value(random number)`.
template <class Value>
Samples random_samples(const Film& film, std::size_t count, unsigned seed, const Value& value) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> x(0, static_cast<float>(film.width()));
    std::uniform_real_distribution<float> y(0, static_cast<float>(film.height()));
    std::uniform_real_distribution<float> unit(0, 1);
    Samples samples;
    for (std::size_t i = 0; i < count; ++i) {
        samples.positions.emplace_back(x(generator), y(generator));
        for (std::uint32_t g = 0; g < film.light_groups(); ++g) {
            samples.radiance.push_back(value(unit(generator)));
        }
    }
    return samples;
}

/// One sample in the middle of every pixel.
inline Samples pixel_centres(const Film& film, const Rgb& radiance) {
    Samples samples;
    for (std::uint32_t y = 0; y < film.height(); ++y) {
        for (std::uint32_t x = 0; x < film.width(); ++x) {
            samples.positions.emplace_back(static_cast<float>(x) + 0.5f,
                                           static_cast<float>(y) + 0.5f);
            samples.radiance.push_back(radiance);
        }
    }
    return samples;
}

}  // namespace lxs::test
