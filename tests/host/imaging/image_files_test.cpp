// Protects the written images: an EXR holds exactly what the film says, with layers and metadata; a
// PNG is the tone-mapped image.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstring>

#include "lxs/imaging/imaging.h"
#include "scene_options.h"

namespace lxs::test::image_files_test {
namespace {

/// A file as OpenImageIO reads it.
struct ReadImage {
    OIIO::ImageSpec spec;
    std::vector<float> values;

    explicit ReadImage(const std::string& path) {
        const auto input = OIIO::ImageInput::open(path);
        if (!input) throw std::runtime_error(OIIO::geterror());
        spec = input->spec();
        values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
        input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data());
    }
    std::size_t channel(const std::string& name) const {
        const int index = spec.channelindex(name);
        EXPECT_GE(index, 0) << name;
        return static_cast<std::size_t>(std::max(index, 0));
    }
    float at(std::size_t pixel, const std::string& name) const {
        return values[pixel * static_cast<std::size_t>(spec.nchannels) + channel(name)];
    }
};

/// A film of 7 x 5 pixels with one pass of distinct values in it.
std::unique_ptr<FileFilm> painted_film(const SceneContents& contents) {
    RecordedDiagnostics diagnostics;
    auto film = make_film(contents, diagnostics);
    std::vector<Vec2> positions;
    std::vector<Rgb> radiance;
    for (std::uint32_t y = 0; y < film->height(); ++y) {
        for (std::uint32_t x = 0; x < film->width(); ++x) {
            positions.emplace_back(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            for (std::uint32_t g = 0; g < film->light_groups(); ++g) {
                const auto value = static_cast<float>(x + 10 * y + 100 * g) / 7;
                radiance.emplace_back(value, value * value, value * 1e-3f);
            }
        }
    }
    film->add_pass({positions, radiance, film->light_groups(), 3});
    return film;
}

TEST(ExrFile, HoldsTheImageExactly) {
    const TemporaryFolder folder;
    const auto film = painted_film(scene_of_size(7, 5));
    film->write_exr(folder / "out.exr", {{"lxs:seed", "42"}, {"lxs:scene", "a \"name\""}});
    const ReadImage read(folder / "out.exr");
    EXPECT_EQ(read.spec.nchannels, 3) << "one light group needs no layer of its own";
    EXPECT_EQ(read.spec.format, OIIO::TypeDesc::FLOAT);
    const std::vector<Rgb> image = film->image();
    ASSERT_EQ(read.spec.image_pixels(), image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        EXPECT_EQ(read.at(i, "R"), image[i].x);
        EXPECT_EQ(read.at(i, "G"), image[i].y);
        EXPECT_EQ(read.at(i, "B"), image[i].z);
    }
    EXPECT_EQ(read.spec.get_string_attribute("lxs:seed"), "42");
    EXPECT_EQ(read.spec.get_string_attribute("lxs:scene"), "a \"name\"");
    EXPECT_EQ(folder.entries(), 1u) << "no temporary file stays";
}

TEST(ExrFile, LightGroupsAndExtraLayersAreNamed) {
    SceneContents contents = scene_of_size(7, 5);
    contents.light_groups = {"default", "key.light"};
    const TemporaryFolder folder;
    const auto film = painted_film(contents);
    std::vector<float> layer(35);
    layer[3] = 0.5f;
    layer[4] = std::nanf("");
    film->set_layer("radius", std::vector<float>(35, 9.0f));
    film->set_layer("radius", layer);
    film->write_exr(folder / "out.exr", {});
    const ReadImage read(folder / "out.exr");
    EXPECT_EQ(read.spec.nchannels, 10);
    EXPECT_EQ(read.at(8, "default.R"), 11.0f / 7);
    EXPECT_EQ(read.at(8, "key.light.R"), 111.0f / 7);
    EXPECT_NEAR(read.at(8, "R"), 122.0f / 7, 1e-5f) << "the image is the sum of its groups";
    EXPECT_EQ(read.at(3, "radius.Y"), 0.5f);
    EXPECT_EQ(read.at(4, "radius.Y"), 0.0f) << "no NaN goes out";
}

TEST(ExrFile, CropWindowIsTheDataWindow) {
    SceneContents contents = scene_of_size(20, 10);
    contents.options["Film"].parameters.values.push_back(
        numbers("float", "cropwindow", {0.5, 0.75, 0.2, 0.5}));
    const TemporaryFolder folder;
    const auto film = painted_film(contents);
    film->write_exr(folder / "out.exr", {});
    const ReadImage read(folder / "out.exr");
    EXPECT_EQ(read.spec.x, 10);
    EXPECT_EQ(read.spec.y, 2);
    EXPECT_EQ(read.spec.width, 5);
    EXPECT_EQ(read.spec.height, 3);
    EXPECT_EQ(read.spec.full_width, 20);
    EXPECT_EQ(read.spec.full_height, 10);
    EXPECT_EQ(read.at(6, "R"), film->image()[6].x);
}

TEST(ExrFile, SameFilmSameBytes) {
    const TemporaryFolder folder;
    const auto film = painted_film(scene_of_size(7, 5));
    film->write_exr(folder / "a.exr", {{"k", "v"}});
    film->write_exr(folder / "b.exr", {{"k", "v"}});
    EXPECT_EQ(folder.read("a.exr"), folder.read("b.exr"));
}

TEST(ExrFile, ANameThatOpenExrRefusesIsReportedWithThePath) {
    const TemporaryFolder folder;
    const auto film = painted_film(scene_of_size(7, 5));
    const std::string path = folder / "out.exr";
    try {
        film->write_exr(path, {{"dataWindow", "text"}});
        FAIL() << "must throw";
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()).find("cannot write '" + path + "': "), 0u);
    }
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(PngFile, HoldsTheToneMappedImage) {
    SceneContents contents = scene_of_size(7, 5);
    contents.options["Film"].parameters.values.push_back(text("tonemapkernel", "maxwhite"));
    const TemporaryFolder folder;
    const auto film = painted_film(contents);
    film->write_png(folder / "out.png");
    const ReadImage read(folder / "out.png");
    EXPECT_EQ(read.spec.width, 7);
    EXPECT_EQ(read.spec.height, 5);
    EXPECT_EQ(read.spec.nchannels, 3);
    EXPECT_EQ(read.spec.format, OIIO::TypeDesc::UINT8);
    EXPECT_EQ(read.at(34, "G"), 1.0f) << "the brightest channel becomes white";
    EXPECT_EQ(read.at(0, "R"), 0.0f);
}

TEST(PngFile, NamesTheGammaThatItIsFor) {
    const TemporaryFolder folder;
    for (const float gamma : {2.2f, 1.8f}) {
        SceneContents contents = scene_of_size(7, 5);
        contents.options["Film"].parameters.values.push_back(real("gamma", gamma));
        painted_film(contents)->write_png(folder / "out.png");
        const OIIO::ImageSpec spec = ReadImage(folder / "out.png").spec;
        if (gamma == 2.2f) {
            EXPECT_EQ(spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
        } else {
            EXPECT_NEAR(spec.get_float_attribute("oiio:Gamma"), gamma, 1e-4f);
        }
    }
}

TEST(PngFile, LargerThanThatFormatAllowsIsReportedWithThePath) {
    const TemporaryFolder folder;
    const std::string path = folder / "out.png";
    try {
        painted_film(scene_of_size(1000001, 1))->write_png(path);
        FAIL() << "must throw";
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()).find("cannot write '" + path + "': "), 0u);
    }
    EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace lxs::test::image_files_test
