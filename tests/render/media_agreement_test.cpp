// Protects: a lamp in a box of fog looks the same by `path`, whose free flights are tested
// against closed forms, and by photons with the beam estimate: on the fog and on the walls.
#include <gtest/gtest.h>

#include <string>

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
AttributeBegin
AreaLightSource "area" "color L" [10 10 10]
Material "matte" "color Kd" [0 0 0]
Shape "trianglemesh" "integer triindices" [0 2 1 0 3 2] "point P" [-0.4 -0.4 0.9  0.4 -0.4 0.9  0.4 0.4 0.9  -0.4 0.4 0.9]
AttributeEnd
Material "matte" "color Kd" [0.6 0.5 0.4]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 1  -1 1 1  1 1 1  1 -1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 1 -1  1 1 -1  1 1 1  -1 1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  -1 -1 1  1 -1 1  1 -1 -1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  -1 1 -1  -1 1 1  -1 -1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [1 -1 -1  1 -1 1  1 1 1  1 1 -1]
WorldEnd
)");
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

}  // namespace
}  // namespace media_agreement_test
