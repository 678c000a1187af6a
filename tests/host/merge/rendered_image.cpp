// An image as lxsrender writes it, for tests.
#include "rendered_image.h"

#include <fmt/format.h>

#include "lxs/imaging/image_header.h"

namespace lxs::test {

ExrImage rendered(std::uint64_t seed, int samples, float value, float error) {
    namespace header = image_header;
    ExrImage image;
    image.frame = {5, 4, 1, 1, 3, 2};
    for (const char* channel : {"R", "G", "B"}) {
        image.channels[channel].assign(6, value);
        image.channels[fmt::format("error.{}", channel)].assign(6, error);
    }
    image.metadata = {{header::kIntegrator, "aips"},
                      {header::kPasses, fmt::to_string(samples)},
                      {header::kSamples, fmt::to_string(samples)},
                      {header::kScene, "room.lxs"},
                      {header::kSeed, fmt::to_string(seed)},
                      {header::kErrorFreedom, "5"},
                      {header::kSceneText, "0123456789abcdef"},
                      {header::kSceneFiles, "fedcba9876543210"},
                      {header::kSettings, "0011223344556677"}};
    return image;
}

}  // namespace lxs::test
