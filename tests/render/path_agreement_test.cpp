// Protects: `path` and `aips` converge to the same image, and what is left between them is the bias
// of the radius, falling with it.
#include <gtest/gtest.h>

#include <iostream>

#include "block_test.h"
#include "rendered_image.h"
#include "test_form.h"

namespace path_agreement_test {
namespace {

constexpr int kSize = 96;
constexpr std::size_t kBlock = 16;

TEST(PathAgreement, CornellBoxAndTheBiasOfTheRadius) {
    const render::Folder folder;
    const auto scene = render::small_scene("cornell-box", folder, kSize, kSize);
    const auto reference = render::render(scene,
                                          "--integrator path --set path.maxdepth=12 --passes " +
                                              std::to_string(statistics::sized(120, 250)),
                                          folder);
    const auto blocks = reference.block_means(kBlock);
    std::vector<double> sequence;
    for (const std::string radius : {"16", "4", "1"}) {
        const auto image = render::render(
            scene,
            "--passes 6 --set aips.guide=none --set aips.alpha=1 --set aips.photonperpass=200000 "
            "--set aips.startradius=" +
                radius,
            folder);
        sequence.push_back(statistics::median_difference(image.block_means(kBlock), blocks));
        std::cout << "radius " << radius << " footprints: median block difference "
                  << 100 * sequence.back() << " %\n";
    }
    EXPECT_LT(sequence[2], 0.01);
    EXPECT_LT(sequence[1], sequence[0]);
}

}  // namespace
}  // namespace path_agreement_test
