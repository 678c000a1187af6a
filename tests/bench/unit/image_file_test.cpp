// Protects images on disk: layers come back as written, missing ones are told from damaged files.
#include "image_file.h"

#include <gtest/gtest.h>

#include "bench_process.h"
#include "study_file.h"
#include "synthetic_image.h"

namespace bench::test::image_file_test {
namespace {

TEST(ImageFile, LayersComeBackAsWritten) {
    const TemporaryFolder folder;
    std::mt19937 random(1);
    const Image image = noisy_image(7, 5, 1, 0.3, random);
    const Image photons = noisy_image(7, 5, 2, 0.3, random);
    const auto file = folder.path() / "deeper" / "a.exr";
    write_layers(file, {{"", image}, {kPhotonLayer, photons}});
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(read_image(file).getchannel(6, 4, 0, c), image.getchannel(6, 4, 0, c));
        EXPECT_EQ(read_layer(file, kPhotonLayer)->getchannel(2, 3, 0, c),
                  photons.getchannel(2, 3, 0, c));
    }
    EXPECT_FALSE(read_layer(file, "nothing"));
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".tmp"));
}

// A cache that knows files by name and second gave the earlier file's layout to the later one: a
// reference of rubbish wherever chunks took less than a second.
TEST(ImageFile, AFileReplacedWithinTheSecondIsReadAnew) {
    const TemporaryFolder folder;
    std::mt19937 random(1);
    const auto file = folder.path() / "chunk.exr";
    const std::filesystem::file_time_type written = std::filesystem::file_time_type::clock::now();
    for (int round = 0; round < 4; ++round) {
        const Image image = noisy_image(7, 5 + round % 2, 1 + round, 0.3, random);
        std::vector<NamedLayer> layers{{"", image}};
        if (round % 2 == 0) layers.insert(layers.begin(), {kPhotonLayer, image});
        write_layers(file, layers);
        std::filesystem::last_write_time(file, written);
        const Image found = read_image(file);
        ASSERT_EQ(found.spec().height, 5 + round % 2);
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(found.getchannel(6, 4, 0, c), image.getchannel(6, 4, 0, c));
        EXPECT_EQ(read_layer(file, kPhotonLayer).has_value(), round % 2 == 0);
    }
}

TEST(ImageFile, UnreadableFilesAreNamed) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "bad.exr";
    folder.write("bad.exr", "no image");
    EXPECT_THROW(read_image(file), StudyError);
    EXPECT_THROW(read_image(folder.path() / "none.exr"), StudyError);
    EXPECT_THROW(read_json(file), StudyError);
    EXPECT_THROW(read_json(folder.path() / "none.json"), StudyError);
}

}  // namespace
}  // namespace bench::test::image_file_test
