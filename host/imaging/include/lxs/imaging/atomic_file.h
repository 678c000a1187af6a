// Writes whole files so that a reader never sees a half-written one.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <system_error>

namespace lxs {

/// A file in the making: what is written goes to a temporary file beside `path`, which commit()
/// flushes to the device and renames to `path`; a symbolic link is followed, and a device, or a
/// pipe that has a reader, is written in place. The temporary file's name is the writer's own, and
/// it is locked while it is written. All throw std::runtime_error with the path and the system's
/// reason. Without commit() the temporary file goes with the object, and an older file at `path`
/// stays untouched.
class AtomicFile {
  public:
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::byte> bytes);
    void commit();
    /// Why the temporary file has no lock, as some file systems know none: if its writer is killed
    /// it stays, as remove_abandoned_temporaries() can't tell that nobody has it.
    std::error_code lock_error() const;

  private:
    class OpenFile;
    void check(int error) const;
    /// False if another process had that name, or took the file away at once.
    bool open_temporary();

    std::string path_, target_;
    std::string temporary_;  ///< empty: written in place, or renamed already
    int lock_error_ = 0;
    std::unique_ptr<OpenFile> file_;
};

/// Writes `bytes` to a temporary file beside `path`, flushes it to the device and renames it to
/// `path`; a symbolic link is followed, and a device or pipe is written in place. Throws
/// std::runtime_error with the path and the system's reason; the temporary file is then gone and an
/// older file at `path` untouched.
void write_file_atomically(const std::string& path, std::span<const std::byte> bytes);

/// Throws as write_file_atomically() would before the first byte, found out by making the very
/// temporary file and removing it. What it returns: see AtomicFile::lock_error().
std::error_code probe_atomic_file(const std::string& path);

/// Removes temporary files beside `path` whose writer was killed: those that no process has open.
void remove_abandoned_temporaries(const std::string& path);

}  // namespace lxs
