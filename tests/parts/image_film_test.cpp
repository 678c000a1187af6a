// The ready film: two means with weights of their own, light groups and layers apart.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "aips/parts/image_film.h"
#include "aips/parts/uniform_sampler.h"

namespace aips::image_film_test {
namespace {

TEST(ImageFilm, EyePathsCountAlikeAndPhotonsByWeight) {
    ImageFilm film(2, 1);
    const std::array<Vec2, 2> positions{Vec2{0.2f, 0.5f}, Vec2{1.9f, 0.1f}};
    const std::array<Rgb, 2> dim{Rgb{1, 1, 1}, Rgb{2, 0, 0}}, bright{Rgb{3, 3, 3}, Rgb{4, 0, 0}};
    film.add_pass({.positions = positions, .eye = dim, .photons = bright, .photon_weight = 1});
    film.add_pass({.positions = positions, .eye = bright, .photons = dim, .photon_weight = 3});
    const std::vector<Rgb> image = film.image();
    EXPECT_FLOAT_EQ(image[0].g, 2 + (3 * 1 + 1 * 3) / 4.0f);
    EXPECT_FLOAT_EQ(image[1].r, 3 + (4 * 1 + 2 * 3) / 4.0f);
    EXPECT_FLOAT_EQ(film.eye_part()[1].r, 3);
    EXPECT_FLOAT_EQ(float(film.mean()), (luminance(image[0]) + luminance(image[1])) / 2);
}

TEST(ImageFilm, KeepsLightGroupsApart) {
    ImageFilm film(1, 1, 2);
    const std::array<Vec2, 1> positions{Vec2{0.5f, 0.5f}};
    const std::array<Rgb, 2> eye{Rgb{1, 0, 0}, Rgb{0, 2, 0}};
    film.add_pass({.positions = positions, .groups = 2, .eye = eye});
    EXPECT_EQ(film.image_of_group(0)[0], (Rgb{1, 0, 0}));
    EXPECT_EQ(film.image_of_group(1)[0], (Rgb{0, 2, 0}));
    EXPECT_EQ(film.image()[0], (Rgb{1, 2, 0}));
}

TEST(ImageFilm, RefusesPassesOfOtherLightGroups) {
    ImageFilm film(1, 1, 2);
    const std::array<Vec2, 1> positions{Vec2{0.5f, 0.5f}};
    const std::array<Rgb, 3> values{};
    const auto add = [&](std::uint32_t groups, std::size_t eye, std::size_t photons) {
        film.add_pass({.positions = positions,
                       .groups = groups,
                       .eye = std::span(values).first(eye),
                       .photons = std::span(values).first(photons)});
    };
    EXPECT_THROW(add(1, 1, 1), std::invalid_argument);
    EXPECT_THROW(add(3, 3, 3), std::invalid_argument);
    EXPECT_THROW(add(2, 1, 2), std::invalid_argument);
    EXPECT_THROW(add(2, 2, 1), std::invalid_argument);
    EXPECT_THROW(film.add_layer_pass("many", positions, values, 1), std::invalid_argument);
    EXPECT_NO_THROW(add(2, 2, 2));
    try {
        add(1, 1, 1);
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "ImageFilm: 1 light groups in a pass, expected 2");
    }
}

TEST(ImageFilm, WantsAValueForEachPixelOfALayer) {
    ImageFilm film(2, 2);
    EXPECT_THROW(film.set_layer("few", std::array<float, 3>{}), std::invalid_argument);
    film.set_layer("all", std::array<float, 4>{1, 2, 3, 4});
    EXPECT_EQ(film.layers().at("all")[2], 3);
}

/// The engine's eye paths draw by the same seed and index in the image's first row.
TEST(UniformSampler, DoesNotRepeatTheEnginesNumbers) {
    for (std::uint64_t index = 0; index < 4; ++index) {
        const CameraSample sample = UniformSampler(7).camera_sample(3, std::uint32_t(index), 0);
        for (const auto domain : {RandomDomain::Eye, RandomDomain::Photon, RandomDomain::Time}) {
            RandomStream engine(7, 3, index, domain);
            engine.next2();
            EXPECT_NE(sample.lens, engine.next2());
        }
    }
}

TEST(UniformSampler, StaysInItsPixelAndIsAPureFunction) {
    const UniformSampler sampler(7);
    double sum = 0;
    for (std::uint64_t n = 0; n < 1000; ++n) {
        const CameraSample sample = sampler.camera_sample(n, 5, 3);
        EXPECT_TRUE(sample.film.x >= 5 && sample.film.x < 6);
        EXPECT_TRUE(sample.film.y >= 3 && sample.film.y < 4);
        EXPECT_EQ(sample.film, sampler.camera_sample(n, 5, 3).film);
        sum += double(sample.film.x) - 5;
    }
    EXPECT_NEAR(sum / 1000, 0.5, 4 * std::sqrt(1.0 / 12 / 1000));
}

}  // namespace
}  // namespace aips::image_film_test
