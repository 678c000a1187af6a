// Protects the layers of a film that a user asks for: what they hold, under which names they are
// written, that nothing is there unless it is asked for, and that the image stays the same.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "exr_channels.h"
#include "film_samples.h"
#include "lxs/imaging/layer_names.h"
#include "memory_archive.h"

namespace lxs::test::film_layers_test {
namespace {

constexpr int kWidth = 6, kHeight = 4;

ParameterValue layers(std::vector<std::string> names) {
    return {"string", "layers", std::move(names), place(2, 5), {}};
}

SceneContents scene_with(std::vector<std::string> names, const std::string& filter = "box") {
    SceneContents contents = scene_of_size(kWidth, kHeight);
    contents.options["Film"].parameters.values.push_back(layers(std::move(names)));
    set_option(contents, "PixelFilter", filter, {});
    return contents;
}

/// Two samples a pixel, the second of which sees `far` surfaces.
void add_pass(FileFilm& film, const SeenSurface& near, const SeenSurface& far) {
    for (const SeenSurface& seen : {near, far}) {
        const Samples samples = pixel_centres(film, Rgb(1.0f));
        film.add_pass(samples.pass());
        film.add_surfaces(samples.positions,
                          std::vector<SeenSurface>(samples.positions.size(), seen));
    }
}

const SeenSurface kNear{Rgb(0.2f, 0.4f, 0.6f), Vec3(0, 0, -1), 3};
const SeenSurface kFar{Rgb(0.4f, 0.4f, 0.0f), Vec3(1, 0, 0), 7};

TEST(FilmLayers, HoldMeansOfWhatWasSeenAndTheLeastDepth) {
    const auto film = make(scene_with({"albedo", "normal", "depth"}));
    add_pass(*film, kFar, kNear);
    const auto channels = channels_of(*film);
    const std::map<std::string, float> expected{
        {"albedo.R", 0.3f}, {"albedo.G", 0.4f}, {"albedo.B", 0.3f},  {"normal.X", 0.5f},
        {"normal.Y", 0.0f}, {"depth.Z", 3.0f},  {"normal.Z", -0.5f}, {"R", 1.0f}};
    for (const auto& [name, value] : expected) {
        ASSERT_TRUE(channels.contains(name)) << name;
        for (const float found : channels.at(name))
            EXPECT_NEAR(found, value, 1e-6f) << name;
    }
}

TEST(FilmLayers, ShowWhereNothingIs) {
    const auto film = make(scene_with({"all"}));
    add_pass(*film, {}, {});
    const auto channels = channels_of(*film);
    EXPECT_EQ(channels.at("depth.Z").front(), 1e10f);
    EXPECT_EQ(channels.at("normal.Z").front(), 0.0f);
    EXPECT_EQ(channels.at("albedo.R").front(), 0.0f);
    // A film that no sample has come to.
    const auto empty = channels_of(*make(scene_with({"all"})));
    EXPECT_EQ(empty.at("depth.Z").front(), 1e10f);
    EXPECT_EQ(empty.at("normal.X").front(), 0.0f);
}

TEST(FilmLayers, AreOnlyThoseAskedForAndLeaveTheImageAsItIs) {
    const auto plain = make(scene_with({}, "mitchell"));
    const auto some = make(scene_with({"depth"}, "mitchell"));
    EXPECT_FALSE(plain->layers_wanted().surfaces());
    EXPECT_TRUE(some->layers_wanted().surfaces());
    add_pass(*plain, kNear, kFar);
    add_pass(*some, kNear, kFar);
    auto channels = channels_of(*some);
    EXPECT_EQ(channels.erase("depth.Z"), 1u);
    EXPECT_EQ(channels, channels_of(*plain));
}

TEST(FilmLayers, RefuseWhatIsNotFinite) {
    const auto film = make(scene_with({"all"}));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    add_pass(*film, {Rgb(nan), Vec3(nan), nan}, kNear);
    EXPECT_EQ(film->refused_samples(), 3u * kWidth * kHeight);
    const auto channels = channels_of(*film);
    EXPECT_NEAR(channels.at("albedo.B").front(), 0.6f, 1e-6f);
    EXPECT_EQ(channels.at("normal.Z").front(), -1.0f);
    EXPECT_EQ(channels.at("depth.Z").front(), 3.0f);
}

TEST(FilmLayers, ARestoredFilmGoesOnWithThem) {
    const auto whole = make(scene_with({"all"})), first = make(scene_with({"all"})),
               second = make(scene_with({"all"}));
    add_pass(*whole, kNear, kFar);
    add_pass(*whole, kFar, kFar);
    add_pass(*first, kNear, kFar);
    MemoryArchive archive;
    first->state(archive);
    archive.restore();
    second->state(archive);
    add_pass(*second, kFar, kFar);
    EXPECT_EQ(channels_of(*second), channels_of(*whole));
}

TEST(FilmLayers, UnknownNamesAreErrorsThatNameTheNearest) {
    EXPECT_EQ(input_error([] { make(scene_with({"depht"})); }).substr(0, 61),
              "scene.lxs:2:5: error: unknown layer \"depht\"; did you mean \"de");
}

TEST(FilmLayers, NoLightGroupHasTheNameOfOne) {
    SceneContents contents = scene_with({"depth"});
    contents.light_groups = {"default", "depth"};
    EXPECT_NE(input_error([&] { make(contents); }).find("has the name of a light group"),
              std::string::npos);
}

TEST(LayerNames, AreSeparatedByCommas) {
    EXPECT_EQ(split_layer_names("albedo,,depth,"), (std::vector<std::string>{"albedo", "depth"}));
    EXPECT_TRUE(split_layer_names("").empty());
}

}  // namespace
}  // namespace lxs::test::film_layers_test
