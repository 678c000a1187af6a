// Protects the alpha channel: the part of a pixel that surfaces cover, in EXR and PNG, whichever of
// LuxRender's parameters asks for it; colours multiplied by it in the EXR and not in the PNG.
#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include "exr_channels.h"
#include "film_samples.h"
#include "memory_archive.h"

namespace lxs::test::film_alpha_test {
namespace {

constexpr int kWidth = 8, kHeight = 4;

std::unique_ptr<FileFilm> film(std::vector<ParameterValue> alpha) {
    SceneContents contents = scene_of_size(kWidth, kHeight);
    auto& values = contents.options.at("Film").parameters.values;
    values.insert(values.end(), alpha.begin(), alpha.end());
    values.push_back(text("tonemapkernel", "maxwhite"));
    values.push_back(real("gamma", 1));
    return make(contents);
}

/// A surface of radiance 0.5 over the left half of the film, and half of its fourth column.
void render(FileFilm& film, int passes = 1) {
    for (int pass = 0; pass < passes; ++pass) {
        Samples samples;
        std::vector<SeenSurface> seen;
        for (std::uint32_t y = 0; y < kHeight; ++y) {
            for (std::uint32_t x = 0; x < 2 * kWidth; ++x) {
                samples.positions.emplace_back(0.5f * static_cast<float>(x) + 0.25f,
                                               static_cast<float>(y) + 0.5f);
                const bool covered = x < 7;
                samples.radiance.emplace_back(covered ? 0.5f : 0.0f);
                seen.emplace_back();
                if (covered) seen.back().depth = 2;
            }
        }
        film.add_pass(samples.pass());
        film.add_surfaces(samples.positions, seen);
    }
}

OIIO::ImageBuf png_of(const FileFilm& film, const TemporaryFolder& folder) {
    film.write_png(folder / "a.png");
    return OIIO::ImageBuf(folder / "a.png");
}

TEST(FilmAlpha, IsWhatSurfacesCover) {
    const TemporaryFolder folder;
    for (const auto& asked :
         {flag("premultiplyalpha", true), text("write_exr_channels", "RGBA"),
          text("write_png_channels", "RGBA"), text("write_png_channels", "YA")}) {
        SCOPED_TRACE(asked.name);
        const auto image = film({asked});
        EXPECT_TRUE(image->layers_wanted().alpha);
        EXPECT_TRUE(image->layers_wanted().surfaces());
        EXPECT_TRUE(image->hides_background());
        render(*image);
        auto channels = channels_of(*image);
        const auto& alpha = channels.at("A");
        const auto& red = channels.at("R");
        EXPECT_EQ(alpha[0], 1);
        EXPECT_EQ(alpha[3], 0.5f);
        EXPECT_EQ(alpha[4], 0);
        EXPECT_EQ(red[3], 0.25f) << "multiplied by alpha, as OpenEXR has it";
        // oiiotool and others multiply what a PNG holds: asked for as it stands.
        OIIO::ImageSpec raw;
        raw.attribute("oiio:UnassociatedAlpha", 1);
        image->write_png(folder / "a.png");
        const OIIO::ImageBuf png(folder / "a.png", 0, 0, nullptr, &raw);
        ASSERT_EQ(png.nchannels(), 4);
        EXPECT_EQ(png.getchannel(0, 0, 0, 0), 1) << "the brightest is white";
        EXPECT_EQ(png.getchannel(3, 0, 0, 0), 1) << "not multiplied by alpha, as PNG has it";
        EXPECT_NEAR(png.getchannel(3, 0, 0, 3), 0.5f, 0.003f);
        EXPECT_EQ(png.getchannel(4, 0, 0, 3), 0);
    }
}

TEST(FilmAlpha, IsNotThereUnlessAskedFor) {
    const TemporaryFolder folder;
    const auto image = film({});
    EXPECT_FALSE(image->layers_wanted().alpha);
    EXPECT_FALSE(image->hides_background());
    render(*image);
    EXPECT_FALSE(channels_of(*image).contains("A"));
    EXPECT_EQ(png_of(*image, folder).nchannels(), 3);
}

TEST(FilmAlpha, StraightColoursKeepTheBackground) {
    const auto straight =
        film({text("write_exr_channels", "RGBA"), flag("write_exr_straightcolors", true)});
    EXPECT_TRUE(straight->layers_wanted().alpha);
    EXPECT_FALSE(straight->hides_background());
    const auto both =
        film({flag("premultiplyalpha", true), flag("write_exr_straightcolors", true)});
    EXPECT_TRUE(both->hides_background());
}

TEST(FilmAlpha, IsOneWhereNobodyTellsOfSurfaces) {
    const auto image = film({flag("premultiplyalpha", true)});
    image->add_pass(pixel_centres(*image, Rgb(0.5f)).pass());
    const auto channels = channels_of(*image);
    for (const float alpha : channels.at("A"))
        EXPECT_EQ(alpha, 1);
}

TEST(FilmAlpha, SurvivesAPause) {
    const auto whole = film({flag("premultiplyalpha", true)});
    render(*whole, 3);
    const auto first = film({flag("premultiplyalpha", true)});
    render(*first, 2);
    MemoryArchive archive;
    first->state(archive);
    archive.restore();
    const auto second = film({flag("premultiplyalpha", true)});
    second->state(archive);
    render(*second, 1);
    EXPECT_EQ(channels_of(*second), channels_of(*whole));
}

}  // namespace
}  // namespace lxs::test::film_alpha_test
