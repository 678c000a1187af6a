// One render for each seed.
#include "seeded_renders.h"

namespace render {

statistics::BlockMeans seeded_block_means(const std::filesystem::path& scene,
                                          const std::string& arguments, const Folder& folder,
                                          const Seeds& seeds, std::size_t block) {
    statistics::BlockMeans means;
    for (unsigned seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
        const Image image = render(scene, arguments + " --seed " + std::to_string(seed), folder);
        means.push_back(image.block_means(block));
    }
    return means;
}

}  // namespace render
