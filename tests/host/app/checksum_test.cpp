// Protects: checksums of a scene's files tell every block of a file, its end and the order of
// files, on any number of threads; a file that can't be read is named, the first of several.
#include "lxs/host/checksum.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <system_error>

#include "temporary_folder.h"

namespace lxs::test {
namespace {

/// Several of the blocks that files are read in, and a part of one.
constexpr std::size_t kFileBytes = (std::size_t{9} << 20) + 12'345;

class ChecksumTest : public testing::Test {
  protected:
    std::string file(const std::string& name, const std::string& content) const {
        return folder_.write(name, content);
    }
    static std::uint64_t sum_of(const std::vector<std::string>& paths) {
        Checksum sum;
        sum.add_files(paths);
        return sum.value();
    }

    files::TemporaryFolder folder_;
};

TEST_F(ChecksumTest, TellsEachBlock) {
    const std::string content(kFileBytes, 'a');
    const std::uint64_t whole = sum_of({file("file", content)});
    EXPECT_EQ(sum_of({file("again", content)}), whole);
    for (const std::size_t at : {std::size_t{0}, std::size_t{5} << 20, kFileBytes - 1}) {
        std::string other = content;
        other[at] = 'b';
        EXPECT_NE(sum_of({file("other", other)}), whole) << at;
    }
    const std::string ends = 'x' + std::string(kFileBytes - 2, 'a') + 'y';
    EXPECT_NE(sum_of({file("ends", ends)}), sum_of({file("turned", {ends.rbegin(), ends.rend()})}));
    EXPECT_NE(sum_of({file("shorter", content.substr(1))}), whole);
    EXPECT_NE(sum_of({file("longer", content + 'a')}), whole);
}

TEST_F(ChecksumTest, TellsTheOrderOfFiles) {
    const std::string a = file("a", "a"), b = file("b", "b"), none = file("none", "");
    EXPECT_NE(sum_of({a, b}), sum_of({b, a}));
    EXPECT_NE(sum_of({a, none}), sum_of({a}));
}

TEST_F(ChecksumTest, DoesNotDependOnThreads) {
    const std::vector<std::string> paths{file("a", std::string(kFileBytes, 'a')), file("b", "b")};
    const std::uint64_t many = sum_of(paths);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(sum_of(paths), many);
}

TEST_F(ChecksumTest, NamesTheFirstFileThatCannotBeRead) {
    const std::string good = file("good", "good");
    const std::filesystem::path folder = folder_.path() / "folder", missing = "missing";
    std::filesystem::create_directory(folder);
    const auto refusal = [](const std::vector<std::string>& paths) -> std::string {
        try {
            sum_of(paths);
        } catch (const std::system_error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal({good, missing, folder}), "can't read 'missing': No such file or directory");
    EXPECT_EQ(refusal({good, folder, missing}),
              "can't read '" + folder.string() + "': Is a directory");
}

}  // namespace
}  // namespace lxs::test
