// SHA-1 of files, as sha1sum prints it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

std::string sha1(std::string_view bytes);

/// Throws StudyError if the file can't be read.
std::string sha1_of_file(const std::filesystem::path& file);

/// Of the checksums of all files, in the order given.
std::string sha1_of_files(const std::vector<std::filesystem::path>& files);

}  // namespace bench
