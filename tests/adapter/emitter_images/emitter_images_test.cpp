// Protects the density of emitter paths: it is that of what is drawn, eye paths and emitter paths
// together estimate what eye paths alone do, wherever images lie upon each other or cross the
// film's border; images are kept once, as far as there is room for them, and come back from a saved
// state.
#include "emitter_images/emitter_images.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aips/core/sampling/random.h"
#include "emitter_images/constants.h"
#include "state/memory_archive.h"

namespace aips::emitter_images_test {
namespace {

constexpr std::uint32_t kWidth = 5, kHeight = 4;

EmitterImage image_at(Vec2 centre, std::array<float, 4> axes, float luminance = 1) {
    EmitterImage image;
    image.centre = centre;
    image.axes = axes;
    image.luminance = luminance;
    return image;
}

/// Three of which two overlap, one by half of all choices; one reaches beyond the film.
std::vector<EmitterImage> some_images() {
    std::vector<EmitterImage> images = {image_at({2.3f, 1.6f}, {0.4f, 0, 0.1f, 0.2f}),
                                        image_at({2.4f, 1.7f}, {0.05f, 0, -0.1f, 0.3f}, 40),
                                        image_at({0.05f, 3.9f}, {0.2f, 0, 0, 0.2f}, 5)};
    images[0].low[1] = 0.5f;
    images[0].high[3] = 0.7f;
    return images;
}

EmitterImages known_images(const std::vector<EmitterImage>& images) {
    EmitterImages known(kWidth, kHeight, 1);
    known.add(images);
    known.begin_pass(3);
    return known;
}

/// What a path is taken to see there: something that varies over film and choices.
double seen(Vec2 film, const SpecularChoices& c) {
    return (1 + std::sin(9 * double(film.x) + 4 * double(film.y))) * (0.2 + double(c[1])) *
           (c[3] < 0.6f ? 1 : 0.1);
}

bool on_film(Vec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < kWidth && at.y < kHeight;
}

struct Estimate {
    double sum = 0, squares = 0, count = 0;
    void add(double x) {
        sum += x;
        squares += x * x;
        count += 1;
    }
    double mean() const { return sum / count; }
    double variance() const { return (squares / count - mean() * mean()) / count; }
};

TEST(EmitterImage, DensityIsOneOverItsSizeWithinAndIntegratesToOne) {
    const EmitterImage image = some_images()[0];
    RandomStream random(1, 0, 0, RandomDomain::Guide);
    Estimate integral;
    for (int i = 0; i < 400000; ++i) {
        const Vec2 at{2.3f + 1.2f * (random.next() - 0.5f), 1.6f + 1.2f * (random.next() - 0.5f)};
        const SpecularChoices c{random.next(), random.next(), random.next(), random.next()};
        integral.add(1.2 * 1.2 * image.pdf(at, c));
    }
    EXPECT_NEAR(integral.mean(), 1, 4 * std::sqrt(integral.variance()));
    EXPECT_LT(std::sqrt(integral.variance()), 0.01);
    EXPECT_NEAR(image.pdf(image.centre, {0, 0.9f, 0, 0.1f}), 1 / (image.area() * 0.5 * 0.7), 1e-3);
    EXPECT_EQ(image.pdf(image.centre, {0, 0.4f, 0, 0.1f}), 0) << "other choices";
    EXPECT_EQ(image.pdf({2.3f + 0.45f, 1.6f}, {0, 0.9f, 0, 0.1f}), 0) << "outside";
}

TEST(EmitterImages, EyePathsAndEmitterPathsTogetherSeeAllOnce) {
    const EmitterImages known = known_images(some_images());
    ASSERT_EQ(known.all().size(), 3u);
    ASSERT_GT(known.paths(), 0u);
    RandomStream random(2, 0, 0, RandomDomain::Guide);
    Estimate left, lamp;
    constexpr double kPixels = kWidth * kHeight;
    for (int i = 0; i < 2000000; ++i) {
        const Vec2 at{kWidth * random.next(), kHeight * random.next()};
        const SpecularChoices c{random.next(), random.next(), random.next(), random.next()};
        left.add(seen(at, c) * (1 - known.eye_share(at, c)));
    }
    for (std::uint64_t pass = 0; pass < 100000; ++pass) {
        double sum = 0;
        for (std::uint32_t i = 0; i < known.paths(); ++i) {
            const EmitterDraw draw = known.draw(7, pass, i);
            if (!on_film(draw.film)) continue;
            const double share = known.eye_share(draw.film, draw.choices);
            if (share < 1) sum += seen(draw.film, draw.choices) * share / kPixels;
        }
        lamp.add(sum);
    }
    const double error = std::sqrt(left.variance() + lamp.variance());
    EXPECT_LT(error, 0.015 * lamp.mean());
    EXPECT_NEAR(lamp.mean(), left.mean(), 3.5 * error) << "what eye paths leave";
}

TEST(EmitterImages, TakesEachImageOnceAndNoneThatAPixelCannotHold) {
    EmitterImages known(kWidth, kHeight, 1);
    const EmitterImage image = image_at({1.5f, 1.5f}, {0.02f, 0, 0, 0.02f});
    EmitterImage shifted = image, larger = image, far = image, outside = image, flat = image;
    shifted.centre.x += 0.005f;
    larger.axes = {0.1f, 0, 0, 0.1f};
    far.axes = {9, 0, 0, 0.001f};
    outside.centre.x = -0.01f;
    flat.axes[3] = 0;
    known.add(std::vector{image, image, shifted});
    EXPECT_EQ(known.all().size(), 1u) << "the same again";
    known.add(std::vector{larger});
    EXPECT_EQ(known.all().size(), 2u) << "another at the same place";
    known.add(std::vector{far, outside, flat, image_at({1, 1}, {1, 0, 0, 1})});
    EXPECT_EQ(known.all().size(), 2u);
    known.add(std::vector{image_at({std::nanf(""), 1}, {0.1f, 0, 0, 0.1f})});
    EXPECT_EQ(known.all().size(), 2u);
}

TEST(EmitterImages, WithoutAnyNoPathIsDrawnAndEyePathsCountInFull) {
    EmitterImages known(kWidth, kHeight, 1);
    known.begin_pass(0);
    EXPECT_EQ(known.paths(), 0u);
    EXPECT_EQ(known.eye_share({1, 1}, {}), 1);
}

TEST(EmitterImages, MemoryStaysBelowItsBoundHoweverManyAreFound) {
    constexpr std::uint32_t kSize = 256;
    EmitterImages known(kSize, kSize, 1);
    std::vector<EmitterImage> images;
    RandomStream random(3, 0, 0, RandomDomain::Guide);
    for (std::size_t i = 0; i < 3 * kMostImages; ++i) {
        images.push_back(image_at({kSize * random.next(), kSize * random.next()},
                                  {0.7f * random.next(), 0, 0, 0.002f}));
    }
    known.add(images);
    known.begin_pass(1);
    EXPECT_GT(known.all().size(), kMostImages / 2);
    EXPECT_LE(known.all().size(), kMostImages);
    EXPECT_LE(known.memory_bytes(), EmitterImages::memory_bound_bytes(std::size_t{kSize} * kSize));
}

TEST(EmitterImages, ComeBackFromASavedState) {
    EmitterImages known = known_images(some_images()), restored(kWidth, kHeight, 1);
    mock::Saving saving;
    known.state(saving);
    mock::Restoring restoring(saving.saved());
    restored.state(restoring);
    EXPECT_EQ(restoring.remaining(), 0u);
    restored.begin_pass(3);
    ASSERT_EQ(restored.paths(), known.paths());
    for (std::uint32_t i = 0; i < known.paths(); ++i) {
        const EmitterDraw a = known.draw(1, 9, i), b = restored.draw(1, 9, i);
        EXPECT_EQ(a.film, b.film);
        EXPECT_EQ(a.choices, b.choices);
        EXPECT_EQ(known.eye_share(a.film, a.choices), restored.eye_share(a.film, a.choices));
    }
}

}  // namespace
}  // namespace aips::emitter_images_test
