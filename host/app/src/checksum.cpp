// Checksums of files and of settings.
#include "lxs/host/checksum.h"

#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

namespace lxs {

void Checksum::add_file(const std::string& path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::vector<char> block(std::size_t{1} << 16);
    std::uint64_t size = 0;
    while (file) {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto read = static_cast<std::size_t>(file.gcount());
        add(std::as_bytes(std::span(block).first(read)));
        size += read;
    }
    if (!file.eof()) {
        throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(),
                                "can't read '" + path + "'");
    }
    add(std::as_bytes(std::span(&size, 1)));
}

}  // namespace lxs
