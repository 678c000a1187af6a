// Protects the memory from image files that claim more than they hold: every format that is read,
// with sizes, layers, channels and tiles that can't be, is refused with a message before anything
// of that size is made; and what is whole is still read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <stdexcept>

#include "lxs/images/image_library.h"
#include "made_images.h"
#include "temporary_folder.h"

namespace lxs::image_claims_test {
namespace {

using test::MadeImage;
using test::MadeSizes;
using testing::HasSubstr;

/// While it lives, this process gets little more memory than it has; not under a sanitizer, which
/// keeps terabytes for itself.
class LittleMemory {
  public:
    LittleMemory() {
        if (AIPS_SANITIZED) return;
        std::ifstream file("/proc/self/statm");
        rlim_t pages = 0;
        file >> pages;
        ::getrlimit(RLIMIT_AS, &before_);
        rlimit less = before_;
        less.rlim_cur = pages * 4096 + kMore;
        ::setrlimit(RLIMIT_AS, &less);
    }
    ~LittleMemory() {
        if (!AIPS_SANITIZED) ::setrlimit(RLIMIT_AS, &before_);
    }
    LittleMemory(const LittleMemory&) = delete;
    LittleMemory& operator=(const LittleMemory&) = delete;

  private:
    static constexpr rlim_t kMore = rlim_t{1} << 30;  // the largest image that is always believed
    rlimit before_{};
};

class ImageClaims : public testing::Test {
  protected:
    /// Why neither a map nor a texture can be made of the file.
    std::string refusal_of(const MadeImage& image) {
        const std::string path = folder_.write(image.name, image.bytes);
        const auto of = [](const auto& read) -> std::string {
            try {
                read();
            } catch (const std::runtime_error& error) {
                return error.what();
            }
            return "";
        };
        std::string map = of([&] { (void)image_library().read(path); });
        EXPECT_EQ(of([&] { (void)textures_->open(path); }).empty(), map.empty()) << image.name;
        return map;
    }

    files::TemporaryFolder folder_;
    std::unique_ptr<CachedImages> textures_ = image_library().make_cache();
};

TEST_F(ImageClaims, WhatIsWholeIsReadByMapsAndTextures) {
    std::vector<MadeImage> images = test::small_images();
    images.resize(images.size() - test::kNoPictures);
    for (const MadeImage& image : images) {
        const std::string path = folder_.write(image.name, image.bytes);
        try {
            const FloatImage map = image_library().read(path);
            EXPECT_EQ(map.values.size(), map.width * map.height * map.channels);
            EXPECT_GE(map.width * map.height, 32u) << image.name;
            EXPECT_EQ(textures_->open(path)->channels(), static_cast<int>(map.channels));
        } catch (const std::runtime_error& error) {
            ADD_FAILURE() << image.name << ": " << error.what();
        }
    }
}

TEST_F(ImageClaims, FormatsAreKnownByWhatStandsInThem) {
    for (const MadeImage& image : test::small_images()) {
        if (image.name.starts_with("raw.") || image.name.starts_with("rle.")) continue;  // Targa
        const std::string usual = refusal_of(image);
        EXPECT_EQ(refusal_of({image.name + ".of_no_format", image.bytes}), usual) << image.name;
        EXPECT_EQ(refusal_of({image.name + ".pfm", image.bytes}).empty(), usual.empty())
            << image.name;
    }
}

TEST_F(ImageClaims, VolumesAreNoImages) {
    MadeSizes tiles{8, 4, 1, 3, 64, 64, 16};
    EXPECT_THAT(refusal_of({"deep_tiles.tif", test::made_tiff(tiles)}), HasSubstr("16 layers"));
    MadeSizes volume;
    volume.layers = 16;
    EXPECT_THAT(refusal_of({"volume.dds", test::made_dds(volume)}), HasSubstr("16 layers"));
    volume.layers = 0x7FFFFFFF;
    EXPECT_THAT(refusal_of({"volume.dds", test::made_dds(volume)}), HasSubstr("layers"));
    tiles.tile_layers = 0;
    tiles.layers = 1000;
    (void)refusal_of({"layers.tif", test::made_tiff(tiles)});
}

TEST_F(ImageClaims, FewBytesHoldNoHugeImage) {
    const MadeSizes huge{60000, 60000, 1, 3, 0, 0, 0};
    const MadeSizes tiles{60000, 60000, 1, 3, 1024, 1024, 0};
    const std::vector<MadeImage> images{{"a.bmp", test::made_bmp(huge)},
                                        {"a.dds", test::made_dds(huge)},
                                        {"a.exr", test::made_exr(huge)},
                                        {"tiles.exr", test::made_exr(tiles)},
                                        {"a.gif", test::made_gif(huge)},
                                        {"a.hdr", test::made_hdr(huge)},
                                        {"a.jpg", test::made_jpeg(huge)},
                                        {"a.j2k", test::made_jpeg_2000(tiles, false)},
                                        {"a.jp2", test::made_jpeg_2000(tiles, true)},
                                        {"a.ppm", test::made_pnm(huge)},
                                        {"a.sgi", test::made_sgi(huge)},
                                        {"a.tga", test::made_tga(huge)},
                                        {"a.tif", test::made_tiff(huge)},
                                        {"a.webp", test::made_webp({16000, 16000, 1, 4, 0, 0, 0})}};
    const LittleMemory little;
    for (const MadeImage& image : images)
        EXPECT_THAT(refusal_of(image), HasSubstr(" bytes can't hold")) << image.name;
}

/// Products of these sides are nothing in 32 bits.
TEST_F(ImageClaims, SidesWhoseProductOverflows) {
    const LittleMemory little;
    for (const std::uint32_t side : {0x8000u, 0xFFFFu, 0x10000u, 0x40000000u, 0x7FFFFFFFu}) {
        const MadeSizes sizes{side, side, 1, 4, 0, 0, 0};
        EXPECT_NE(refusal_of({"a.bmp", test::made_bmp(sizes)}), "");
        EXPECT_NE(refusal_of({"a.dds", test::made_dds(sizes)}), "");
        EXPECT_NE(refusal_of({"a.exr", test::made_exr(sizes)}), "");
        EXPECT_NE(refusal_of({"a.gif", test::made_gif(sizes)}), "");
        EXPECT_NE(refusal_of({"a.hdr", test::made_hdr(sizes)}), "");
        EXPECT_NE(refusal_of({"a.j2k", test::made_jpeg_2000(sizes, false)}), "");
        EXPECT_NE(refusal_of({"a.ppm", test::made_pnm(sizes)}), "");
        EXPECT_NE(refusal_of({"a.tif", test::made_tiff(sizes)}), "");
    }
}

TEST_F(ImageClaims, TilesAndChannels) {
    const LittleMemory little;
    const MadeSizes tiles{64, 64, 1, 3, 1 << 24, 1 << 24, 0};
    EXPECT_THAT(refusal_of({"a.tif", test::made_tiff(tiles)}), HasSubstr("a side of 16777216"));
    EXPECT_THAT(refusal_of({"a.exr", test::made_exr(tiles)}), HasSubstr("a side of 16777216"));
    const MadeSizes fewer{64, 64, 1, 3, 20000, 20000, 0};
    EXPECT_THAT(refusal_of({"a.exr", test::made_exr(fewer)}), HasSubstr("tiles of 20000 x 20000"));
    const MadeSizes channels{8, 4, 1, 30000, 0, 0, 0};
    EXPECT_THAT(refusal_of({"a.tif", test::made_tiff(channels)}), HasSubstr("30000 channels"));
    EXPECT_THAT(refusal_of({"a.sgi", test::made_sgi(channels)}), HasSubstr("30000 channels"));
    // Its reader makes two tables with an entry for each row of each channel.
    const MadeSizes rows{1, 65535, 1, 1024, 0, 0, 0};
    EXPECT_THAT(refusal_of({"a.sgi", test::made_sgi(rows)}), HasSubstr("can't hold"));
}

/// Its reader looks at the first three bytes alone, and counts the canvas in 32 bits.
TEST_F(ImageClaims, GifOfNoVersion) {
    std::string gif = test::made_gif({0x8000, 0x8000, 1, 4, 0, 0, 0});
    gif.replace(3, 3, "???");
    EXPECT_THAT(refusal_of({"a.gif", gif}), HasSubstr("can't hold"));
}

/// OpenImageIO's reader says one channel, as all colours of the table are grey, and writes three.
TEST_F(ImageClaims, GreyBitmapOfRunLengths) {
    const std::string path = folder_.write("a.bmp", test::made_bmp({}));
    EXPECT_EQ(image_library().read(path).channels, 3u);
    EXPECT_EQ(textures_->open(path)->channels(), 3);
}

TEST_F(ImageClaims, MessagesHoldNoControlCharacters) {
    std::string exr = test::made_exr({8, 4, 1, 1, 0, 0, 0});
    const std::size_t channel = exr.find("chlist") + 11;
    exr[channel] = '\x1B';      // its name
    exr[channel + 2] = '\x4D';  // its type, which is none
    EXPECT_THAT(refusal_of({"a.exr", exr}), HasSubstr("\"?\""));
}

TEST_F(ImageClaims, TilesThatHaveNoSize) {
    for (const std::uint32_t layers : {0u, 0xFFFFFFFFu}) {
        std::string tiff = test::made_tiff({8, 4, 1, 3, 16, 16, 0x12345678});
        const std::size_t at = tiff.find("\x78\x56\x34\x12");
        ASSERT_NE(at, std::string::npos);
        for (int i = 0; i < 4; ++i)
            tiff[at + i] = static_cast<char>(layers >> (8 * i));
        EXPECT_NE(refusal_of({"a.tif", tiff}), "") << layers;
    }
}

/// OpenImageIO's reader would never end, or divide by zero.
TEST_F(ImageClaims, KindsOfDdsThatAreNotRead) {
    constexpr std::size_t kKind = 80, kBits = 88, kRed = 92;
    const std::string whole = test::made_dds({});
    EXPECT_EQ(refusal_of({"a.dds", whole}), "");
    const auto edited = [&](std::size_t at, const std::string& bytes) {
        std::string file = whole;
        file.replace(at, bytes.size(), bytes);
        return refusal_of({"a.dds", file});
    };
    const std::string four(4, '\0');
    EXPECT_THAT(edited(kRed, four), HasSubstr("a kind of DDS that is not read"));
    EXPECT_THAT(edited(kBits, "\x07"), HasSubstr("a kind of DDS that is not read"));
    EXPECT_THAT(edited(kBits, "\x40"), HasSubstr("a kind of DDS that is not read"));
    for (const char* multiplied : {"DXT2", "DXT4"}) {
        EXPECT_THAT(edited(kKind, "\x04" + four.substr(1) + multiplied),
                    HasSubstr("a kind of DDS that is not read"));
    }
}

/// OpenEXR makes room for what an attribute claims before it reads it.
TEST_F(ImageClaims, AttributesOfGigabytes) {
    const LittleMemory little;
    for (const char* type : {"string", "odd", "preview", "stringvector", "floatvector", "bytes"}) {
        const std::string attribute = test::exr_attribute("a", type, 0x7FFFFF00, "x");
        EXPECT_NE(refusal_of({"a.exr", test::made_exr({}, attribute)}), "") << type;
    }
    // A preview's sides, and the length of a text in a list.
    const std::string sides(8, '\x7F'), length(4, '\x7F');
    EXPECT_THAT(
        refusal_of({"a.exr", test::made_exr({}, test::exr_attribute("a", "preview", 8, sides))}),
        HasSubstr("another size than it says"));
    EXPECT_THAT(refusal_of({"a.exr", test::made_exr(
                                         {}, test::exr_attribute("a", "stringvector", 4, length))}),
                HasSubstr("another size than it says"));
}

/// Formats whose readers ask for what a file claims as they open it.
TEST_F(ImageClaims, FormatsThatAreNotRead) {
    for (const char* ending : {"psd", "dpx", "ico", "fits", "null", "vdb", "mp4"})
        EXPECT_THAT(refusal_of({std::string("a.") + ending, "8BPS SDPX SIMPLE"}),
                    HasSubstr("it has none of the formats openexr, hdr, png, "))
            << ending;
}

TEST_F(ImageClaims, EveryPrefixOfEveryFormatIsReadOrRefused) {
    for (const MadeImage& image : test::small_images()) {
        const std::size_t step = image.bytes.size() / 64 + 1;
        for (std::size_t size = 0; size < image.bytes.size(); size += step)
            (void)refusal_of({image.name, image.bytes.substr(0, size)});
    }
}

}  // namespace
}  // namespace lxs::image_claims_test
