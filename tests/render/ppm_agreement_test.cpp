// Protects `ppm` in the host: it converges to the image of `sppm`, and its bias falls with passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "block_test.h"
#include "rendered_image.h"

namespace {

constexpr int kSize = 96;

double median_difference(const render::Image& a, const render::Image& b) {
    const auto ma = statistics::block_means(a.luminance(), kSize, kSize, 16);
    const auto mb = statistics::block_means(b.luminance(), kSize, kSize, 16);
    std::vector<double> differences;
    for (std::size_t i = 0; i < ma.size(); ++i)
        differences.push_back(std::abs(ma[i] / mb[i] - 1));
    std::sort(differences.begin(), differences.end());
    return differences[differences.size() / 2];
}

/// All light comes from photons: shadow rays from fixed hit points keep their first pass's noise.
TEST(PpmAgreement, CornellBoxAndTheBiasThatPassesTakeAway) {
    const render::Folder folder;
    const auto scene = render::small_scene("cornell-box", folder, kSize, kSize);
    const auto reference = render::render(scene,
                                          "--integrator sppm --passes 15 --seed 1 --set "
                                          "sppm.directlightsampling=false --set "
                                          "sppm.photonperpass=200000 --set sppm.startradius=1",
                                          folder);
    std::vector<double> sequence;
    for (const std::string passes : {"2", "16", "128"}) {
        const auto image = render::render(
            scene,
            "--integrator ppm --seed 2 --set ppm.directlightsampling=false --set "
            "ppm.photonperpass=20000 --set ppm.startradius=4 --set ppm.alpha=0.5 --passes " +
                passes,
            folder);
        sequence.push_back(median_difference(image, reference));
        std::cout << passes << " passes: median block difference " << 100 * sequence.back()
                  << " %\n";
    }
    EXPECT_LT(sequence[1], sequence[0]);
    EXPECT_LT(sequence[2], sequence[1]);
    EXPECT_LT(sequence[2], 0.01);
}

}  // namespace
