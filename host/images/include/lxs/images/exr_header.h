// What the header of an OpenEXR file claims, found out before OpenEXR makes room for it.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstdint>
#include <vector>

namespace lxs {

/// Sizes of one part of a file, as its header has them: any numbers.
struct ExrClaim {
    std::int64_t width = 0, height = 0;  ///< of the data window
    std::int64_t channels = 0;
    std::int64_t tile_width = 0, tile_height = 0;  ///< 0: not tiled
};

/// Walks over the headers in `file`, of `bytes` bytes, from its begin on. Throws
/// std::runtime_error if it is no OpenEXR file, or a value of a header has another size than it
/// says: OpenEXR makes room for what a size claims before it reads, and would go on elsewhere than
/// the walk where a value is longer or shorter than its type.
std::vector<ExrClaim> exr_claims(Imf::IStream& file, std::uint64_t bytes);

}  // namespace lxs
