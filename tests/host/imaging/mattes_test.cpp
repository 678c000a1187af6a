// Protects masks of objects and materials: ids and header by the published format, and coverage by
// the filter's weights.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "cryptomatte.h"
#include "exr_channels.h"
#include "film_samples.h"
#include "memory_archive.h"

namespace lxs::test::mattes_test {
namespace {

/// Values of Appleby's reference implementation.
TEST(Cryptomatte, HashesAsPublished) {
    EXPECT_EQ(murmur_hash_3(""), 0u);
    EXPECT_EQ(murmur_hash_3("hello"), 0x248bfa47u);
    EXPECT_EQ(murmur_hash_3("hello, world"), 0x149bbb7fu);
    EXPECT_EQ(murmur_hash_3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(Cryptomatte, IdsAreNormalFloats) {
    std::mt19937 random(1);
    unsigned turned = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::string name = "object " + std::to_string(random());
        const std::uint32_t id = cryptomatte_id(name);
        EXPECT_TRUE(std::isnormal(std::bit_cast<float>(id))) << name;
        if (id == murmur_hash_3(name)) continue;
        ++turned;
        EXPECT_EQ(id ^ murmur_hash_3(name), 1u << 23) << name;
    }
    EXPECT_GT(turned, 0u);
}

TEST(Cryptomatte, HeaderNamesLayerAndIds) {
    ImageMetadata metadata{{"seed", "7"}};
    const std::vector<std::string> names{"hello", "a \"b\"\n", "hello"};
    add_cryptomatte_header("CryptoObject", names, metadata);
    EXPECT_EQ(metadata.size(), 5u);
    EXPECT_EQ(metadata.at("cryptomatte/3ae39a5/name"), "CryptoObject");
    EXPECT_EQ(metadata.at("cryptomatte/3ae39a5/hash"), "MurmurHash3_32");
    EXPECT_EQ(metadata.at("cryptomatte/3ae39a5/conversion"), "uint32_to_float32");
    const std::string& manifest = metadata.at("cryptomatte/3ae39a5/manifest");
    EXPECT_EQ(manifest.substr(0, 16), "{\"a \\\"b\\\"\\u000a\"");
    EXPECT_NE(manifest.find(",\"hello\":\"248bfa47\"}"), std::string::npos);
}

constexpr int kWidth = 5, kHeight = 4;

std::unique_ptr<FileFilm> film(std::size_t names, const std::string& filter = "box") {
    SceneContents contents = scene_of_size(kWidth, kHeight);
    contents.options["Film"].parameters.values.push_back(
        {"string", "layers", std::vector<std::string>{"objects", "materials"}, place(2, 5), {}});
    set_option(contents, "PixelFilter", filter, {});
    auto made = make(contents);
    std::vector<std::string> objects;
    for (std::size_t i = 0; i < names; ++i)
        objects.push_back("object " + std::to_string(i));
    made->set_names(objects, std::vector<std::string>{"only"});
    return made;
}

/// A sample in the middle of each pixel.
void add(FileFilm& film, std::uint32_t object) {
    const Samples samples = pixel_centres(film, Rgb(1.0f));
    SeenSurface seen;
    seen.object = object;
    seen.material = object == kNoName ? kNoName : 0;
    film.add_pass(samples.pass());
    film.add_surfaces(samples.positions, std::vector<SeenSurface>(samples.positions.size(), seen));
}

float id_of(int object) {
    return std::bit_cast<float>(cryptomatte_id("object " + std::to_string(object)));
}

TEST(Mattes, TellSharesTheGreatestFirst) {
    const auto mattes = film(4);
    for (const std::uint32_t object : {2u, 1u, kNoName, 1u, 3u, 1u, 2u, 99u})
        add(*mattes, object);
    const auto channels = channels_of(*mattes);
    const std::array<float, 3> ids{id_of(1), id_of(2), id_of(3)},
        shares{3 / 8.0f, 2 / 8.0f, 1 / 8.0f};
    const std::array<std::string, 3> places{"00.R", "00.B", "01.R"}, covers{"00.G", "00.A", "01.G"};
    for (std::size_t rank = 0; rank < 3; ++rank) {
        for (const float id : channels.at("CryptoObject" + places[rank]))
            EXPECT_EQ(id, ids[rank]);
        for (const float share : channels.at("CryptoObject" + covers[rank]))
            EXPECT_FLOAT_EQ(share, shares[rank]);
    }
    EXPECT_EQ(channels.at("CryptoObject01.A").front(), 0.0f);
    EXPECT_EQ(channels.at("CryptoObject02.R").front(), 0.0f);
    EXPECT_EQ(channels.at("CryptoMaterial00.R").front(),
              std::bit_cast<float>(cryptomatte_id("only")));
    EXPECT_FLOAT_EQ(channels.at("CryptoMaterial00.G").front(), 7 / 8.0f);
}

/// Of more than are kept, those with the greatest shares stay.
TEST(Mattes, KeepTheGreatestSharesOfMany) {
    const auto mattes = film(20);
    for (std::uint32_t object = 0; object < 20; ++object)
        add(*mattes, object);
    for (int i = 0; i < 30; ++i)
        add(*mattes, 19);
    const auto channels = channels_of(*mattes);
    EXPECT_EQ(channels.at("CryptoObject00.R").front(), id_of(19));
    EXPECT_GT(channels.at("CryptoObject00.G").front(), 20 / 50.0f);
    EXPECT_LE(channels.at("CryptoObject00.G").front(), 31 / 50.0f);
}

/// Coverage stays within 0 and 1 under a filter with lobes below zero, and is 1 where all samples
/// saw one object.
TEST(Mattes, CoverageIsThatOfTheFilter) {
    const auto mattes = film(1, "mitchell");
    add(*mattes, 0);
    const auto channels = channels_of(*mattes);
    for (const float share : channels.at("CryptoObject00.G"))
        EXPECT_FLOAT_EQ(share, 1);
}

TEST(Mattes, ARestoredFilmGoesOnWithThem) {
    const auto whole = film(3), first = film(3), second = film(3);
    add(*whole, 0);
    add(*whole, 1);
    add(*first, 0);
    MemoryArchive archive;
    first->state(archive);
    archive.restore();
    second->state(archive);
    add(*second, 1);
    EXPECT_EQ(channels_of(*second), channels_of(*whole));
}

}  // namespace
}  // namespace lxs::test::mattes_test
