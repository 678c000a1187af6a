// Names of files, made to fit the bounds of a file system.
#include "lxs/imaging/file_name.h"

#include <unistd.h>

#include <algorithm>

namespace lxs {

namespace fs = std::filesystem;

std::size_t longest_name(const fs::path& folder) {
    constexpr long kUsual = 255;
    const long told = ::pathconf(folder.empty() ? "." : folder.c_str(), _PC_NAME_MAX);
    // FAT tells its bound as if each character took all the bytes that one may.
    return static_cast<std::size_t>(told > 0 ? std::min(told, kUsual) : kUsual);
}

std::string cut_name(std::string name, std::size_t bytes) {
    if (name.size() <= bytes) return name;
    const auto continues = [&](std::size_t i) {
        return (static_cast<unsigned char>(name[i]) & 0xC0) == 0x80;
    };
    while (bytes > 0 && continues(bytes))
        --bytes;
    name.resize(bytes);
    return name;
}

fs::path follow_links(const fs::path& path, std::error_code& error) {
    constexpr int kMostLinks = 40;  // as many as the system follows
    fs::path place = path;
    for (int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
        if (links == kMostLinks) {
            error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
            return path;
        }
        const fs::path next = fs::read_symlink(place, error);
        if (error) return path;
        place = place.parent_path() / next;
    }
    error.clear();  // what is wrong with a place where no link is, its writer finds out
    return place;
}

}  // namespace lxs
