// Renders of one scene by several seeds: a sample for the comparisons of block_test.h.
#pragma once

#include "block_test.h"
#include "rendered_image.h"

namespace render {

/// `count` seeds, from `first` on.
struct Seeds {
    unsigned first = 1, count = 1;
};

/// Mean luminances of block x block pixels: [seed][block]. `arguments` as for render(), which
/// throws what this does.
statistics::BlockMeans seeded_block_means(const std::filesystem::path& scene,
                                          const std::string& arguments, const Folder& folder,
                                          const Seeds& seeds, std::size_t block);

}  // namespace render
