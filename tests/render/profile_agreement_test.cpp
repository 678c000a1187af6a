// Protects: lamps that follow a photometric file or an image look the same by `path`, whose shadow
// rays and chance hits are weighed against each other, and by photons under the adaptive guide,
// whose eye seeding aims at them.
#include <gtest/gtest.h>

#include <string>

#include "room.h"
#include "seeded_renders.h"
#include "test_form.h"

namespace profile_agreement_test {
namespace {

constexpr std::size_t kBlock = 8;
unsigned seeds() {
    return statistics::sized(4u, 6u);
}

/// A room lit by a panel under its ceiling, an instance, with a file without symmetry, and by a
/// ball with coloured light. Both are out of view, where few samples would show their rims.
std::filesystem::path room(const render::Folder& folder) {
    folder.write("washer.ies",
                 "TILT=NONE\n1 -1 1 4 5 1 2 0 0 0 1 1 60\n0 30 60 90\n0 90 180 270 360\n"
                 "60 100 80 10 60 40 20 5 60 10 5 4 60 70 30 8 60 100 80 10\n");
    folder.write("glow.ppm",
                 "P3 4 2 255\n255 40 0 0 0 255 200 200 200 9 9 9\n"
                 "0 255 0 255 255 255 0 0 0 90 90 90\n");
    return folder.write("room.lxs", R"(PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
LookAt 0 -0.2 0.7  0.1 0.4 -0.8  0 0 1
Camera "perspective" "float fov" [60]
Film "fleximage" "integer xresolution" [16] "integer yresolution" [16]
WorldBegin
ObjectBegin "lamp"
AreaLightSource "area" "string iesname" ["washer.ies"] "float power" [0] "color L" [20 20 20]
Material "matte" "color Kd" [0 0 0]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-0.2 -0.2 0  0.2 -0.2 0  0.2 0.2 0  -0.2 0.2 0]
ObjectEnd
AttributeBegin
Translate 0.2 -0.3 0.9
Rotate 170 1 0.3 0
ObjectInstance "lamp"
AttributeEnd
AttributeBegin
AreaLightSource "area" "string mapname" ["glow.ppm"] "float power" [0] "color L" [4 4 4]
Material "matte" "color Kd" [0 0 0]
Translate -0.6 -0.5 -0.2
Shape "sphere" "float radius" [0.2]
AttributeEnd
)" + std::string(render::kRoomWalls) + "WorldEnd\n");
}

// In the corners the radius costs up to 2.4 % of a block, half of that at half the radius.
TEST(ProfileAgreement, PanelAndBallInARoom) {
    const render::Folder folder;
    const auto scene = room(folder);
    const auto path =
        render::seeded_block_means(scene, "--integrator path --set path.maxdepth=17 --passes 150",
                                   folder, {.first = 1, .count = seeds()}, kBlock);
    const auto photons = render::seeded_block_means(
        scene,
        "--integrator aips --passes 6 --set aips.photonperpass=40000 "
        "--set aips.directlightsampling=false --set aips.startradius=0.5",
        folder, {.first = 100, .count = seeds()}, kBlock);
    const auto same = statistics::compare(path, photons, 0.01, 0.03);
    EXPECT_FALSE(same.differs()) << same.describe();
    EXPECT_LT(same.detectable, statistics::sized(0.07, 0.05)) << same.describe();
}

}  // namespace
}  // namespace profile_agreement_test
