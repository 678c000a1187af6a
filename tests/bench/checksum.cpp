// SHA-1 of files, as sha1sum prints it.
#include "checksum.h"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>

#include "study_file.h"

namespace bench {

std::string sha1(std::string_view bytes) {
    boost::uuids::detail::sha1 hash;
    hash.process_bytes(bytes.data(), bytes.size());
    boost::uuids::detail::sha1::digest_type digest;
    hash.get_digest(digest);
    std::string text;
    for (const unsigned word : digest)
        text += fmt::format("{:08x}", word);
    return text;
}

std::string sha1_of_file(const std::filesystem::path& file) {
    return sha1(read_file(file));
}

std::string sha1_of_files(const std::vector<std::filesystem::path>& files) {
    std::string sums;
    for (const auto& file : files)
        sums += sha1_of_file(file);
    return sha1(sums);
}

}  // namespace bench
