// Protects: a lamp in a box of fog looks the same by `path`, whose free flights are tested
// against closed forms, and by photons with the beam estimate: on the fog and on the walls. And
// both take rays to be in the same media where statements leave out what is around a body.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "room.h"
#include "seeded_renders.h"
#include "test_form.h"

namespace media_agreement_test {
namespace {

constexpr std::size_t kBlock = 8;
/// Many short renders tell more than few long ones of as many passes.
unsigned seeds() {
    return statistics::sized(8u, 6u);
}

/// A lamp under the ceiling of a box, in coloured fog that scatters forwards. (A point or spot
/// light would leave `path` too noisy to tell.)
std::filesystem::path fog_box(const render::Folder& folder) {
    return folder.write("fog-box.lxs", R"(VolumeIntegrator "multi"
PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
LookAt 0 -0.95 0  0 1 0  0 0 1
Camera "perspective" "float fov" [60]
Film "fleximage" "integer xresolution" [32] "integer yresolution" [32]
WorldBegin
MakeNamedVolume "fog" "homogeneous" "color sigma_a" [0.05 0.1 0.2] "color sigma_s" [0.5 0.4 0.3] "color g" [0.4 0.4 0.4]
Exterior "fog"
)" + std::string(render::kRoomLamp) + render::kRoomWalls +
                                           "WorldEnd\n");
}

TEST(MediaAgreement, LampInABoxOfFog) {
    const render::Folder folder;
    const auto scene = fog_box(folder);
    const auto path =
        render::seeded_block_means(scene,
                                   "--integrator path --set path.maxdepth=16 --passes " +
                                       std::to_string(statistics::sized(40, 100)),
                                   folder, {.first = 1, .count = seeds()}, kBlock);
    std::string photons_options =
        "--integrator aips --set aips.guide=none --set aips.startradius=0.7 "
        "--set aips.photonperpass=";
    photons_options += statistics::sized("50000 --passes 3", "100000 --passes 6");
    photons_options += " --set aips.directlightsampling=";
    for (const std::string strategy : {"true", "false"}) {
        const auto photons = render::seeded_block_means(scene, photons_options + strategy, folder,
                                                        {.first = 100, .count = seeds()}, kBlock);
        const auto same = statistics::compare(path, photons, 0.01, 0.01);
        EXPECT_FALSE(same.differs())
            << "directlightsampling " << strategy << ": " << same.describe();
        EXPECT_LT(same.detectable, statistics::sized(0.06, 0.04)) << same.describe();
    }
}

constexpr const char* kFilm = R"(PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
Film "fleximage" "integer xresolution" [16] "integer yresolution" [16]
)";

/// Open water over a ground that names no medium, with a ball half in it, under a wide lamp.
std::string open_pool() {
    return std::string(kFilm) + R"(LookAt 0 -4 3  0 0 -0.5  0 0 1
Camera "perspective" "float fov" [40]
WorldBegin
MakeNamedVolume "water" "clear" "float fresnel" [1.33] "color absorption" [0.5 0.15 0.08]
AttributeBegin
Material "glass2"
Interior "water"
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-2 -2 0  2 -2 0  2 2 0  -2 2 0]
AttributeEnd
Material "matte" "color Kd" [0.6 0.6 0.6]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-2 -2 -1  2 -2 -1  2 2 -1  -2 2 -1]
AttributeBegin
Translate 0.5 0.2 0
Shape "sphere" "float radius" [0.5]
AttributeEnd
AreaLightSource "area" "color L" [3 3 3]
Shape "trianglemesh" "integer indices" [0 2 1 0 3 2] "point P" [-4 -4 5  4 -4 5  4 4 5  -4 4 5]
WorldEnd
)";
}

/// A lamp in water in glass, none of which names what is around it.
std::string lamp_in_a_vessel() {
    return std::string(kFilm) + R"(LookAt 0 -4 0.6  0 0 -0.2  0 0 1
Camera "perspective" "float fov" [45]
WorldBegin
MakeNamedVolume "glass" "clear" "float fresnel" [1.5] "color absorption" [0.2 0.5 0.3]
MakeNamedVolume "water" "clear" "float fresnel" [1.33] "color absorption" [0.6 0.2 0.1]
AttributeBegin
Material "glass2"
Interior "glass"
Shape "sphere" "float radius" [1]
Interior "water"
Shape "sphere" "float radius" [0.85]
AttributeEnd
AttributeBegin
AreaLightSource "area" "color L" [3 3 3]
Material "matte" "color Kd" [0.5 0.5 0.5]
Shape "sphere" "float radius" [0.35]
AttributeEnd
Material "matte" "color Kd" [0.6 0.6 0.6]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-3 -5 -1.2  3 -5 -1.2  3 3 -1.2  -3 3 -1.2]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-3 3 -1.2  3 3 -1.2  3 3 3  -3 3 3]
WorldEnd
)";
}

/// The fog of LampInABoxOfFog as the inside of a ball around everything, the camera too.
std::string ball_of_fog(const render::Folder& folder) {
    std::string text = folder.read(fog_box(folder).filename());
    const std::string statement = "Exterior \"fog\"\n";
    return text.replace(text.find(statement), statement.size(),
                        "AttributeBegin\nInterior \"fog\"\nMaterial \"null\"\n"
                        "Shape \"sphere\" \"float radius\" [3]\nAttributeEnd\n");
}

/// `allowed`: a known relative bias of photons; `error`: of both means, relative.
void expect_agreement(const std::string& scene, const std::string& path_options,
                      const std::string& photon_options, double allowed, double error = 0.005) {
    const render::Folder folder;
    const auto file = folder.write("scene.lxs", scene);
    const auto path = render::seeded_block_means(
        file, "--integrator path --set path.maxdepth=32 --passes " + path_options, folder,
        {.first = 1, .count = seeds()}, kBlock);
    const auto photons = render::seeded_block_means(
        file,
        "--integrator aips --set aips.maxphotondepth=32 --set aips.maxeyedepth=32 --passes " +
            photon_options,
        folder, {.first = 100, .count = seeds()}, kBlock);
    const auto same = statistics::compare(path, photons, 0.01, allowed);
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_NEAR(same.mean_ratio, 1, allowed + 2 * same.standard_error) << same.describe();
    EXPECT_LT(same.standard_error, error) << same.describe();
}

TEST(MediaAgreement, OpenWaterOverAGroundWithoutExterior) {
    expect_agreement(open_pool(), "1500", "24", 0.005);
}

TEST(MediaAgreement, LampInAVesselWithoutExterior) {
    expect_agreement(lamp_in_a_vessel(), "800", "24", 0.005);
}

TEST(MediaAgreement, CameraAndLampInFogWithoutExterior) {
    const render::Folder folder;
    expect_agreement(ball_of_fog(folder), "60",
                     "6 --set aips.guide=none --set aips.startradius=0.7 "
                     "--set aips.photonperpass=100000",
                     0.01);
}

/// Fog that thins out upwards, beside a grid of puffs, in a room with a lamp.
std::string varying_fog() {
    return std::string(kFilm) + R"(VolumeIntegrator "multi"
LookAt 0 -0.95 0  0 1 0  0 0 1
Camera "perspective" "float fov" [70]
WorldBegin
Texture "haze" "float" "exponential" "vector updir" [0 0 1] "point origin" [0 0 -1] "float decay" [1.5]
Texture "scattering" "color" "mix" "texture amount" ["haze"] "color tex1" [0 0 0] "color tex2" [2 1.5 1]
Texture "absorption" "color" "mix" "texture amount" ["haze"] "color tex1" [0 0 0] "color tex2" [0.1 0.2 0.4]
MakeNamedVolume "haze" "heterogeneous" "texture sigma_s" ["scattering"] "texture sigma_a" ["absorption"] "color g" [0.3 0.3 0.3]
TransformBegin
Translate -0.5 -0.2 -0.5
Texture "grid" "float" "densitygrid" "integer nx" [2] "integer ny" [2] "integer nz" [2] "float density" [0 1 0.5 0 0 0.2 1 0] "string wrap" ["clamp"]
TransformEnd
Texture "puffs" "color" "mix" "texture amount" ["grid"] "color tex1" [0 0 0] "color tex2" [6 6 6]
MakeNamedVolume "puffs" "heterogeneous" "texture sigma_s" ["puffs"]
Exterior "haze"
)" + render::kRoomLamp +
           R"(AttributeBegin
Interior "puffs"
Material "null"
Translate 0 0.3 0
Shape "sphere" "float radius" [0.5]
AttributeEnd
)" + render::kRoomWalls +
           "WorldEnd\n";
}

TEST(MediaAgreement, FogThatVaries) {
    expect_agreement(varying_fog(), "100",
                     "8 --set aips.guide=none --set aips.startradius=0.3 "
                     "--set aips.photonperpass=30000",
                     0.01, 0.012);
}

/// A flame in smoke over a floor of rough metal, beside glass; what it encloses is lit within it.
std::string flame() {
    return std::string(kFilm) + R"(VolumeIntegrator "multi"
LookAt 0 -3.5 0.5  0 0 0  0 0 1
Camera "perspective" "float fov" [50]
WorldBegin
Texture "height" "float" "exponential" "vector updir" [0 0 1] "point origin" [0 0 -0.8] "float decay" [1.5]
Texture "smoke" "color" "mix" "texture amount" ["height"] "color tex1" [0.2 0.2 0.2] "color tex2" [1 0.6 0.3]
Texture "fire" "color" "mix" "texture amount" ["height"] "color tex1" [0 0 0] "color tex2" [4 2 0.5]
MakeNamedVolume "flame" "heterogeneous" "texture sigma_s" ["smoke"] "texture sigma_a" ["smoke"] "texture emission" ["fire"]
AttributeBegin
Interior "flame"
Material "null"
Shape "sphere" "float radius" [0.8]
AttributeEnd
AttributeBegin
Material "matte" "color Kd" [0.6 0.6 0.6]
Translate 0.2 -0.3 -0.2
Shape "sphere" "float radius" [0.25]
AttributeEnd
AttributeBegin
Material "glass"
Translate -1.3 -0.4 -0.5
Shape "sphere" "float radius" [0.4]
AttributeEnd
Material "metal2" "float uroughness" [0.3] "float vroughness" [0.3]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-4 -4 -1  4 -4 -1  4 4 -1  -4 4 -1]
Material "matte" "color Kd" [0.6 0.6 0.6]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-4 2 -1  4 2 -1  4 2 3  -4 2 3]
WorldEnd
)";
}

TEST(MediaAgreement, AFlameLightsWhatIsAroundItAndInIt) {
    expect_agreement(flame(), "200",
                     "10 --set aips.guide=none --set aips.startradius=0.15 "
                     "--set aips.photonperpass=30000",
                     0.01, 0.012);
}

/// A ball of fog that absorbs nothing under an even sky is as bright as the sky, to its rim.
TEST(MediaAgreement, FogBallInAFurnaceIsNotSeen) {
    const render::Folder folder;
    const auto file = folder.write("furnace.lxs", std::string(kFilm) + R"(VolumeIntegrator "multi"
LookAt 0 -6 0  0 0 0  0 0 1
Camera "perspective" "float fov" [40]
WorldBegin
MakeNamedVolume "fog" "homogeneous" "color sigma_s" [0.5 0.7 1] "color g" [0.3 0.3 0.3]
LightSource "infinite" "color L" [1 1 1]
Interior "fog"
Material "null"
Shape "sphere" "float radius" [2]
WorldEnd
)");
    const auto light = render::seeded_block_means(
        file,
        "--integrator aips --passes 24 --set aips.photonperpass=20000 --set aips.startradius=0.2",
        folder, {.first = 1, .count = statistics::sized(16u, 64u)}, 2);
    for (std::size_t block = 0; block < light[0].size(); ++block) {
        double sum = 0, squares = 0;
        for (const auto& seed : light) {
            sum += seed[block];
            squares += seed[block] * seed[block];
        }
        const auto n = double(light.size());
        const double mean = sum / n;
        const double error = std::sqrt((squares / n - mean * mean) / (n - 1));
        EXPECT_NEAR(mean, 1, 0.01 + 4 * error) << block;
        EXPECT_LT(error, 0.02) << block;
    }
}

}  // namespace
}  // namespace media_agreement_test
