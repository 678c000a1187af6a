// What the bits of an image depend on, so that a render goes on only from a checkpoint of its own,
// and only renders of the same are merged.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "lxs/host/command_line.h"
#include "lxs/imaging/exr_image.h"
#include "lxs/language/read_files.h"
#include "lxs/sdk/state_archive.h"

namespace lxs {

/// One checksum a cause. Threads, budgets and the names of outputs have no bearing on the image:
/// they may change.
class Fingerprint {
  public:
    void set_program(const std::filesystem::path& integrator_module);
    void set_sources(const ReadFiles& files);
    void set_assets(const ReadFiles& files);
    /// What the command line changes, and the names of what it does not.
    void set_settings(const CommandLine& command, std::string_view integrator, std::uint32_t width,
                      std::uint32_t height);
    void set_seed(std::uint64_t seed);
    /// What was learned before, if anything was.
    void set_learned(std::span<const std::byte> file);

    /// Adds what images to be merged must have alike.
    void describe(ImageMetadata& metadata) const;
    /// What differs, in words; empty if nothing does.
    std::string difference(const Fingerprint& other) const;
    /// Alike if nothing differs.
    std::span<const std::byte> bytes() const { return std::as_bytes(std::span(checksums_)); }
    void state(StateArchive& archive) { archive.fixed(std::span(checksums_)); }

  private:
    enum Cause : std::uint8_t { Program, Sources, Assets, Settings, Seed, Learned, Causes };

    std::array<std::uint64_t, Causes> checksums_{};
};

}  // namespace lxs
