// The files that a program writes: each is a file of its own, and none of them is read.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lxs {

/// A file by any of its names.
struct NamedFile {
    std::string role;  ///< "the statistics", as messages tell it
    std::string path;
};

/// Files are compared by what they are, not by their names: "a", "./a", links to it and "A", where
/// the file system takes that for the same, are one. Devices and pipes take whatever comes.
class WrittenFiles {
  public:
    /// Files without a path are left out. Throws OutputFailure if two are one.
    explicit WrittenFiles(const std::vector<NamedFile>& files);

    /// Throws OutputFailure if `file`, which is read, is one of them; but for that of the role
    /// `unless`, which may be.
    void check_read(const NamedFile& file, std::string_view unless = {}) const;

  private:
    /// Of what is there: device and number. Of what is not: those of its folder, and its name.
    struct Place {
        dev_t device;
        ino_t number;
        std::string name = {};
        bool operator==(const Place&) const = default;
    };
    struct Written {
        NamedFile file;
        Place place;
    };
    static std::optional<Place> place_of(const std::string& path);
    static bool are_one(const Written& a, const Written& b);

    std::vector<Written> written_;
};

}  // namespace lxs
