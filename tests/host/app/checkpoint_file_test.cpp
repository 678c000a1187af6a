// Protects the file format of checkpoints: what is written comes back, every flipped byte and every
// truncation is found, other versions are named, and no size that a file claims is believed.
#include "lxs/host/checkpoint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace lxs::test::checkpoint_file_test {
namespace {

using files::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

struct Figures {
    std::uint64_t count = 0;
    double sum = 0;
    bool flag = false;
    std::string name;
    std::vector<float> values;
    std::vector<double> fixed = std::vector<double>(3);

    void state(StateArchive& archive) {
        archive.value(count);
        archive.value(sum);
        archive.value(flag);
        archive.text(name);
        archive.values(values);
        archive.fixed(fixed);
    }
};

/// A small checkpoint as it stands in a file.
std::string whole_file(const TemporaryFolder& folder) {
    Figures figures{7, 0.1, true, "seven", {1, 2.5f, -3}, {4, 5, 6}};
    CheckpointWriter writer(folder / "check");
    figures.state(writer);
    writer.commit();
    return folder.read("check");
}

/// What is wrong with a file, "" if nothing.
std::string complaint(const std::string& file) {
    try {
        checkpoint_content(bytes_of(file));
    } catch (const StateError& error) {
        return error.what();
    }
    return "";
}

/// What is wrong with a content, "" if nothing.
template <class Restore>
std::string restore_error(std::span<const std::byte> content, const Restore& restore) {
    CheckpointReader reader(content);
    try {
        restore(reader);
    } catch (const StateError& error) {
        return error.what();
    }
    return "";
}

TEST(CheckpointFile, WhatIsWrittenComesBack) {
    const TemporaryFolder folder;
    const std::string file = whole_file(folder);
    EXPECT_EQ(folder.entries(), 1u);
    const auto read = read_checkpoint_file(folder / "check");
    ASSERT_EQ(read.size(), file.size());
    CheckpointReader reader(checkpoint_content(read));
    Figures figures;
    figures.state(reader);
    EXPECT_EQ(figures.count, 7u);
    EXPECT_EQ(figures.sum, 0.1);
    EXPECT_TRUE(figures.flag);
    EXPECT_EQ(figures.name, "seven");
    EXPECT_EQ(figures.values, (std::vector<float>{1, 2.5f, -3}));
    EXPECT_EQ(figures.fixed, (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(reader.remaining(), 0u);
}

TEST(CheckpointFile, MoreThanTheBufferHoldsComesBack) {
    const TemporaryFolder folder;
    std::vector<std::uint32_t> many(700'001);
    for (std::uint32_t i = 0; i < many.size(); ++i)
        many[i] = i * 2654435761u;
    CheckpointWriter writer(folder / "check");
    bool before = true;
    writer.value(before);
    writer.values(many);
    writer.commit();
    const auto read = read_checkpoint_file(folder / "check");
    CheckpointReader reader(checkpoint_content(read));
    std::vector<std::uint32_t> back;
    reader.value(before);
    reader.values(back);
    EXPECT_EQ(back, many);
}

TEST(CheckpointFile, EveryFlippedBitIsFound) {
    const TemporaryFolder folder;
    const std::string file = whole_file(folder);
    ASSERT_EQ(complaint(file), "");
    for (std::size_t i = 0; i < file.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = file;
            damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
            EXPECT_NE(complaint(damaged), "") << "byte " << i << ", bit " << bit;
        }
    }
}

TEST(CheckpointFile, EveryTruncationAndEveryTailIsFound) {
    const TemporaryFolder folder;
    const std::string file = whole_file(folder);
    for (std::size_t size = 0; size < file.size(); ++size)
        EXPECT_NE(complaint(file.substr(0, size)), "") << size << " bytes";
    EXPECT_NE(complaint(file + '\0'), "");
    EXPECT_NE(complaint(file + file), "");
}

TEST(CheckpointFile, AnotherVersionIsNamedWhateverFollows) {
    const TemporaryFolder folder;
    std::string file = whole_file(folder);
    file[8] = static_cast<char>(kCheckpointVersion + 1);
    const std::string named =
        "version " + std::to_string(kCheckpointVersion + 1) + " of the format";
    EXPECT_THAT(complaint(file), HasSubstr(named));
    EXPECT_THAT(complaint(file.substr(0, 16)), HasSubstr(named));
}

TEST(CheckpointFile, OtherFilesAreNone) {
    const TemporaryFolder folder;
    folder.write("text", "LookAt 0 0 0  1 1 1  0 0 1 and what else stands in a scene");
    folder.write("empty", "");
    for (const auto& path : {folder / "text", folder / "empty", std::string("/dev/null"),
                             std::string("/dev/zero"), std::string("/"), folder / "absent"}) {
        EXPECT_THROW(read_checkpoint_file(path), StateError) << path;
    }
}

TEST(CheckpointFile, AnAbandonedOneLeavesNothing) {
    const TemporaryFolder folder;
    const std::string file = whole_file(folder);
    {
        CheckpointWriter writer(folder / "check");
        std::vector<std::byte> much(std::size_t{3} << 20);
        writer.values(much);
    }
    EXPECT_EQ(folder.read("check"), file);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(StateArchive, ClaimedSizesAreComparedWithWhatIsLeft) {
    for (const std::uint64_t claimed :
         {std::uint64_t{5}, std::uint64_t{1} << 32, std::uint64_t{1} << 61,
          ~std::uint64_t{0} / sizeof(double) + 2, ~std::uint64_t{0}}) {
        std::vector<std::uint64_t> content{claimed, 1, 2, 3, 4};
        const auto bytes = std::as_bytes(std::span(content));
        std::vector<double> values;
        EXPECT_THAT(restore_error(bytes, [&](StateArchive& a) { a.values(values); }),
                    HasSubstr("more than there is"));
        EXPECT_EQ(values.capacity(), 0u);
        std::string text;
        if (claimed > 32) {
            EXPECT_THAT(restore_error(bytes, [&](StateArchive& a) { a.text(text); }),
                        HasSubstr("more than there is"));
        }
        EXPECT_EQ(text, "");
    }
}

TEST(StateArchive, WhatDoesNotFitIsRefused) {
    const std::vector<std::uint64_t> content{4, 1, 2, 3, 4};
    const auto bytes = std::as_bytes(std::span(content));
    std::vector<std::uint64_t> three(3), four(4);
    EXPECT_THAT(restore_error(bytes, [&](StateArchive& a) { a.fixed(three); }),
                HasSubstr("4 elements where there are 3"));
    EXPECT_EQ(restore_error(bytes, [&](StateArchive& a) { a.fixed(four); }), "");
    EXPECT_EQ(four, (std::vector<std::uint64_t>{1, 2, 3, 4}));
    bool flag = false;
    EXPECT_THAT(restore_error(bytes, [&](StateArchive& a) { a.value(flag); }),
                HasSubstr("neither 0 nor 1"));
    EXPECT_THAT(restore_error(bytes.first(7), [&](StateArchive& a) { a.value(three[0]); }),
                HasSubstr("ends too soon"));
}

}  // namespace
}  // namespace lxs::test::checkpoint_file_test
