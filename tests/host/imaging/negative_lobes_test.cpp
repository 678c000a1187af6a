// Protects what the film does with pixels that negative lobes of its filter draw below zero: none
// is written, and the light of the image and of each of its layers stays.
#include "negative_lobes.h"

#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "film_samples.h"
#include "pixel_filter.h"
#include "run_on_threads.h"

namespace lxs::test::negative_lobes_test {
namespace {

std::vector<float> settled(const std::vector<float>& row, std::uint32_t reach) {
    std::vector<Rgb> pixels;
    pixels.reserve(row.size());
    for (const float value : row)
        pixels.emplace_back(value, 2.0f, -value);
    redistribute_negative_lobes({pixels, static_cast<std::uint32_t>(row.size()), 1, reach, reach});
    std::vector<float> result;
    for (const Rgb& pixel : pixels) {
        EXPECT_EQ(pixel.y, 2.0f) << "channels are settled each on its own";
        result.push_back(pixel.x);
    }
    return result;
}

using Row = std::vector<float>;

TEST(NegativeLobes, NeighboursPayByWhatTheyHave) {
    EXPECT_EQ(settled({-1, 5, 0}, 1), (Row{0, 4, 0}));
    EXPECT_EQ(settled({6, -2, 2}, 1), (Row{4.5, 0, 1.5}));
    EXPECT_EQ(settled({-2, 5, -2, 7}, 1)[0], 0);
    EXPECT_EQ(settled({1, 2, 3}, 1), (Row{1, 2, 3}));
}

TEST(NegativeLobes, WhoIsAskedForMoreThanItHasGivesItAll) {
    // The left 4 is asked for more than it has; what then is missing the right one pays, at last
    // from twice as far.
    const Row row = settled({0, 0, -3, 4, -3, 4, 0, 0}, 2);
    double sum = 0;
    for (const float value : row) {
        EXPECT_GE(value, 0);
        sum += double{value};
    }
    EXPECT_NEAR(sum, 2, 1e-6);
}

TEST(NegativeLobes, DeficitsWithoutLightAroundEndAtZero) {
    EXPECT_EQ(settled({-1, 0, 0, 0, 5}, 1), (Row{0, 0, 0, 0, 5})) << "too far away";
    EXPECT_EQ(settled({-1, 0, 5}, 1), (Row{0, 0, 4})) << "twice the reach, at last";
    EXPECT_EQ(settled({-3, 4, -3}, 1), (Row{0, 0, 0})) << "more deficits than light";
}

struct FilterChoice {
    const char* plugin;
    std::vector<ParameterValue> values;
};

const std::vector<FilterChoice>& filters_with_lobes() {
    static const std::vector<FilterChoice> filters{
        {"mitchell", {}},
        {"mitchell", {real("xwidth", 1.5), real("ywidth", 1.5)}},
        {"mitchell", {flag("supersample", true)}},
        {"catmullrom", {}},
        {"sinc", {real("xwidth", 3), real("ywidth", 3)}}};
    return filters;
}

SceneContents scene_with(const FilterChoice& filter, int size) {
    SceneContents contents = scene_of_size(size, size);
    set_option(contents, "PixelFilter", filter.plugin, filter.values);
    return contents;
}

constexpr int kPerAxis = 8;

/// An even grid of samples, 64 a pixel, each seeing `radiance` of its place; off the borders of the
/// cells of a filter's table.
template <class Radiance>
Samples grid_of_samples(const Film& film, const Radiance& radiance) {
    Samples samples;
    const auto columns = film.width() * kPerAxis, rows = film.height() * kPerAxis;
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const Vec2 p((static_cast<float>(i) + 0.37f) / kPerAxis,
                         (static_cast<float>(j) + 0.37f) / kPerAxis);
            samples.positions.push_back(p);
            samples.radiance.push_back(radiance(p));
        }
    }
    return samples;
}

double sum_of(const std::vector<Rgb>& values) {
    double sum = 0;
    for (const Rgb& c : values)
        sum += double{c.x} + double{c.y} + double{c.z};
    return sum;
}

void expect_no_negative(const std::vector<Rgb>& image) {
    for (const Rgb& c : image)
        EXPECT_TRUE(c.x >= 0 && c.y >= 0 && c.z >= 0);
}

/// A lamp of half a pixel in black: cutting would give a sixth more than the lamp has under
/// "mitchell", and half more under "catmullrom".
TEST(FilmNegativeLobes, ALampInBlackGivesWhatItHas) {
    for (const FilterChoice& filter : filters_with_lobes()) {
        for (const Vec2& lamp : {Vec2(20.5f), Vec2(20.9f, 20.6f), Vec2(21.0f)}) {
            const auto film = make(scene_with(filter, 41));
            const Samples samples = grid_of_samples(*film, [&](const Vec2& p) {
                return (p - lamp).length() < 0.3f ? Rgb(1000, 100, 1) : Rgb(0.0f);
            });
            film->add_pass(samples.pass());
            const std::vector<Rgb> image = film->image();
            expect_no_negative(image);
            const double given = sum_of(samples.radiance) / (kPerAxis * kPerAxis);
            EXPECT_NEAR(sum_of(image) / given, 1, 1e-4) << filter.plugin << " at " << lamp;
        }
    }
}

/// A bright lamp on a grey wall: pixels are black where the filter itself is below zero, and those
/// that are far from such are what the filter makes of them.
TEST(FilmNegativeLobes, NoFrameIsBlackBeyondTheFiltersOwn) {
    for (const FilterChoice& filter : filters_with_lobes()) {
        const SceneContents contents = scene_with(filter, 41);
        const auto film = make(contents);
        const auto radiance = [](const Vec2& p) {
            return p.x > 15.3f && p.x < 22.1f && p.y > 14.6f && p.y < 20.9f ? Rgb(300.0f)
                                                                            : Rgb(1.0f);
        };
        const Samples samples = grid_of_samples(*film, radiance);
        film->add_pass(samples.pass());
        const std::vector<Rgb> image = film->image();
        RecordedDiagnostics diagnostics;
        const PixelFilter weights = make_pixel_filter(contents, diagnostics);
        const auto filtered = [&](std::size_t x, std::size_t y) {
            double sum = 0, weight = 0;
            for (std::size_t i = 0; i < samples.positions.size(); ++i) {
                const Vec2& p = samples.positions[i];
                const double f = weights.weight(p.x - static_cast<float>(x) - 0.5f,
                                                p.y - static_cast<float>(y) - 0.5f);
                weight += f;
                sum += f * samples.radiance[i].x;
            }
            return sum / weight;
        };
        int black = 0;
        for (std::size_t x = 0; x < 41; ++x) {  // a row through the lamp
            const double own = filtered(x, 17), shown = image[std::size_t{17} * 41 + x].x;
            black += shown == 0 ? 1 : 0;
            EXPECT_EQ(shown > 0, own > 0) << filter.plugin << " at " << x;
            if (x < 3) {
                EXPECT_NEAR(shown, own, 1e-4);
            }
        }
        EXPECT_LE(black, 8);
        const double given = sum_of(samples.radiance) / (kPerAxis * kPerAxis);
        EXPECT_NEAR(sum_of(image) / given, 1, 1e-4) << filter.plugin;
    }
}

/// Few photons, with nothing else in their layer: what cutting adds to its mean is a sixth.
TEST(FilmNegativeLobes, EachLayerAndGroupKeepsItsMean) {
    const TemporaryFolder folder;
    SceneContents contents = scene_with({"mitchell", {}}, 40);
    contents.light_groups = {"sun", "sky"};
    const auto film = make(contents);
    Samples eye, photons;
    const Samples places = grid_of_samples(*film, [](const Vec2&) { return Rgb(0.0f); });
    std::mt19937 generator(3);
    std::uniform_real_distribution<float> unit(0, 1);
    double lost = 0;
    for (const Vec2& p : places.positions) {
        const bool lit = unit(generator) < 1e-3f;
        eye.radiance.insert(eye.radiance.end(), {Rgb(0.01f * p.x), Rgb(0.0f)});
        const Rgb photon(lit ? 500 * unit(generator) : 0.0f);
        photons.radiance.insert(photons.radiance.end(), {Rgb(0.0f), photon});
        photons.positions.push_back(p);
        // Borders give up what falls off the film: none of it lies there.
        const bool inside = p.x > 4 && p.x < 36 && p.y > 4 && p.y < 36;
        if (!inside) photons.radiance.back() = Rgb(0.0f);
        lost += double{photons.radiance.back().x};
    }
    PassSamples pass{places.positions, eye.radiance, 2, 1};
    pass.second_radiance = photons.radiance;
    film->add_pass(pass);
    Samples layer{photons.positions, {}};
    for (std::size_t i = 1; i < photons.radiance.size(); i += 2)
        layer.radiance.push_back(photons.radiance[i]);
    film->add_layer_pass("photons", layer.pass());
    film->write_exr(folder / "out.exr", {});

    const OIIO::ImageBuf read(folder / "out.exr");
    const auto sum_of_channel = [&](const std::string& name) {
        double sum = 0;
        for (int i = 0; i < 40 * 40; ++i) {
            const float value = read.getchannel(i % 40, i / 40, 0, read.spec().channelindex(name));
            EXPECT_GE(value, 0) << name;
            sum += double{value};
        }
        return sum;
    };
    const double given = lost / (kPerAxis * kPerAxis);
    EXPECT_NEAR(sum_of_channel("photons.R") / given, 1, 1e-4);
    EXPECT_NEAR(sum_of_channel("sky.G") / given, 1, 1e-4);
    EXPECT_NEAR((sum_of_channel("sun.B") + sum_of_channel("sky.B")) / sum_of_channel("B"), 1, 1e-4);
}

TEST(FilmNegativeLobes, SplatsKeepTheirLightToo) {
    for (const FilterChoice& filter : filters_with_lobes()) {
        const auto film = make(scene_with(filter, 40));
        const std::vector<Vec2> places{Vec2(12.3f, 20.1f), Vec2(25.07f, 13.4f)};
        const std::vector<Rgb> radiance{Rgb(8.0f), Rgb(4.0f)};
        film->add_splats({places, radiance, 1, 100});
        expect_no_negative(film->image());
        EXPECT_NEAR(sum_of(film->image()), 3 * 12.0 * 40 * 40 / 100, 1) << filter.plugin;
    }
}

TEST(FilmNegativeLobes, SameBitsForAnyNumberOfThreads) {
    std::vector<std::vector<Rgb>> images;
    for (const unsigned threads : {1u, 2u, 7u}) {
        concurrency::run_on(threads, [&] {
            const auto film = make(scene_with({"catmullrom", {}}, 120));
            const Samples samples = random_samples(*film, 57600, 5, [](float u) {
                return u < 0.05f ? Rgb(1 / (u + 1e-3f), u, 1) : Rgb(0.0f);
            });
            film->add_pass(samples.pass());
            images.push_back(film->image());
        });
    }
    for (const auto& image : images) {
        expect_no_negative(image);
        EXPECT_EQ(std::memcmp(image.data(), images[0].data(), image.size() * sizeof(Rgb)), 0);
    }
}

}  // namespace
}  // namespace lxs::test::negative_lobes_test
