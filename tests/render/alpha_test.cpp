// Protects the alpha channel of every integrator: surfaces are covered, what is between them is
// clear and black, what stands before nothing looks as it does before a background, and the bits
// are the same for any number of threads and after a pause.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rendered_image.h"

namespace alpha_test {
namespace {

/// A matte ball in the middle of the image under a sky; `film`: parameters, `more`: statements
/// before WorldBegin.
std::string scene(const std::string& film, const std::string& more) {
    return "Film \"fleximage\" \"integer xresolution\" [32] \"integer yresolution\" [32] " + film +
           "\nLookAt 0 -4 0  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" [40]\n" + more +
           "\nWorldBegin\nLightSource \"infinite\" \"color L\" [1 1 1]\n"
           "Material \"matte\" \"color Kd\" [0.5 0.5 0.5]\nShape \"sphere\" \"float radius\" "
           "[0.8]\nMaterial \"null\"\nAttributeBegin\nTranslate 0 0 1.1\nShape \"sphere\" "
           "\"float radius\" [0.2]\nAttributeEnd\nWorldEnd\n";
}

constexpr const char* kAlpha = "\"bool premultiplyalpha\" [\"true\"]";

using Pixels = std::vector<float>;  // R, A

Pixels render(const std::string& film, const std::string& more, const std::string& options,
              const render::Folder& folder) {
    const auto file = folder.write("scene.lxs", scene(film, more));
    const std::string exr = (folder.path() / "alpha.exr").string();
    render::output_of(std::string(LXSRENDER) + " '" + file + "' --quiet -o '" + exr + "' " +
                      options + " 2>&1");
    return render::read_channels(exr, {"R", "A"}).rgb;
}

float alpha_at(const Pixels& pixels, int x, int y) {
    return pixels.at(2 * (32 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)) + 1);
}
float red_at(const Pixels& pixels, int x, int y) {
    return pixels.at(2 * (32 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)));
}

TEST(Alpha, OfEveryIntegrator) {
    const std::string kAll = " --passes 8";
    struct Way {
        std::string integrator, more;
    };
    const std::vector<Way> ways{{"path", ""}, {"path", "Sampler \"metropolis\""},
                                {"aips", ""}, {"sppm", ""},
                                {"ppm", ""},  {"exphotonmap", ""}};
    for (const Way& way : ways) {
        SCOPED_TRACE(way.integrator + " " + way.more);
        const render::Folder folder;
        std::string options = "--integrator " + way.integrator;
        if (way.integrator != "path") options += " --set " + way.integrator + ".photonperpass=4000";
        const Pixels pixels = render(kAlpha, way.more, options + kAll, folder);
        EXPECT_EQ(alpha_at(pixels, 16, 16), 1);
        EXPECT_EQ(alpha_at(pixels, 1, 1), 0);
        EXPECT_EQ(red_at(pixels, 1, 1), 0) << "the sky is not seen";
        EXPECT_LT(alpha_at(pixels, 16, 4), 0.01f) << "what lets all pass is nothing";
        EXPECT_GT(red_at(pixels, 16, 16), 0.2f) << "but it lights";
        EXPECT_EQ(render(kAlpha, way.more, options + kAll + " --threads 7", folder), pixels);
        if (way.more.empty() && way.integrator != "ppm") {
            const Pixels opaque = render(
                "\"string write_exr_channels\" [\"RGBA\"] "
                "\"bool write_exr_straightcolors\" [\"true\"]",
                way.more, options + kAll, folder);
            EXPECT_EQ(red_at(opaque, 16, 16), red_at(pixels, 16, 16));
            EXPECT_NEAR(red_at(opaque, 1, 1), 1, 0.02f) << "straight colours show the sky";
            EXPECT_EQ(alpha_at(opaque, 1, 1), 0);
        }
        const std::string kept = " --checkpoint " + (folder.path() / "c").string() + " --resume";
        render(kAlpha, way.more, options + kept + " --passes 3", folder);
        EXPECT_EQ(render(kAlpha, way.more, options + kept + kAll, folder), pixels)
            << "after a pause";
    }
}

}  // namespace
}  // namespace alpha_test
