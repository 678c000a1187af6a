// Protects what is said of an image that shows nothing: that it is, and the likely reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lxsrender_process.h"

namespace lxs::test::image_verdict_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A sphere at the origin and a lamp, seen from (0, -5, 0).
struct Scene {
    std::string target = "0 0 0";
    std::string film;  ///< more parameters
    std::string light = "LightSource \"point\" \"point from\" [0 -5 3] \"color L\" [40 40 40]";
    std::string world = "Shape \"sphere\" \"float radius\" [1]";

    std::string text() const {
        return "LookAt 0 -5 0  " + target + "  0 0 1\nCamera \"perspective\" \"float fov\" [40]\n" +
               "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [6] "
               "\"string filename\" [\"out\"] " +
               film + "\nPixelFilter \"box\"\nWorldBegin\n" + light + "\n" + world + "\nWorldEnd\n";
    }
};

class ImageVerdictTest : public testing::Test {
  protected:
    /// Renders, and expects that the log and the statistics tell of one thing.
    void expect_verdict(const Scene& scene, const std::string& appearance,
                        const std::string& reason) {
        folder_.write("scene.lxs", scene.text());
        const RunResult result = run_lxsrender(
            folder_, {"scene.lxs", "--passes", "2", "--integrator", "path", "--stats", "s.json"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const auto json = nlohmann::json::parse(folder_.read("s.json"))["image"];
        EXPECT_EQ(json["appearance"], appearance);
        if (reason.empty()) {
            EXPECT_FALSE(json.contains("likely reason"));
            EXPECT_THAT(result.err, Not(HasSubstr("the image is all")));
            return;
        }
        EXPECT_THAT(json["likely reason"].get<std::string>(), HasSubstr(reason));
        EXPECT_THAT(result.err,
                    HasSubstr("warning: the image is all " + appearance + "; the likely reason: "));
        EXPECT_THAT(result.err, HasSubstr(reason));
    }

    TemporaryFolder folder_;
};

TEST_F(ImageVerdictTest, OfAnImageThatShowsSomethingNothingIsSaid) {
    expect_verdict({}, "varied", "");
}

TEST_F(ImageVerdictTest, TheCameraLooksAway) {
    Scene scene;
    scene.target = "0 -10 0";
    expect_verdict(scene, "black",
                   "the camera sees no surface: it looks 180 degrees past the middle of the scene");
}

TEST_F(ImageVerdictTest, TheLightsGiveNoLight) {
    Scene scene;
    scene.light = "LightSource \"point\" \"color L\" [0 0 0]";
    expect_verdict(scene, "black", "no light of the scene gives any light");
}

TEST_F(ImageVerdictTest, TheCameraStandsInAClosedObject) {
    Scene scene;
    scene.world = "Translate 0 -5 0 Shape \"sphere\" \"float radius\" [0.5]";
    expect_verdict(scene, "black", "the camera stands inside a closed object");
}

TEST_F(ImageVerdictTest, SomethingStandsBeforeTheLight) {
    Scene scene;
    scene.world += " Translate 0 -5 3 Shape \"sphere\" \"float radius\" [0.5]";
    expect_verdict(scene, "black", "no light reaches what the camera sees: of ");
}

TEST_F(ImageVerdictTest, TheSurfacesAreBlack) {
    Scene scene;
    scene.world = "Material \"matte\" \"color Kd\" [0 0 0] " + scene.world;
    expect_verdict(scene, "black", "light reaches what the camera sees, but none came from there");
}

TEST_F(ImageVerdictTest, TheExposureIsTooShort) {
    Scene scene;
    scene.film = "\"string tonemapkernel\" [\"linear\"] \"float linear_exposure\" [1e-9]";
    expect_verdict(scene, "black", "the exposure: luminances from 0 to ");
}

TEST_F(ImageVerdictTest, TheExposureIsTooLong) {
    Scene scene;
    scene.film = "\"string tonemapkernel\" [\"linear\"] \"float linear_exposure\" [1e9]";
    scene.world = "Shape \"sphere\" \"float radius\" [4]";
    expect_verdict(scene, "white", "under tonemapkernel \"linear\"");
}

}  // namespace
}  // namespace lxs::test::image_verdict_test
