// Protects: one seed for all random numbers of a render, that of --seed before the scene's, 0 too.
#include <gtest/gtest.h>

#include "rendered_image.h"

namespace seed_test {
namespace {

/// A ball of glass under a lamp; `more`: parameters of the integrator.
std::string scene(const std::string& integrator, const std::string& more) {
    return "Film \"fleximage\" \"integer xresolution\" [24] \"integer yresolution\" [16]\n"
           "LookAt 0 -4 1  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" [50]\n"
           "SurfaceIntegrator \"" +
           integrator + "\" \"integer photonperpass\" [5000] " + more +
           "\nWorldBegin\nAttributeBegin\nTranslate 0 0 3\nAreaLightSource \"area\"\n"
           "Shape \"sphere\" \"float radius\" [0.5]\nAttributeEnd\n"
           "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] "
           "\"point P\" [-5 -5 -1  5 -5 -1  5 5 -1  -5 5 -1]\n"
           "Material \"glass\"\nShape \"sphere\" \"float radius\" [0.8]\nWorldEnd\n";
}

TEST(Seed, OfTheCommandLineCountsBeforeTheScenes) {
    for (const std::string integrator : {"aips", "sppm", "exphotonmap"}) {
        const render::Folder folder;
        const auto seeded = folder.write("seeded.lxs", scene(integrator, "\"integer seed\" [5]"));
        const auto unseeded = folder.write("unseeded.lxs", scene(integrator, ""));
        const auto image = [&](const std::string& file, const std::string& options) {
            return render::render(file, "--passes 2 " + options, folder).rgb;
        };
        const auto zero = image(unseeded, ""), five = image(seeded, "");
        EXPECT_NE(zero, five) << integrator;
        EXPECT_EQ(image(seeded, "--seed 0"), zero) << integrator;
        EXPECT_EQ(image(unseeded, "--seed 5"), five) << integrator;
        EXPECT_EQ(image(unseeded, "--set " + integrator + ".seed=5"), five) << integrator;
        EXPECT_EQ(image(seeded, "--set " + integrator + ".seed=0"), zero) << integrator;
        EXPECT_EQ(image(seeded, "--seed 7"), image(unseeded, "--seed 7")) << integrator;
    }
}

}  // namespace
}  // namespace seed_test
