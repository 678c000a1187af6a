// The dynamic loader, and what it does not look at (man 5 elf).
#include "lxs/modules/load_module.h"

#include <dlfcn.h>
#include <link.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace lxs {
namespace {

namespace fs = std::filesystem;

template <class T>
bool read_at(std::ifstream& file, std::uint64_t place, T* values, std::size_t count) {
    file.seekg(static_cast<std::streamoff>(place));
    return static_cast<bool>(file.read(reinterpret_cast<char*>(values),
                                       static_cast<std::streamsize>(count * sizeof(T))));
}

bool holds(std::uint64_t bytes, std::uint64_t begin, std::uint64_t size) {
    return begin <= bytes && size <= bytes - begin;
}

/// Whether all segments that are mapped lie in the file. What is no ELF file of this machine is
/// left to the loader, which says so.
bool is_whole(const fs::path& path, std::uint64_t bytes) {
    std::ifstream file(path, std::ios::binary);
    ElfW(Ehdr) head{};
    if (!read_at(file, 0, &head, 1)) return true;
    const unsigned char of_this_machine = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
    if (std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 ||
        head.e_ident[EI_CLASS] != of_this_machine || head.e_phentsize != sizeof(ElfW(Phdr)))
        return true;
    std::vector<ElfW(Phdr)> segments(head.e_phnum);
    if (!holds(bytes, head.e_phoff, segments.size() * sizeof(ElfW(Phdr))) ||
        !read_at(file, head.e_phoff, segments.data(), segments.size()))
        return false;
    for (const ElfW(Phdr) & segment : segments) {
        if (segment.p_type == PT_LOAD && !holds(bytes, segment.p_offset, segment.p_filesz))
            return false;
    }
    return true;
}

/// What the loader says, without the file's name, which stands in our messages already.
std::string loaders_reason(const fs::path& file) {
    const char* const said = ::dlerror();
    std::string text = said != nullptr ? said : "unknown reason";
    const std::string name = file.string() + ": ";
    if (text.starts_with(name)) text.erase(0, name.size());
    return text;
}

}  // namespace

void load_module(boost::dll::shared_library& library, const fs::path& file,
                 boost::dll::load_mode::type mode) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) throw std::runtime_error(error.message());
    if (!fs::is_regular_file(status)) throw std::runtime_error("it is no regular file");
    const std::uint64_t bytes = fs::file_size(file, error);
    if (error) throw std::runtime_error(error.message());
    if (!is_whole(file, bytes)) throw std::runtime_error("it is cut short");
    std::error_code
        failed;  // of it nothing is said: it is "bad file descriptor" whatever the cause
    library.load(file, failed, mode);
    if (failed) throw std::runtime_error(loaders_reason(file));
}

}  // namespace lxs
