// Protects advice at the end of a render: each rule speaks up in a scene with its fault, in words
// of this page of tests, and in the log as in the statistics file; a sound scene gets none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lxsrender_process.h"

namespace lxs::test::advice_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A white floor and a lamp above it, seen from (0, -5, 2).
struct Scene {
    std::string camera = "LookAt 0 -5 2  0 0 0.5  0 0 1\nCamera \"perspective\" \"float fov\" [40]";
    std::string integrator =
        "SurfaceIntegrator \"aips\" \"string guide\" [\"none\"] "
        "\"integer photonperpass\" [20000]";
    std::string film;  ///< more parameters
    std::string light =
        "AttributeBegin AreaLightSource \"area\" \"color L\" [20 20 20] Translate 0 0 3 "
        "Rotate 180 1 0 0 Shape \"disk\" \"float radius\" [0.3] AttributeEnd";
    std::string floor = "Material \"matte\" \"color Kd\" [0.7 0.7 0.7]";
    std::string world;

    std::string text() const {
        return camera + "\n" + integrator +
               "\nFilm \"fleximage\" \"integer xresolution\" [32] \"integer yresolution\" [24] "
               "\"string filename\" [\"out\"] \"string tonemapkernel\" [\"linear\"] " +
               film + "\nPixelFilter \"box\"\nWorldBegin\n" + light + "\nAttributeBegin " + floor +
               " Shape \"trianglemesh\" \"point P\" [-4 -4 0  4 -4 0  4 4 0  -4 4 0] "
               "\"integer indices\" [0 1 2  0 2 3] AttributeEnd\n" +
               world + "\nWorldEnd\n";
    }
};

const std::string kPoint = "LightSource \"point\" \"point from\" [0 0 3] \"color L\" [10 10 10]";
const std::string kGlassBall =
    "AttributeBegin Material \"glass2\" Translate 0 0 0.7 Interior \"glass\" "
    "Shape \"sphere\" \"float radius\" [0.6] AttributeEnd";
const std::string kGlass = "MakeNamedVolume \"glass\" \"clear\" \"float fresnel\" [1.5]\n";

class AdviceTest : public testing::Test {
  protected:
    /// What the statistics file says after 4 passes.
    nlohmann::json render(const Scene& scene, std::vector<std::string> more = {}) {
        folder_.write("scene.lxs", scene.text());
        std::vector<std::string> arguments{"scene.lxs", "--passes", "4", "--stats", "s.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        result_ = run_lxsrender(folder_, arguments);
        EXPECT_EQ(result_.exit_code, 0) << result_.err;
        return nlohmann::json::parse(folder_.read("s.json"));
    }
    void expect_advice(const Scene& scene, const std::string& rule, const std::string& text,
                       std::vector<std::string> more = {}) {
        const auto json = render(scene, std::move(more));
        bool found = false;
        for (const auto& advice : json["advice"]) {
            if (advice["rule"] != rule) continue;
            found = true;
            EXPECT_THAT(advice["text"].get<std::string>(), HasSubstr(text));
        }
        EXPECT_TRUE(found) << rule << ": " << result_.err;
        EXPECT_THAT(result_.err, HasSubstr("advice: "));
        EXPECT_THAT(result_.err, HasSubstr(text));
    }
    void expect_none(const Scene& scene, std::vector<std::string> more = {}) {
        const auto json = render(scene, std::move(more));
        EXPECT_TRUE(json["advice"].empty()) << json["advice"].dump(1);
        EXPECT_THAT(result_.err, Not(HasSubstr("advice: ")));
    }

    TemporaryFolder folder_;
    RunResult result_;
};

TEST_F(AdviceTest, ASoundSceneGetsNone) {
    Scene scene;
    scene.world = kGlass + kGlassBall;
    expect_none(scene);
}

TEST_F(AdviceTest, IsNeitherSoughtNorCountedWhenOff) {
    const auto json = render({}, {"--no-advice"});
    EXPECT_FALSE(json.contains("advice"));
    EXPECT_FALSE(json.contains("account"));
    EXPECT_THAT(result_.err, Not(HasSubstr("photons brought")));
}

TEST_F(AdviceTest, TheImageIsTheSameWithAndWithout) {
    Scene scene;
    scene.world = kGlass + kGlassBall;
    render(scene, {"--explain", "-o", "with.exr"});
    render(scene, {"--no-advice", "-o", "without.exr"});
    EXPECT_EQ(folder_.read("with.exr"), folder_.read("without.exr"));
}

TEST_F(AdviceTest, ExplainTellsOfLightsAndMaterials) {
    Scene scene;
    scene.world = kGlass +
                  "MakeNamedMaterial \"ball\" \"string type\" [\"glass2\"]\n"
                  "AttributeBegin NamedMaterial \"ball\" Translate 0 0 0.7 "
                  "Interior \"glass\" Shape \"sphere\" \"float radius\" [0.6] AttributeEnd";
    const auto json = render(scene, {"--explain"});
    EXPECT_THAT(result_.err, HasSubstr("lights:\n  light 0 (area, scene.lxs:"));
    EXPECT_THAT(result_.err, HasSubstr("materials:\n"));
    EXPECT_THAT(result_.err, HasSubstr("\"ball\": met by "));
    EXPECT_THAT(result_.err, HasSubstr("left out media: none in the scene"));
    EXPECT_THAT(result_.err, HasSubstr("seconds: "));
    EXPECT_EQ(json["account"]["lights"][0]["photon paths"], 80000);
    EXPECT_GT(json["account"]["materials"]["ball"]["only pass"], 1000);
    EXPECT_GT(json["account"]["lights"][0]["luminance by photons"], 0);
}

TEST_F(AdviceTest, ExplainSaysThatPathShootsNoPhotons) {
    render({}, {"--explain", "--integrator", "path"});
    EXPECT_THAT(result_.err, HasSubstr("photons: \"path\" shot none"));
}

TEST_F(AdviceTest, ExplainSpeaksUpWhenQuiet) {
    render({}, {"--explain", "--quiet"});
    EXPECT_THAT(result_.err, HasSubstr("lights:\n"));
}

TEST_F(AdviceTest, ThePhotonDepthCutsCaustics) {
    Scene scene;
    scene.world = kGlass + kGlassBall;
    expect_advice(scene, "photon depth", "Raise maxphotondepth",
                  {"--set", "aips.maxphotondepth=2"});
}

TEST_F(AdviceTest, TheEyeDepthCutsGlass) {
    Scene scene;
    scene.world = kGlass + kGlassBall;
    expect_advice(scene, "eye depth", "Raise maxeyedepth", {"--set", "aips.maxeyedepth=2"});
}

TEST_F(AdviceTest, ALightTakesThePhotons) {
    Scene scene;
    scene.world =
        "LightSource \"point\" \"point from\" [90 0 3] \"color L\" [9000 9000 9000]\n"
        "AttributeBegin Translate 90 0 3 Shape \"sphere\" \"float radius\" [1] "
        "AttributeEnd";
    expect_advice(scene, "light takes the photons", "light 1 (point, scene.lxs:");
}

TEST_F(AdviceTest, EverythingIsOutOfView) {
    Scene scene;
    scene.camera = "LookAt 0 -5 2  0 -9 3  0 0 1\nCamera \"perspective\" \"float fov\" [40]";
    scene.light = "LightSource \"infinite\" \"color L\" [0.5 0.5 0.5]";
    expect_advice(scene, "everything out of view", "the camera sees no surface");
}

TEST_F(AdviceTest, TheImageIsBurntOut) {
    Scene scene;
    scene.film = "\"float linear_exposure\" [1e4]";
    expect_advice(scene, "image burnt out", "plain white");
}

TEST_F(AdviceTest, TheImageIsNearlyBlack) {
    Scene scene;
    scene.film = "\"float linear_exposure\" [0.000005]";
    scene.world =
        "AttributeBegin AreaLightSource \"area\" \"color L\" [20 20 20] "
        "Translate 0 0 1 Shape \"sphere\" \"float radius\" [0.15] AttributeEnd";
    expect_advice(scene, "image nearly black", "black to the eye");
}

TEST_F(AdviceTest, TheCameraStandsInsideGlass) {
    Scene scene;
    scene.world = kGlass +
                  "MakeNamedMaterial \"block\" \"string type\" [\"glass2\"]\n"
                  "AttributeBegin NamedMaterial \"block\" Translate 0 -5 2 "
                  "Interior \"glass\" Shape \"sphere\" \"float radius\" [0.4] AttributeEnd";
    expect_advice(scene, "camera in a solid", "the camera stands inside a solid of \"block\"");
}

TEST_F(AdviceTest, ALampStandsInsideASolid) {
    Scene scene;
    scene.world = kPoint +
                  "\nMakeNamedMaterial \"shade\" \"string type\" [\"matte\"]\n"
                  "AttributeBegin NamedMaterial \"shade\" Translate 0 0 3 "
                  "Shape \"sphere\" \"float radius\" [0.2] AttributeEnd";
    scene.light = "LightSource \"point\" \"point from\" [1 -2 3] \"color L\" [10 10 10]";
    expect_advice(scene, "lamp in a solid",
                  "stands inside a closed solid of \"shade\": none of its light gets out");
}

TEST_F(AdviceTest, ALampIsInsideOut) {
    Scene scene;
    scene.world =
        "AttributeBegin AreaLightSource \"area\" \"color L\" [20 20 20] "
        "Translate 0 0 2 ReverseOrientation Shape \"sphere\" \"float radius\" [0.2] "
        "AttributeEnd";
    expect_advice(scene, "lamp in a solid", "the shape is inside out");
}

TEST_F(AdviceTest, GlassIsInsideOut) {
    Scene scene;
    scene.world = kGlass +
                  "MakeNamedMaterial \"ball\" \"string type\" [\"glass2\"]\n"
                  "AttributeBegin NamedMaterial \"ball\" Translate 0 0 0.7 "
                  "ReverseOrientation Interior \"glass\" Shape \"sphere\" "
                  "\"float radius\" [0.6] AttributeEnd";
    expect_advice(scene, "glass inside out", "what is made of \"ball\" is inside out");
}

const std::string kTetrahedron =
    "Material \"glass\" \"float index\" [1.5] \"bool architectural\" [\"false\"] "
    "Shape \"trianglemesh\" \"point P\" [-1 -1 0.2  1 -1 0.2  0 1 0.2  0 0 1.6] ";

TEST_F(AdviceTest, AMeshIsInsideOut) {
    Scene scene;
    scene.world = kTetrahedron + "\"integer indices\" [0 1 2  0 3 1  1 3 2  2 3 0]";
    expect_advice(scene, "glass inside out", "is inside out");
}

TEST_F(AdviceTest, AMeshIsTheRightWay) {
    Scene scene;
    scene.world = kTetrahedron + "\"integer indices\" [0 2 1  0 1 3  1 2 3  2 0 3]";
    expect_none(scene);
}

std::string ball_of_glass(const std::string& architectural) {
    return "Material \"glass\" \"float index\" [1.5] \"bool architectural\" [\"" + architectural +
           "\"] Translate 0 0 0.7 Shape \"sphere\" \"float radius\" [0.6]";
}

TEST_F(AdviceTest, ASolidIsOfArchitecturalGlass) {
    Scene scene;
    scene.world = ball_of_glass("true");
    expect_advice(scene, "architectural glass", "is architectural glass on a solid with a curved");
}

TEST_F(AdviceTest, APaneIsOfArchitecturalGlass) {
    Scene scene;
    scene.world =
        "Material \"glass\" \"bool architectural\" [\"true\"] "
        "Shape \"trianglemesh\" \"point P\" [-1 0 0  1 0 0  1 0 2  -1 0 2] "
        "\"integer indices\" [0 1 2  0 2 3]";
    expect_none(scene);
}

TEST_F(AdviceTest, PathMissesCausticsOfPoints) {
    Scene scene;
    scene.light = kPoint;
    scene.world = kGlass + kGlassBall;
    expect_advice(scene, "path misses caustics", "where \"path\" misses it altogether",
                  {"--integrator", "path"});
}

TEST_F(AdviceTest, PathFindsCausticsOfSmallLampsByChance) {
    Scene scene;
    scene.light =
        "AttributeBegin AreaLightSource \"area\" \"color L\" [200 200 200] "
        "Translate 0 0 0.7 Shape \"sphere\" \"float radius\" [0.05] AttributeEnd";
    scene.world = kGlass + kGlassBall;
    expect_advice(scene, "path misses caustics", "finds it by chance alone",
                  {"--integrator", "path"});
}

const std::string kRoughMetal =
    "Material \"metal\" \"float uroughness\" [0.25] \"float vroughness\" [0.25]";

TEST_F(AdviceTest, PathMissesCausticsOnGloss) {
    Scene scene;
    scene.light = kPoint;
    scene.floor = kRoughMetal;
    scene.world = kGlass + kGlassBall;
    expect_advice(scene, "path misses caustics", "misses it altogether", {"--integrator", "path"});
}

// Light that nobody carries: photons do not land on gloss, and no ray meets a point.
TEST_F(AdviceTest, GlossMissesCausticsOfPoints) {
    Scene scene;
    scene.light = kPoint;
    scene.floor = kRoughMetal;
    scene.world = kGlass + kGlassBall;
    const std::vector<std::string> without = {"--set", "aips.causticsongloss=false"};
    expect_none(scene);
    expect_advice(scene, "gloss misses caustics", "is missing there", without);
    expect_advice(scene, "gloss misses caustics", "is missing there", {"--integrator", "sppm"});
    expect_none(scene, {"--set", "aips.causticsongloss=false", "--set", "aips.storeglossy=true"});
    scene.floor =
        "Material \"glossy\" \"color Kd\" [0.3 0.3 0.3] \"color Ks\" [0.3 0.3 0.3] "
        "\"float uroughness\" [0.25] \"float vroughness\" [0.25]";
    expect_advice(scene, "gloss misses caustics", "is missing there", without);
}

TEST_F(AdviceTest, PathIsRightWhereNothingIsSmooth) {
    expect_none({}, {"--integrator", "path"});
}

TEST_F(AdviceTest, TheRadiusIsWiderThanTheObjects) {
    Scene scene;
    expect_advice(scene, "radius too wide", "Give a smaller startradius",
                  {"--set", "aips.startradius=200", "--set", "aips.radius=schedule"});
}

}  // namespace
}  // namespace lxs::test::advice_test
