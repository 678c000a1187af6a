// Cryptomattes of several renders, joined.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lxs/imaging/exr_image.h"

namespace lxs {

/// Ids of a pixel and which share of it each covers. They are sorted by that share, so that the
/// channel of a rank means another id in another render: means go by id.
class MatteSums {
  public:
    /// Names of the cryptomattes that an image's header tells ("cryptomatte/.../name").
    static std::vector<std::string> names_in(const ImageMetadata& metadata);
    /// Whether a channel is of a cryptomatte `name`: the name, two digits, a point and a letter.
    static bool has_channel(const std::string& name, const std::string& channel);

    void add(const ExrImage& image, const std::string& name, double weight);
    /// Fills the channels, which are there already, of `image`: as many ids as they hold.
    void write(ExrImage& image, const std::string& name, double all_weight) const;

  private:
    using Share = std::pair<std::uint32_t, double>;  // id, coverage times weight
    std::vector<std::vector<Share>> pixels_;
};

}  // namespace lxs
