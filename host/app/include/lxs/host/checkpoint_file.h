// The file format of checkpoints and of what was learned: what makes a file one, and that it is
// whole.
//
//     mark ("LXSCHECK"), version (4 bytes), byte order (4 bytes), content,
//     checksum of all before (8 bytes), "LXSWHOLE"
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/host/checksum.h"
#include "lxs/imaging/atomic_file.h"
#include "lxs/sdk/state_archive.h"

namespace lxs {

/// Raised with every change of what a checkpoint holds.
inline constexpr std::uint32_t kCheckpointVersion = 8;

/// A kind of file.
struct SealedFormat {
    std::array<char, 8> mark;
    std::uint32_t version;
    std::string_view name;  ///< as in "it is no checkpoint"
};
inline constexpr SealedFormat kCheckpointFormat{
    {'L', 'X', 'S', 'C', 'H', 'E', 'C', 'K'}, kCheckpointVersion, "checkpoint"};
/// Its version is raised when the frame around what an integrator learned changes.
inline constexpr SealedFormat kLearnedFormat{
    {'L', 'X', 'S', 'L', 'E', 'A', 'R', 'N'}, 1, "file of --learned-out"};

/// Writes the content of a checkpoint as it comes, in memory of a fixed size, beside the file that
/// commit() puts it in place of. Throws std::runtime_error with the path and the system's reason.
class CheckpointWriter final : public StateArchive {
  public:
    explicit CheckpointWriter(const std::string& path,
                              const SealedFormat& format = kCheckpointFormat);

    bool restoring() const override { return false; }
    void bytes(std::span<std::byte> data) override;
    std::size_t remaining() const override { return 0; }
    void commit();

  private:
    void append(std::span<const std::byte> bytes);
    void flush();

    AtomicFile file_;
    Checksum checksum_;
    std::vector<std::byte> buffer_;
};

/// Restores from the content of a checkpoint, which must outlive it.
class CheckpointReader final : public StateArchive {
  public:
    explicit CheckpointReader(std::span<const std::byte> content) : left_(content) {}

    bool restoring() const override { return true; }
    void bytes(std::span<std::byte> data) override;
    std::size_t remaining() const override { return left_.size(); }

  private:
    std::span<const std::byte> left_;
};

/// The part of a file that holds a checkpoint's content. Throws StateError if the file is not a
/// whole one of this kind and version.
std::span<const std::byte> checkpoint_content(std::span<const std::byte> file,
                                              const SealedFormat& format = kCheckpointFormat);

/// All bytes of a file that begins as one of this kind and version does, its memory being what the
/// file is long. Throws StateError if it doesn't or can't be read.
std::vector<std::byte> read_checkpoint_file(const std::string& path,
                                            const SealedFormat& format = kCheckpointFormat);

}  // namespace lxs
