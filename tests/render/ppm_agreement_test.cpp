// Protects `ppm` in the host: it converges to the image of `sppm`, and its bias falls with passes.
#include <gtest/gtest.h>

#include <iostream>

#include "block_test.h"
#include "rendered_image.h"
#include "test_form.h"

namespace ppm_agreement_test {
namespace {

constexpr std::size_t kBlock = 16;

/// All light comes from photons: shadow rays from fixed hit points keep their first pass's noise.
TEST(PpmAgreement, CornellBoxAndTheBiasThatPassesTakeAway) {
    const render::Folder folder;
    const int size = statistics::sized(64, 96);
    const auto scene = render::small_scene("cornell-box", folder, size, size);
    const auto reference = render::render(scene,
                                          "--integrator sppm --passes 15 --seed 1 --set "
                                          "sppm.directlightsampling=false --set "
                                          "sppm.photonperpass=200000 --set sppm.startradius=1",
                                          folder);
    const auto blocks = reference.block_means(kBlock);
    std::vector<double> sequence;
    for (const std::string passes : {"2", "16", "128"}) {
        const auto image = render::render(
            scene,
            "--integrator ppm --seed 2 --set ppm.directlightsampling=false --set "
            "ppm.photonperpass=20000 --set ppm.startradius=4 --set ppm.alpha=0.5 --passes " +
                passes,
            folder);
        sequence.push_back(statistics::median_difference(image.block_means(kBlock), blocks));
        std::cout << passes << " passes: median block difference " << 100 * sequence.back()
                  << " %\n";
    }
    EXPECT_LT(sequence[1], sequence[0]);
    EXPECT_LT(sequence[2], sequence[1]);
    EXPECT_LT(sequence[2], 0.01);
}

}  // namespace
}  // namespace ppm_agreement_test
