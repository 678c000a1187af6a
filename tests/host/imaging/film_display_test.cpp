// Protects what is displayed: no dark dots beside what is bright, whatever brings the light there;
// the image itself stays as measured, and what is no ring is shown as it is.
#include "film_display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "film_samples.h"
#include "memory_archive.h"
#include "run_on_threads.h"

namespace lxs::test::film_display_test {
namespace {

constexpr int kSize = 24, kPasses = 8;
constexpr float kGround = 0.1f, kHighlight = 1000;

std::unique_ptr<FileFilm> film(const std::string& filter, std::vector<std::string> groups = {}) {
    SceneContents contents = scene_of_size(kSize, kSize);
    set_option(contents, "PixelFilter", filter, {});
    if (!groups.empty()) contents.light_groups = std::move(groups);
    return make(contents);
}

bool in_highlight(const Vec2& p) {
    return std::abs(p.x - 12.3f) < 0.4f && std::abs(p.y - 11.8f) < 0.4f;
}

/// What brings the highlight.
enum class Bringer : std::uint8_t { Samples, SecondPart, Splats, OneGroup };

/// A pass of `samples`, to which `bright` comes as the bringer has it.
void add_pass(FileFilm& film, Samples& samples, std::span<const Rgb> bright, Bringer bringer) {
    const std::uint32_t groups = film.light_groups();
    PassSamples brought = samples.pass(1, groups);
    if (bringer == Bringer::SecondPart) brought.second_radiance = bright;
    if (bringer == Bringer::Splats) {
        film.add_splats(
            {samples.positions, bright, groups, static_cast<double>(samples.positions.size())});
    } else if (bringer != Bringer::SecondPart) {
        for (std::size_t i = 0; i < bright.size(); ++i)
            samples.radiance[i] += bright[i];
    }
    film.add_pass(brought);
}

/// Passes over an even ground with a highlight of less than a pixel.
void render(FileFilm& film, Bringer bringer, bool wavelengths = false) {
    for (unsigned pass = 0; pass < kPasses; ++pass) {
        if (wavelengths) film.set_wavelengths(wavelengths_of_pass(3, pass));
        const std::uint32_t groups = film.light_groups();
        Samples samples = random_samples(film, std::size_t{16} * kSize * kSize, pass,
                                         [&](float) { return Rgb(kGround); });
        std::vector<Rgb> bright(samples.radiance.size(), Rgb(0.0f));
        for (std::size_t i = 0; i < samples.positions.size(); ++i) {
            if (in_highlight(samples.positions[i]))
                bright[i * groups + groups - 1] = Rgb(kHighlight);
        }
        add_pass(film, samples, bright, bringer);
    }
}

float least_green(const std::vector<Rgb>& image) {
    return std::min_element(image.begin(), image.end(),
                            [](const Rgb& a, const Rgb& b) { return a.y < b.y; })
        ->y;
}

TEST(FilmDisplay, HasNoRingsAroundHighlights) {
    for (const char* filter : {"mitchell", "catmullrom", "sinc"}) {
        for (const Bringer bringer : {Bringer::Samples, Bringer::SecondPart, Bringer::Splats}) {
            SCOPED_TRACE(std::string(filter) + " " + std::to_string(static_cast<int>(bringer)));
            const auto shown = film(filter);
            render(*shown, bringer);
            EXPECT_EQ(least_green(shown->image()), 0) << "what was measured has them";
            EXPECT_GT(least_green(shown->shown()), 0.7f * kGround);
        }
        const auto grouped = film(filter, {"one", "two"});
        render(*grouped, Bringer::OneGroup);
        EXPECT_EQ(least_green(grouped->image()), 0);
        EXPECT_GT(least_green(grouped->shown()), 0.7f * 2 * kGround);
        const auto spectral = film(filter);
        render(*spectral, Bringer::Splats, true);
        EXPECT_EQ(least_green(spectral->image()), 0);
        EXPECT_GT(least_green(spectral->shown()), 0.5f * kGround);
    }
}

TEST(FilmDisplay, ShowsWhatWasMeasuredElsewhere) {
    for (const char* filter : {"mitchell", "box", "gaussian"}) {
        const auto even = film(filter);
        even->add_pass(random_samples(*even, std::size_t{32} * kSize * kSize, 5, [](float u) {
                           return Rgb(0.8f + 0.4f * u);
                       }).pass());
        EXPECT_EQ(even->shown(), even->image()) << filter;
    }
    const auto bright = film("mitchell");
    render(*bright, Bringer::Samples);
    const auto measured = bright->image(), shown = bright->shown();
    for (std::uint32_t y = 0; y < kSize; ++y) {
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const std::size_t i = std::size_t{y} * kSize + x;
            EXPECT_GE(shown[i].x, measured[i].x) << "at no pixel's cost";
            if (std::max(std::abs(int(x) - 12), std::abs(int(y) - 11)) > 3) {
                EXPECT_NEAR(shown[i].x, measured[i].x, 0.3f * kGround) << x << " " << y;
            }
        }
    }
}

// A ring may be filled, a line may not be: its own samples are dark.
TEST(FilmDisplay, DarkLinesStayDark) {
    const auto lined = film("mitchell");
    Samples samples =
        random_samples(*lined, std::size_t{64} * kSize * kSize, 9, [](float) { return Rgb(1.0f); });
    for (std::size_t i = 0; i < samples.positions.size(); ++i) {
        if (std::floor(samples.positions[i].x) == 12) samples.radiance[i] = Rgb(0.01f);
    }
    lined->add_pass(samples.pass());
    const auto shown = lined->shown();
    for (std::size_t y = 4; y < 20; ++y)
        EXPECT_LT(shown[y * kSize + 12].x, 0.3f);
}

TEST(FilmDisplay, DenoisedImagesAreMadeNoDarker) {
    std::vector<Rgb> denoised{Rgb(0.0f), Rgb(0.2f), Rgb(3.0f), Rgb(0.9f)};
    const std::vector<Rgb> image{Rgb(0.0f), Rgb(0.6f), Rgb(0.0f), Rgb(0.9f)};
    const std::vector<Rgb> lobe_free(4, Rgb(1.0f));
    show_without_lobes(denoised, image, lobe_free);
    EXPECT_EQ(denoised[0].x, 1.0f);
    EXPECT_NEAR(denoised[1].x, 0.68f, 1e-6f) << "three fifths of the way";
    EXPECT_EQ(denoised[2].x, 3.0f);
    EXPECT_EQ(denoised[3].x, 0.9f) << "no ring";
}

/// A film that leaves outliers out unless they have `neighbours`.
std::unique_ptr<FileFilm> rejecting(const std::string& filter, int neighbours,
                                    std::vector<std::string> groups = {}) {
    SceneContents contents = scene_of_size(kSize, kSize);
    set_option(contents, "PixelFilter", filter, {});
    contents.options.at("Film").parameters.values.push_back(
        integer("outlierrejection_k", neighbours));
    if (!groups.empty()) contents.light_groups = std::move(groups);
    return make(contents);
}

/// Noise around kGround with a small lamp that all passes see, and one firefly of the fourth pass.
void render_with_firefly(FileFilm& film, Bringer bringer, int passes = kPasses) {
    const std::uint32_t groups = film.light_groups();
    for (int pass = 0; pass < passes; ++pass) {
        Samples samples =
            random_samples(film, std::size_t{kSize} * kSize, static_cast<unsigned>(pass),
                           [](float u) { return Rgb(2 * kGround * u); });
        samples.positions[0] = Vec2(5.4f, 6.7f);
        std::vector<Rgb> bright(samples.radiance.size(), Rgb(0.0f));
        if (pass == 3) bright[groups - 1] = Rgb(kHighlight, 0, 0);
        for (std::size_t i = 1; i < samples.positions.size(); ++i) {
            const Vec2& p = samples.positions[i];
            if (std::abs(p.x - 17) < 1.5f && std::abs(p.y - 17) < 1.5f)
                bright[i * groups + groups - 1] = Rgb(kHighlight / 20);
        }
        add_pass(film, samples, bright, bringer);
    }
}

TEST(FilmDisplay, LeavesOutliersOut) {
    for (const char* filter : {"mitchell", "box", "gaussian"}) {
        for (const Bringer bringer : {Bringer::Samples, Bringer::SecondPart, Bringer::Splats}) {
            SCOPED_TRACE(std::string(filter) + " " + std::to_string(static_cast<int>(bringer)));
            const auto plain = rejecting(filter, 0);
            const auto careful = rejecting(filter, 4);
            render_with_firefly(*plain, bringer);
            render_with_firefly(*careful, bringer);
            EXPECT_EQ(careful->image(), plain->image()) << "what was measured stays";
            EXPECT_FALSE(plain->outliers_left_out());
            const std::size_t firefly = 6 * kSize + 5, lamp = 17 * kSize + 17;
            const auto shown = careful->shown(), all = plain->shown();
            EXPECT_GT(all[firefly].x, 20);
            for (int y = -3; y <= 3; ++y) {
                for (int x = -3; x <= 3; ++x) {
                    const std::size_t i = firefly + static_cast<std::size_t>(y * kSize + x);
                    EXPECT_LT(shown[i].x, 6 * kGround) << x << " " << y;
                }
            }
            EXPECT_NEAR(shown[lamp].x / all[lamp].x, 1, 0.05f) << "a lamp is none";
            double whole = 0, left = 0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                for (int c = 0; c < 3; ++c) {
                    whole += double{all[i][c]};
                    left += double{shown[i][c]};
                }
            }
            EXPECT_NEAR(*careful->outliers_left_out() / (1 - left / whole), 1, 0.02)
                << "what is left out is stated";
        }
    }
    const auto grouped = rejecting("mitchell", 4, {"one", "two"});
    render_with_firefly(*grouped, Bringer::OneGroup);
    EXPECT_LT(grouped->shown()[6 * kSize + 5].x, 12 * kGround);
}

TEST(FilmDisplay, LeavesOutliersOutAfterAPauseAlike) {
    const auto whole = rejecting("mitchell", 4), first = rejecting("mitchell", 4);
    render_with_firefly(*whole, Bringer::Splats);
    render_with_firefly(*whole, Bringer::SecondPart);
    render_with_firefly(*first, Bringer::Splats);
    MemoryArchive archive;
    first->state(archive);
    archive.restore();
    const auto second = rejecting("mitchell", 4);
    second->state(archive);
    render_with_firefly(*second, Bringer::SecondPart);
    EXPECT_EQ(second->shown(), whole->shown());
    EXPECT_EQ(second->outliers_left_out(), whole->outliers_left_out());
}

TEST(FilmDisplay, SurvivesAPauseAndAnyNumberOfThreads) {
    const auto rendered = [](unsigned threads) {
        auto result = film("mitchell");
        concurrency::run_on(threads, [&] {
            render(*result, Bringer::Splats);
            render(*result, Bringer::SecondPart);
            return 0;
        });
        return result;
    };
    const auto whole = rendered(1);
    EXPECT_EQ(rendered(7)->shown(), whole->shown());
    MemoryArchive archive;
    const auto first = film("mitchell");
    render(*first, Bringer::Splats);
    first->state(archive);
    archive.restore();
    const auto second = film("mitchell");
    render(*second, Bringer::Samples);  // is forgotten
    second->state(archive);
    render(*second, Bringer::SecondPart);
    EXPECT_EQ(second->shown(), whole->shown());
}

TEST(FilmDisplay, KeepsTheFiltersCentralLobe) {
    for (const char* name : {"mitchell", "catmullrom", "sinc", "gaussian"}) {
        SceneContents contents = empty_scene();
        set_option(contents, "PixelFilter", name, {real("xwidth", 3), real("ywidth", 2)});
        RecordedDiagnostics diagnostics;
        const PixelFilter filter = make_pixel_filter(contents, diagnostics);
        const PixelFilter lobe = filter.central_lobe();
        EXPECT_LE(lobe.radius_x(), filter.radius_x());
        EXPECT_FALSE(lobe.has_negative_weights());
        double sum = 0;
        for (int x = -3; x <= 3; ++x) {
            for (int y = -3; y <= 3; ++y)
                sum += double{
                    lobe.weight(static_cast<float>(x) + 0.31f, static_cast<float>(y) - 0.17f)};
        }
        EXPECT_NEAR(sum, 1, 1e-5) << name;
        EXPECT_GT(lobe.weight(0, 0), 0) << name;
    }
}

}  // namespace
}  // namespace lxs::test::film_display_test
