// The files that a program writes: each is a file of its own, and none of them is read.
#include "lxs/host/written_files.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <locale>

#include "lxs/host/failure.h"
#include "lxs/imaging/file_name.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const NamedFile& written, const NamedFile& other) {
    throw OutputFailure(fmt::format("cannot write {} to '{}': it is the same file as {} '{}'",
                                    written.role, written.path, other.role, other.path));
}

/// Whether a file of `folder` is found by its name in other letter case: asked of one that is made.
bool ignores_case(const fs::path& folder) {
    std::string probe = (folder / ".lxsrender-XXXXXX").string();
    const int file = ::mkstemp(probe.data());
    if (file < 0) return false;
    ::close(file);
    const fs::path made(probe);
    const std::string other =
        boost::to_upper_copy(made.filename().string(), std::locale::classic());
    std::error_code ignored;
    const bool found = fs::exists(made.parent_path() / other, ignored);
    ::unlink(probe.c_str());
    return found;
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace

WrittenFiles::WrittenFiles(const std::vector<NamedFile>& files) {
    for (const NamedFile& file : files) {
        const auto place = file.path.empty() ? std::nullopt : place_of(file.path);
        if (!place) continue;
        const Written written{file, *place};
        for (const Written& other : written_) {
            if (are_one(written, other)) fail(file, other.file);
        }
        written_.push_back(written);
    }
}

void WrittenFiles::check_read(const NamedFile& file, std::string_view unless) const {
    const auto place = place_of(file.path);
    for (const Written& written : written_) {
        if (place == written.place && written.file.role != unless) fail(written.file, file);
    }
}

/// None, for what is no file; and where nothing can be, as whoever opens it finds out.
std::optional<WrittenFiles::Place> WrittenFiles::place_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) {
        if (!S_ISREG(status.st_mode)) return std::nullopt;
        return Place{status.st_dev, status.st_ino};
    }
    std::error_code error;
    const fs::path target = follow_links(path, error);
    if (error || ::stat(folder_of(target).c_str(), &status) != 0) return std::nullopt;
    return Place{status.st_dev, status.st_ino, target.filename().string()};
}

bool WrittenFiles::are_one(const Written& a, const Written& b) {
    if (a.place == b.place) return true;
    const bool in_one_folder = a.place.device == b.place.device && a.place.number == b.place.number;
    if (!in_one_folder || !boost::iequals(a.place.name, b.place.name, std::locale::classic()))
        return false;
    std::error_code ignored;
    return ignores_case(folder_of(follow_links(a.file.path, ignored)));
}

}  // namespace lxs
