// Checksums of files and of settings.
#pragma once

#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lxs {

/// Guards against accidents, not against forgers.
class Checksum {
  public:
    /// By CRC-64 (ECMA-182, as in xz), which finds every flipped byte and every burst of up to
    /// eight.
    void add(std::span<const std::byte> bytes) { crc_.process_bytes(bytes.data(), bytes.size()); }
    /// With its length: "ab", "c" differs from "a", "bc".
    void add_text(std::string_view text) {
        const std::uint64_t size = text.size();
        add(std::as_bytes(std::span(&size, 1)));
        add(std::as_bytes(std::span(text)));
    }
    /// The content of a file, read on all threads; throws std::system_error if it can't be read. It
    /// is hashed by XXH3: what differs goes unnoticed once in 2^64.
    void add_file(const std::string& path);
    /// Likewise of several, whose order matters; of those that can't be read the first is named.
    void add_files(std::span<const std::string> paths);

    std::uint64_t value() const { return crc_.checksum(); }

  private:
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true>
        crc_;
};

}  // namespace lxs
