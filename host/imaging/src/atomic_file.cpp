// Writes whole files so that a reader never sees a half-written one.
#include "lxs/imaging/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace lxs {

namespace fs = std::filesystem;

/// An open file descriptor that closes itself. Its functions return errno, 0 for success.
class AtomicFile::OpenFile {
  public:
    /// Does not wait for a reader of a pipe, which may never come: without one the error is ENXIO.
    OpenFile(const std::string& path, int flags)
        : descriptor_(::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666)),
          open_error_(descriptor_ < 0 ? errno : 0) {
        // A reader that is there may take its time.
        if (descriptor_ >= 0) ::fcntl(descriptor_, F_SETFL, flags & O_ACCMODE);
    }
    ~OpenFile() { close(); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    int open_error() const { return open_error_; }

    int write(std::span<const std::byte> bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return errno;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return 0;
    }

    /// Devices and pipes know no flushing (EINVAL): nothing is lost there.
    int flush() const { return ::fsync(descriptor_) != 0 && errno != EINVAL ? errno : 0; }

    /// Says as long as the file is open that it has a writer; some file systems know no locks.
    void lock() const {
        [[maybe_unused]] const int ignored = ::flock(descriptor_, LOCK_EX | LOCK_NB);
    }

    void copy_mode_of(const struct stat& older) const {
        // A failure leaves the mode that the umask gives, which is no reason to lose an image.
        [[maybe_unused]] const int ignored = ::fchmod(descriptor_, older.st_mode & 07777);
    }

    int close() {
        const int descriptor = descriptor_;
        descriptor_ = -1;
        return descriptor >= 0 && ::close(descriptor) != 0 ? errno : 0;
    }

  private:
    int descriptor_;
    int open_error_;
};

namespace {

/// Where a symbolic link leads, so that the rename replaces the file and not the link.
std::string real_target(const std::string& path) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target.string();
}

constexpr std::string_view kTemporarySuffix = ".tmp";

std::string temporary_prefix(const fs::path& target) {
    return fmt::format(".{}.", target.filename().string());
}

/// Whether `name` is that of a temporary file of any process.
bool is_temporary(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix) || !name.ends_with(kTemporarySuffix)) return false;
    if (name.size() <= prefix.size() + kTemporarySuffix.size()) return false;
    name = name.substr(prefix.size(), name.size() - prefix.size() - kTemporarySuffix.size());
    return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(real_target(path)) {
    struct stat older {};
    const bool exists = ::stat(target_.c_str(), &older) == 0;
    if (exists && S_ISDIR(older.st_mode)) check(EISDIR);
    if (exists && !S_ISREG(older.st_mode)) {
        file_ = std::make_unique<OpenFile>(target_, O_WRONLY);
        if (S_ISFIFO(older.st_mode) && file_->open_error() == ENXIO)
            throw std::runtime_error(
                fmt::format("cannot write '{}': nobody reads from this pipe", path_));
        check(file_->open_error());
        return;
    }
    const fs::path target(target_);
    temporary_ = (target.parent_path() /
                  fmt::format("{}{}{}", temporary_prefix(target), ::getpid(), kTemporarySuffix))
                     .string();
    file_ = std::make_unique<OpenFile>(temporary_, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (file_->open_error() != 0) temporary_.clear();  // none of ours
    check(file_->open_error());
    file_->lock();
    if (exists) file_->copy_mode_of(older);
}

AtomicFile::~AtomicFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::check(int error) const {
    if (error == 0) return;
    throw std::runtime_error(
        fmt::format("cannot write '{}': {}", path_, std::generic_category().message(error)));
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    check(file_->write(bytes));
}

void AtomicFile::commit() {
    check(file_->flush());
    check(file_->close());
    if (temporary_.empty()) return;
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) check(errno);
    temporary_.clear();
    // Makes the rename itself survive a power failure; not all file systems can, so errors are no
    // news.
    const fs::path folder = fs::path(target_).parent_path();
    const OpenFile open(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
    if (open.open_error() == 0) open.flush();
}

void write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void remove_abandoned_temporaries(const std::string& path) {
    const fs::path target(real_target(path));
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    const std::string prefix = temporary_prefix(target);
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        if (!is_temporary(entry.path().filename().string(), prefix)) continue;
        const int file = ::open(entry.path().c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
        if (file < 0) continue;
        if (::flock(file, LOCK_EX | LOCK_NB) == 0) fs::remove(entry.path(), ignored);
        ::close(file);
    }
}

}  // namespace lxs
