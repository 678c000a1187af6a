// Protects: images with the same `maxdepth` are the same image, by `path`, `aips` and `sppm`; and
// light goes through a dozen panes where no depth was asked for.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>

#include "seeded_renders.h"
#include "test_form.h"

namespace whole_depth_agreement_test {
namespace {

constexpr std::size_t kBlock = 16;

/// A white room with a coloured wall and a half mirror of a floor; with a pane of glass below its
/// lamp, if asked for, which no shadow ray passes.
std::filesystem::path room(const render::Folder& folder, const std::string& name, bool pane) {
    std::string text = R"(PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
LookAt 0 -0.9 0  0 0.4 0  0 0 1
Camera "perspective" "float fov" [60]
Film "fleximage" "integer xresolution" [16] "integer yresolution" [16]
WorldBegin
AttributeBegin
AreaLightSource "area" "float power" [0] "color L" [3 3 3]
Material "matte" "color Kd" [0 0 0]
Shape "trianglemesh" "integer triindices" [0 2 1 0 3 2] "point P" [-0.8 -0.8 0.99  0.8 -0.8 0.99  0.8 0.8 0.99  -0.8 0.8 0.99]
AttributeEnd
Material "matte" "color Kd" [0.8 0.8 0.8]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 1  -1 1 1  1 1 1  1 -1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 1 -1  1 1 -1  1 1 1  -1 1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  -1 -1 1  1 -1 1  1 -1 -1]
Material "matte" "color Kd" [0.9 0.4 0.2]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  -1 1 -1  -1 1 1  -1 -1 1]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [1 -1 -1  1 -1 1  1 1 1  1 1 -1]
MakeNamedMaterial "white" "string type" ["matte"] "color Kd" [0.8 0.8 0.8]
MakeNamedMaterial "mirror" "string type" ["mirror"] "color Kr" [0.9 0.9 0.9]
Material "mix" "string namedmaterial1" ["white"] "string namedmaterial2" ["mirror"] "float amount" [0.5]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1]
)";
    if (pane) {
        text += R"(Material "glass"
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-1 -1 0.8  1 -1 0.8  1 1 0.8  -1 1 0.8]
Shape "trianglemesh" "integer triindices" [0 2 1 0 3 2] "point P" [-1 -1 0.7  1 -1 0.7  1 1 0.7  -1 1 0.7]
)";
    }
    return folder.write(name, text + "WorldEnd\n");
}

statistics::BlockMeans renders(const std::filesystem::path& scene, const std::string& integrator,
                               const std::string& options, const render::Folder& folder) {
    return render::seeded_block_means(scene, "--integrator " + integrator + " " + options, folder,
                                      {.first = 1, .count = 5}, kBlock);
}

/// The radius is narrow, as sppm does not correct edges.
void expect_same_images(const std::filesystem::path& scene, const render::Folder& folder) {
    statistics::BlockMeans fewer;
    for (const unsigned bounces : {1u, 2u, 3u, 6u}) {
        SCOPED_TRACE(bounces);
        const auto by_path = renders(
            scene, "path", fmt::format("--passes 400 --set path.maxdepth={}", bounces), folder);
        for (const std::string name : {"aips", "sppm"}) {
            const auto photons = renders(
                scene, name,
                fmt::format("--passes 20 --set {0}.maxdepth={1} --set {0}.photonperpass=20000 "
                            "--set {0}.startradius=0.2",
                            name, bounces),
                folder);
            const auto same = statistics::compare(by_path, photons, 0.01, 0.02);
            std::cout << name << ", maxdepth " << bounces << ": " << same.describe() << "\n";
            EXPECT_FALSE(same.differs()) << name << ": " << same.describe();
            if (fewer.empty()) continue;
            // Fewer bounces are another image.
            const auto other = statistics::compare(fewer, photons, 0.01, 0.02);
            EXPECT_TRUE(other.differs()) << name << ": " << other.describe();
        }
        fewer = by_path;
    }
}

TEST(WholeDepthAgreement, ARoomWithAHalfMirror) {
    const render::Folder folder;
    expect_same_images(room(folder, "room.lxs", false), folder);
}

TEST(WholeDepthAgreement, ARoomWithAPane) {
    const render::Folder folder;
    expect_same_images(room(folder, "pane.lxs", true), folder);
}

/// Twelve panes over a floor, of so small an index that they hardly reflect.
TEST(DefaultDepthAgreement, TwelvePanes) {
    const render::Folder folder;
    const auto mean = [&](unsigned panes, const std::string& integrator) {
        std::string text = R"(PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
LookAt 0 -0.01 1.5  0 0 0  0 1 0
Camera "perspective" "float fov" [40]
Film "fleximage" "integer xresolution" [16] "integer yresolution" [16]
WorldBegin
AttributeBegin
AreaLightSource "area" "color L" [5 5 5] "float power" [0]
Material "matte" "color Kd" [0 0 0]
Shape "trianglemesh" "integer triindices" [0 2 1 0 3 2] "point P" [-1 -1 3  1 -1 3  1 1 3  -1 1 3]
AttributeEnd
Material "matte" "color Kd" [0.5 0.5 0.5]
Shape "trianglemesh" "integer triindices" [0 1 2 0 2 3] "point P" [-5 -5 -0.2  5 -5 -0.2  5 5 -0.2  -5 5 -0.2]
Material "glass" "float index" [1.01]
)";
        for (unsigned i = 0; i < panes; ++i) {
            const double z = 1.6 + 0.1 * i;
            text += fmt::format(
                "Shape \"trianglemesh\" \"integer triindices\" [0 2 1 0 3 2 4 5 6 4 6 7] \"point "
                "P\" [-4 -4 {0} 4 -4 {0} 4 4 {0} -4 4 {0} -4 -4 {1} 4 -4 {1} 4 4 {1} -4 4 {1}]\n",
                z, z + 0.05);
        }
        const auto scene = folder.write(fmt::format("panes-{}.lxs", panes), text + "WorldEnd\n");
        const auto image = render::render(scene, "--integrator " + integrator, folder);
        return image.block_means(16).at(0);
    };
    for (const std::string way : {"path --passes 400", "aips --passes 6",
                                  "sppm --passes 5 --set sppm.photonperpass=100000"}) {
        const double bare = mean(0, way);
        const double ratio = mean(12, way) / bare;
        std::cout << way << ": " << ratio << "\n";
        EXPECT_NEAR(ratio, 1, 0.02) << way;
    }
    EXPECT_LT(mean(12, "path --passes 10 --set path.maxdepth=16"), 1e-3);
}

}  // namespace
}  // namespace whole_depth_agreement_test
