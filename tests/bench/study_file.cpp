// Files of a study: read and written whole, with errors that name them.
#include "study_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>

#include "lxs/host/failure.h"
#include "lxs/imaging/atomic_file.h"

namespace bench {
namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
        throw StudyError(fmt::format("cannot read '{}': {}", file.string(),
                                     std::generic_category().message(errno)));
    }
    return bytes;
}

Json read_json(const fs::path& file) {
    try {
        return Json::parse(read_file(file));
    } catch (const Json::parse_error& error) {
        throw StudyError(fmt::format("'{}' is damaged: {}", file.string(), error.what()));
    }
}

Json read_json(const fs::path& file, const std::string& schema) {
    Json json = read_json(file);
    if (!json.is_object() || json.value("schema", "") != schema) {
        throw StudyError(fmt::format("'{}' is no file of schema \"{}\"", file.string(), schema));
    }
    return json;
}

void write_json(const fs::path& file, const Json& json) {
    make_folder(file.parent_path());
    const std::string text = json.dump(1) + '\n';
    try {
        lxs::write_file_atomically(file.string(), std::as_bytes(std::span(text)));
    } catch (const std::runtime_error& error) {
        throw lxs::OutputFailure(error.what());
    }
}

void make_folder(const fs::path& folder) {
    if (folder.empty()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw lxs::OutputFailure(
            fmt::format("cannot make folder '{}': {}", folder.string(), error.message()));
    }
}

}  // namespace bench
