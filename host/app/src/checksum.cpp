// Checksums of files and of settings.
//
// Files of a scene may have gigabytes. They are read in blocks on all threads, with a hash that is
// faster than memory, and the hashes of blocks are summed in order.
#include "lxs/host/checksum.h"

#include <tbb/parallel_for.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

namespace lxs {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 20;

[[noreturn]] void refuse(const std::string& path, int code) {
    throw std::system_error(code != 0 ? code : EIO, std::generic_category(),
                            "can't read '" + path + "'");
}

std::uint64_t hash_of_block(const std::string& path, std::size_t begin, std::size_t size) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const auto block = std::make_unique_for_overwrite<char[]>(size);
    file.seekg(static_cast<std::streamoff>(begin));
    if (!file.read(block.get(), static_cast<std::streamsize>(size))) refuse(path, errno);
    return XXH3_64bits(block.get(), size);
}

}  // namespace

void Checksum::add_file(const std::string& path) {
    std::error_code error;
    const std::size_t size = std::filesystem::file_size(path, error);
    if (error) refuse(path, error.value());
    // An empty file has a block too: whether it can be read is found out by reading it.
    std::vector<std::uint64_t> hashes(
        std::max<std::size_t>(1, (size + kBlockBytes - 1) / kBlockBytes));
    tbb::parallel_for(std::size_t{0}, hashes.size(), [&](std::size_t i) {
        const std::size_t begin = i * kBlockBytes;
        hashes[i] = hash_of_block(path, begin, std::min(kBlockBytes, size - begin));
    });
    hashes.push_back(size);
    add(std::as_bytes(std::span(hashes)));
}

void Checksum::add_files(std::span<const std::string> paths) {
    std::vector<Checksum> sums(paths.size());
    std::vector<std::exception_ptr> failures(paths.size());
    tbb::parallel_for(std::size_t{0}, paths.size(), [&](std::size_t i) {
        try {
            sums[i].add_file(paths[i]);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    });
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (failures[i]) std::rethrow_exception(failures[i]);
        const std::uint64_t sum = sums[i].value();
        add(std::as_bytes(std::span(&sum, 1)));
    }
}

}  // namespace lxs
