// Protects: the same EXR, bit for bit, for any number of threads.
#include <gtest/gtest.h>

#include "rendered_image.h"

namespace thread_bits_test {
namespace {

TEST(ThreadBits, Ppm) {
    const render::Folder folder;
    const auto file = render::small_scene("glass-ball", folder, 120, 80);
    const std::string arguments =
        "--integrator ppm --passes 3 --seed 5 --set ppm.photonperpass=40000 --threads ";
    EXPECT_EQ(render::render(file, arguments + "1", folder).rgb,
              render::render(file, arguments + "7", folder).rgb);
}

TEST(ThreadBits, SameExrWithOneTwoAndSevenThreads) {
    const render::Folder folder;
    for (const std::string scene : {"glass-ball", "cornell-box"}) {
        const auto file = render::small_scene(scene, folder, 120, 80);
        for (const std::string guide : {"none", "paper", "adaptive --set aips.guidescout=false",
                                        "adaptive --set aips.guidebounces=false"}) {
            const std::string arguments =
                "--passes 3 --seed 5 --set aips.photonperpass=40000 --set aips.guide=" + guide;
            const auto one = render::render(file, arguments + " --threads 1", folder);
            const auto two = render::render(file, arguments + " --threads 2", folder);
            const auto seven = render::render(file, arguments + " --threads 7", folder);
            EXPECT_EQ(one.rgb, two.rgb) << scene << " " << guide;
            EXPECT_EQ(one.rgb, seven.rgb) << scene << " " << guide;
        }
    }
}

}  // namespace
}  // namespace thread_bits_test
