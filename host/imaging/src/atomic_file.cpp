// Writes whole files so that a reader never sees a half-written one.
#include "lxs/imaging/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <random>
#include <stdexcept>
#include <system_error>

#include "lxs/imaging/file_name.h"

namespace lxs {

namespace fs = std::filesystem;

/// An open file that closes itself. Its functions return errno, 0 for success.
class AtomicFile::OpenFile {
  public:
    /// Does not wait for a reader of a pipe, which may never come: without one the error is ENXIO.
    OpenFile(const std::string& path, int flags)
        : descriptor_(::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666)),
          open_error_(descriptor_ < 0 ? errno : 0) {
        // A reader that is there may take its time.
        if (descriptor_ >= 0) ::fcntl(descriptor_, F_SETFL, flags & O_ACCMODE);
    }
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
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

    /// Says as long as the file is open that it has a writer.
    int lock() const { return ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 ? errno : 0; }

    /// Some file systems tell first when a file is closed that what was written is lost. The lock
    /// stays, as the file is closed by another name.
    int close_copy() const {
        const int copy = ::dup(descriptor_);
        return copy < 0 || ::close(copy) != 0 ? errno : 0;
    }

    void copy_mode_of(const struct stat& older) const {
        // A failure leaves the mode that the umask gives, which is no reason to lose an image.
        [[maybe_unused]] const int ignored = ::fchmod(descriptor_, older.st_mode & 07777);
    }

  private:
    int descriptor_;
    int open_error_;
};

namespace {

constexpr std::string_view kTemporarySuffix = ".tmp";
constexpr std::size_t kRandomDigits = 16;

/// What names of temporary files beside `target` begin with. A name that is as long as names can
/// be leaves no room for more, and is cut.
std::string temporary_prefix(const fs::path& target) {
    const std::size_t added = 2 + kRandomDigits + kTemporarySuffix.size();  // with two dots
    const std::size_t longest = longest_name(target.parent_path());
    const std::size_t room = longest - std::min(longest, added);
    return fmt::format(".{}.", cut_name(target.filename().string(), room));
}

/// A name that no other writer has, in whatever process or container of whatever machine.
fs::path temporary_name(const fs::path& target) {
    std::random_device random;
    const std::uint64_t number = (std::uint64_t{random()} << 32) + random();
    return target.parent_path() / fmt::format("{}{:0{}x}{}", temporary_prefix(target), number,
                                              kRandomDigits, kTemporarySuffix);
}

/// Whether `name` is that of a temporary file of any process.
bool is_temporary(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix) || !name.ends_with(kTemporarySuffix)) return false;
    if (name.size() <= prefix.size() + kTemporarySuffix.size()) return false;
    name = name.substr(prefix.size(), name.size() - prefix.size() - kTemporarySuffix.size());
    return name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// What is at `path`, links followed; nothing if there is none. Else `error` says why that is not
/// known.
std::optional<struct stat> status_of(const fs::path& path, int& error) {
    struct stat status {};
    error = ::stat(path.c_str(), &status) != 0 ? errno : 0;
    if (error == 0) return status;
    if (error == ENOENT) error = 0;
    return std::nullopt;
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
    int error = 0;
    const auto older = status_of(path, error);
    check(error);
    if (older && S_ISDIR(older->st_mode)) check(EISDIR);
    if (older && !S_ISREG(older->st_mode)) {
        file_ = std::make_unique<OpenFile>(path, O_WRONLY);
        if (S_ISFIFO(older->st_mode) && file_->open_error() == ENXIO)
            throw std::runtime_error(
                fmt::format("cannot write '{}': nobody reads from this pipe", path_));
        check(file_->open_error());
        return;
    }
    std::error_code circle;
    target_ = follow_links(path, circle).string();  // so that the rename replaces no link
    check(circle.value());
    constexpr int kMostTries = 100;
    for (int tries = 1; !open_temporary(); ++tries) {
        if (tries == kMostTries) check(EEXIST);
    }
    if (older) file_->copy_mode_of(*older);
}

bool AtomicFile::open_temporary() {
    const std::string name = temporary_name(target_).string();
    file_ = std::make_unique<OpenFile>(name, O_WRONLY | O_CREAT | O_EXCL);
    if (file_->open_error() == EEXIST) return false;
    check(file_->open_error());
    lock_error_ = file_->lock();
    // Whoever removes what was abandoned may have come between opening and locking.
    std::error_code ignored;
    if (lock_error_ == EWOULDBLOCK || !fs::exists(name, ignored)) {
        ::unlink(name.c_str());
        return false;
    }
    temporary_ = name;
    return true;
}

std::error_code AtomicFile::lock_error() const {
    return {lock_error_, std::generic_category()};
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
    check(file_->close_copy());
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

std::error_code probe_atomic_file(const std::string& path) {
    int error = 0;
    const auto older = status_of(path, error);
    const bool in_place = older && !S_ISREG(older->st_mode) && !S_ISDIR(older->st_mode);
    // To open a pipe or a device is to use it.
    if (in_place && ::access(path.c_str(), W_OK) == 0) return {};
    return AtomicFile(path).lock_error();
}

void remove_abandoned_temporaries(const std::string& path) {
    std::error_code ignored;
    const fs::path target = follow_links(path, ignored);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    const std::string prefix = temporary_prefix(target);
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        if (!is_temporary(entry.path().filename().string(), prefix)) continue;
        const int file = ::open(entry.path().c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
        if (file < 0) continue;
        if (::flock(file, LOCK_EX | LOCK_NB) == 0) fs::remove(entry.path(), ignored);
        ::close(file);
    }
}

}  // namespace lxs
