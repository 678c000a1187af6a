// Writes whole files so that a reader never sees a half-written one.
#include "lxs/imaging/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace lxs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
    throw std::runtime_error(
        fmt::format("cannot write '{}': {}", path, std::generic_category().message(error)));
}

/// An open file descriptor that closes itself. Its functions return errno, 0 for success.
class OpenFile {
  public:
    OpenFile(const std::string& path, int flags)
        : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)),
          open_error_(descriptor_ < 0 ? errno : 0) {}
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

/// Where a symbolic link leads, so that the rename replaces the file and not the link.
std::string real_target(const std::string& path) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target.string();
}

void write_in_place(const std::string& path, std::span<const std::byte> bytes) {
    OpenFile file(path, O_WRONLY);
    int error = file.open_error();
    if (error == 0) error = file.write(bytes);
    if (error == 0) error = file.flush();
    if (error == 0) error = file.close();
    if (error != 0) fail(path, error);
}

int write_temporary(const std::string& temporary, std::span<const std::byte> bytes,
                    const struct stat* older) {
    OpenFile file(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (file.open_error() != 0) return file.open_error();
    if (older != nullptr) file.copy_mode_of(*older);
    int error = file.write(bytes);
    if (error == 0) error = file.flush();
    if (error == 0) error = file.close();
    return error;
}

/// Makes the rename itself survive a power failure; not all file systems can, so errors are no
/// news.
void flush_folder(const fs::path& folder) {
    const OpenFile open(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
    if (open.open_error() == 0) open.flush();
}

}  // namespace

void write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
    const std::string target = real_target(path);
    struct stat older {};
    const bool exists = ::stat(target.c_str(), &older) == 0;
    if (exists && S_ISDIR(older.st_mode)) fail(path, EISDIR);
    if (exists && !S_ISREG(older.st_mode)) return write_in_place(target, bytes);

    const fs::path folder = fs::path(target).parent_path();
    const std::string temporary =
        (folder / fmt::format(".{}.{}.tmp", fs::path(target).filename().string(), ::getpid()))
            .string();
    int error = write_temporary(temporary, bytes, exists ? &older : nullptr);
    if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(temporary.c_str());
        fail(path, error);
    }
    flush_folder(folder);
}

}  // namespace lxs
