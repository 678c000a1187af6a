// Protects files that are being replaced: an error leaves the older file whole and nothing beside
// it, and says which file and why.
#include "lxs/imaging/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "scene_options.h"

namespace {
/// What locking fails with: a file system without locks.
int no_lock = 0;
}  // namespace

/// Takes the place of the system's.
extern "C" int flock(int file, int operation) noexcept {
    if (no_lock == 0) return static_cast<int>(::syscall(SYS_flock, file, operation));
    errno = no_lock;
    return -1;
}

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

TEST(AtomicFile, ASymbolicLinkToNothingIsFollowedToo) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "inner");
    fs::create_symlink("inner/second", folder / "first");
    fs::create_symlink("target", folder / "inner/second");
    write_file_atomically(folder / "first", bytes_of("text"));
    EXPECT_TRUE(fs::is_symlink(folder / "first"));
    EXPECT_TRUE(fs::is_symlink(folder / "inner/second"));
    EXPECT_EQ(folder.read("inner/target"), "text");
}

TEST(AtomicFile, LinksInACircle) {
    const TemporaryFolder folder;
    const std::string path = folder / "a";
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    const std::string message = "cannot write '" + path + "': Too many levels of symbolic links";
    EXPECT_EQ(write_error(path, "text"), message);
    EXPECT_THROW(probe_atomic_file(path), std::runtime_error);
    EXPECT_TRUE(fs::is_symlink(folder / "a"));
    EXPECT_EQ(folder.entries(), 2u);
}

/// Names of temporary files are no longer than names may be.
TEST(AtomicFile, ANameMayBeAsLongAsNamesCanBe) {
    const TemporaryFolder folder;
    const std::string two_bytes = "\xC3\xA4";
    std::string odd = "x";
    for (int i = 0; i < 127; ++i)
        odd += two_bytes;
    for (const std::string& name : {std::string(233, 'a'), std::string(234, 'b'),
                                    std::string(245, 'c'), std::string(255, 'd'), odd}) {
        probe_atomic_file(folder / name);
        write_file_atomically(folder / name, bytes_of(name));
        write_file_atomically(folder / name, bytes_of(name));
        EXPECT_EQ(folder.read(name), name);
    }
    EXPECT_EQ(folder.entries(), 5u);
    const std::string path = folder / std::string(256, 'e');
    EXPECT_EQ(write_error(path, "text"), "cannot write '" + path + "': File name too long");
    EXPECT_THROW(probe_atomic_file(path), std::runtime_error);
}

/// As two processes of one number do, in containers that share a folder.
TEST(AtomicFile, WritersOfOneNumberDoNotMeet) {
    const TemporaryFolder folder;
    AtomicFile first(folder / "image"), second(folder / "image");
    first.write(bytes_of("first"));
    second.write(bytes_of("the second"));
    first.commit();
    EXPECT_EQ(folder.read("image"), "first");
    second.commit();
    EXPECT_EQ(folder.read("image"), "the second");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, WithoutLocksWritingGoesOnAndTells) {
    const TemporaryFolder folder;
    EXPECT_FALSE(probe_atomic_file(folder / "image"));
    no_lock = ENOLCK;
    EXPECT_EQ(probe_atomic_file(folder / "image").message(), "No locks available");
    EXPECT_EQ(write_error(folder / "image", "text"), "");
    folder.write(".image.12ab.tmp", "may be in use");
    remove_abandoned_temporaries(folder / "image");
    no_lock = 0;
    EXPECT_EQ(folder.read("image"), "text");
    EXPECT_TRUE(folder.has(".image.12ab.tmp"));
}

/// A render that begins removes what others have left, not what they are writing.
TEST(AtomicFile, NoWriterLosesItsFileToWhoeverRemovesAbandonedOnes) {
    const TemporaryFolder folder;
    std::atomic<bool> written = false;
    std::thread remover([&] {
        while (!written)
            remove_abandoned_temporaries(folder / "image");
    });
    std::string error;
    for (int i = 0; i < 300 && error.empty(); ++i)
        error = write_error(folder / "image", "text");
    written = true;
    remover.join();
    EXPECT_EQ(error, "");
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
