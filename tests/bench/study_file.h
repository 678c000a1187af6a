// Files of a study: read and written whole, with errors that name them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace bench {

using Json = nlohmann::ordered_json;

/// What the user gave can't be used: an unknown name, or a file that is damaged or doesn't fit.
class StudyError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws StudyError with the path and the system's reason.
std::string read_file(const std::filesystem::path& file);

/// Throws StudyError if the file can't be read or is no JSON.
Json read_json(const std::filesystem::path& file);

/// Like read_json; throws StudyError also if "schema" isn't `schema`.
Json read_json(const std::filesystem::path& file, const std::string& schema);

/// Written beside and renamed; makes the folder. Throws lxs::OutputFailure.
void write_json(const std::filesystem::path& file, const Json& json);

/// Makes the folder with all above it. Throws lxs::OutputFailure.
void make_folder(const std::filesystem::path& folder);

}  // namespace bench
