// A folder for the files of one test.
#include "temporary_folder.h"

#include <stdlib.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace files {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "aips-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make folder " + name);
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::operator/(const std::string& name) const {
    return (path_ / name).string();
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
    const fs::path file = path_ / name;
    fs::create_directories(file.parent_path());
    if (!(std::ofstream(file, std::ios::binary) << text << std::flush)) {
        throw std::runtime_error("cannot write " + file.string());
    }
    return file.string();
}

std::string TemporaryFolder::read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    if (!file) throw std::runtime_error("no file " + (path_ / name).string());
    return {std::istreambuf_iterator<char>(file), {}};
}

bool TemporaryFolder::has(const std::string& name) const {
    return fs::exists(path_ / name);
}

std::size_t TemporaryFolder::entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

}  // namespace files
