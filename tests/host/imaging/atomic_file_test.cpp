// Protects files that are being replaced: an error leaves the older file whole and nothing beside
// it, and says which file and why.
#include "lxs/imaging/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "scene_options.h"

namespace lxs::test::atomic_file_test {
namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

std::string write_error(const std::string& path, const std::string& text) {
    try {
        write_file_atomically(path, bytes_of(text));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

/// Lets no file of this process grow beyond `size`, and turns the signal for it into an error.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t size) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &older_);
        rlimit limit = older_;
        limit.rlim_cur = size;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &older_);
        ::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit older_{};
    void (*handler_)(int);
};

TEST(AtomicFile, WritesAndReplaces) {
    const TemporaryFolder folder;
    const std::string path = folder / "image";
    write_file_atomically(path, bytes_of("first"));
    EXPECT_EQ(folder.read("image"), "first");
    ::chmod(path.c_str(), 0640);
    write_file_atomically(path, bytes_of("second"));
    EXPECT_EQ(folder.read("image"), "second");
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u) << "the older file's mode is kept";
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, AFullDiskLeavesTheOlderFileWhole) {
    const TemporaryFolder folder;
    const std::string path = folder / "image";
    write_file_atomically(path, bytes_of("older"));
    std::string error;
    {
        const FileSizeLimit limit(1000);
        error = write_error(path, std::string(5000, 'x'));
    }
    EXPECT_EQ(error, "cannot write '" + path + "': File too large");
    EXPECT_EQ(folder.read("image"), "older");
    EXPECT_EQ(folder.entries(), 1u) << "the temporary file is removed";
}

TEST(AtomicFile, ADeviceIsWrittenInPlace) {
    EXPECT_EQ(write_error("/dev/full", "text"),
              "cannot write '/dev/full': No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a rename would replace the device";
    EXPECT_EQ(write_error("/dev/null", "text"), "");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(AtomicFile, MissingFolder) {
    const TemporaryFolder folder;
    const std::string path = folder / "none/image";
    EXPECT_EQ(write_error(path, "text"), "cannot write '" + path + "': No such file or directory");
}

TEST(AtomicFile, ReadOnlyFolder) {
    if (::geteuid() == 0) GTEST_SKIP() << "root writes everywhere";
    const TemporaryFolder folder;
    const std::string inner = folder / "inner";
    fs::create_directory(inner);
    write_file_atomically(inner + "/image", bytes_of("older"));
    fs::permissions(inner, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(write_error(inner + "/image", "text"),
              "cannot write '" + inner + "/image': Permission denied");
    EXPECT_EQ(folder.read("inner/image"), "older");
    fs::permissions(inner, fs::perms::owner_all);
}

TEST(AtomicFile, AFolderIsNoFile) {
    const TemporaryFolder folder;
    const std::string path = folder / "image";
    fs::create_directory(path);
    EXPECT_EQ(write_error(path, "text"), "cannot write '" + path + "': Is a directory");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, ASymbolicLinkStaysALink) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "target", bytes_of("older"));
    fs::create_symlink(folder / "target", folder / "link");
    write_file_atomically(folder / "link", bytes_of("newer"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(folder.read("target"), "newer");
}

TEST(AtomicFile, WhatIsNotCommittedLeavesNothing) {
    const TemporaryFolder folder;
    folder.write("image", "older");
    {
        AtomicFile file(folder / "image");
        file.write(bytes_of("half of"));
        EXPECT_EQ(folder.entries(), 2u);
    }
    EXPECT_EQ(folder.read("image"), "older");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, AbandonedTemporariesGoAndThoseInUseStay) {
    const TemporaryFolder folder;
    folder.write(".image.4194305.tmp", "of a process that was killed");
    folder.write(".image.old.tmp", "of somebody else");
    folder.write(".image2.4194305.tmp", "of another file");
    AtomicFile file(folder / "image");
    file.write(bytes_of("new"));
    remove_abandoned_temporaries(folder / "image");
    EXPECT_FALSE(folder.has(".image.4194305.tmp"));
    EXPECT_TRUE(folder.has(".image.old.tmp"));
    EXPECT_TRUE(folder.has(".image2.4194305.tmp"));
    file.commit();
    EXPECT_EQ(folder.read("image"), "new");
}

/// To wait for a reader could take for ever.
TEST(AtomicFile, APipeIsWrittenIfItHasAReader) {
    const TemporaryFolder folder;
    const std::string path = folder / "pipe";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    EXPECT_EQ(write_error(path, "text"),
              "cannot write '" + path + "': nobody reads from this pipe");
    remove_abandoned_temporaries(path);
    std::string read(1 << 20, '\0');  // more than a pipe holds
    std::thread reader([&] {
        const int pipe = ::open(path.c_str(), O_RDONLY);
        std::size_t size = 0;
        while (size < read.size()) {
            ::usleep(100);
            const ssize_t got = ::read(pipe, read.data() + size, read.size() - size);
            if (got <= 0) break;
            size += static_cast<std::size_t>(got);
        }
        ::close(pipe);
    });
    const std::string text(read.size(), 'x');
    std::string error = "not tried";
    while (!error.empty())  // the reader comes in its time
        error = write_error(path, text);
    reader.join();
    EXPECT_EQ(read, text);
    EXPECT_EQ(folder.entries(), 1u);
}

}  // namespace
}  // namespace lxs::test::atomic_file_test
