// Protects: a size that input announces (10^9 of something) takes no memory before what it counts
// is known to be there, and no time. Each is refused at its place, or cut with a warning.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>

#include "bounded_run.h"
#include "stress_case.h"

namespace announced_sizes_test {
namespace {

using stress::BoundedRun;
using stress::small_scene;

constexpr stress::Bounds kBounds{.cpu_seconds = 5, .megabytes = 250};

class StressSizes : public testing::Test {
  protected:
    BoundedRun render(const std::string& scene, const std::vector<std::string>& more = {}) {
        folder_.write("scene.lxs", scene);
        std::vector<std::string> arguments{"scene.lxs", "--passes", "1", "--strict"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return stress::run_lxsrender(folder_, arguments, {.bounds = kBounds});
    }
    void expect_error(const std::string& what, const BoundedRun& run, const std::string& message) {
        SCOPED_TRACE(what);
        stress::expect_refused(run, message);
        worst_megabytes_ = std::max(worst_megabytes_, run.peak_megabytes);
        worst_seconds_ = std::max(worst_seconds_, run.cpu_seconds);
    }
    void TearDown() override {
        if (figure_.empty()) {
            figure_ = "refused, each within " +
                      std::to_string(static_cast<int>(worst_megabytes_ + 1)) + " MB of 250 and " +
                      std::to_string(worst_seconds_) + " CPU s of 5";
        }
        stress::record(tried_, figure_);
    }

    files::TemporaryFolder folder_;
    std::string tried_, figure_;
    double worst_megabytes_ = 0, worst_seconds_ = 0;
};

std::string film(const std::string& size) {
    return "LookAt 0 -5 0 0 0 0 0 0 1\nFilm \"fleximage\" " + size +
           "\nWorldBegin\nLightSource \"point\"\nShape \"sphere\"\nWorldEnd\n";
}

TEST_F(StressSizes, Films) {
    tried_ = "films of 10^9 x 10^9, 10^9 x 1 and 65536 x 65536 pixels, and of 100,000 light groups";
    expect_error("both",
                 render(film("\"integer xresolution\" [1000000000] "
                             "\"integer yresolution\" [1000000000]")),
                 "scene.lxs:2:18: error: xresolution is 1000000000");
    expect_error("one",
                 render(film("\"integer xresolution\" [1000000000] "
                             "\"integer yresolution\" [1]")),
                 "must be from 1 to 134217728");
    expect_error("options", render(film(""), {"--width", "65536", "--height", "65536"}),
                 "65536 x 65536 pixels are 4294967296, more than the limit of 134217728");
    std::string groups;
    for (int i = 0; i < 100'000; ++i)
        groups += "LightGroup \"" + std::to_string(i) + "\" LightSource \"point\"\n";
    expect_error("groups", render("Film \"fleximage\"\nWorldBegin\n" + groups + "WorldEnd\n"),
                 "scene.lxs:1:6: error: not enough memory for a film of 800 x 600 pixels and ");
}

std::string shape(const std::string& statement) {
    return small_scene("", "Shape " + statement);
}

TEST_F(StressSizes, Shapes) {
    tried_ = "height fields of 10^9 x 10^9 and 2^53 x 2^53 of two heights";
    const std::string heights = "\"float Pz\" [0 1]";
    expect_error("10^9",
                 render(shape("\"heightfield\" \"integer nu\" [1000000000] \"integer nv\" "
                              "[1000000000] " +
                              heights)),
                 "\"Pz\" has 2 values: expected nu * nv");
    expect_error("2^53",
                 render(shape("\"heightfield\" \"integer nu\" [9007199254740992] \"integer nv\" "
                              "[9007199254740992] " +
                              heights)),
                 "\"Pz\" has 2 values: expected nu * nv");
}

std::string ply(const std::string& format, const std::string& vertices, const std::string& faces,
                const std::string& corner_count) {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list " + corner_count + " int vertex_indices\nend_header\n";
}

TEST_F(StressSizes, MeshFiles) {
    tried_ = "PLY and STL files that announce 10^9 and 2^64 - 1 vertices, faces, corners, facets";
    const std::string scene = shape("\"plymesh\" \"string filename\" [\"mesh\"]");
    for (const std::string count : {"1000000000", "18446744073709551615"}) {
        for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
            folder_.write("mesh", ply(format, count, "1", "uchar") + "0 0 0\n1 0 0\n");
            expect_error("vertices " + format, render(scene), "it ends before its last element");
            folder_.write("mesh",
                          ply("ascii", "3", count, "uchar") + "0 0 0 1 0 0 0 1 0 3 0 1 2\n");
            expect_error("faces " + format, render(scene), "it ends before its last element");
        }
    }
    folder_.write("mesh", ply("ascii", "3", "1", "double") + "0 0 0 1 0 0 0 1 0 1e300 0 1 2\n");
    expect_error("corners", render(scene), "it ends before its last element");
    folder_.write("mesh", ply("ascii", "3", "99999999999999999999", "uchar"));
    expect_error("beyond 64 bits", render(scene), "a \"element\" line of its header is damaged");
    std::string stl(84, '\0');
    const std::uint32_t facets = 1'000'000'000;
    std::memcpy(stl.data() + 80, &facets, sizeof facets);
    folder_.write("mesh", stl + std::string(100, '\0'));
    expect_error("facets", render(shape("\"stlmesh\" \"string filename\" [\"mesh\"]")),
                 "it holds no STL mesh");
}

TEST_F(StressSizes, Lamps) {
    tried_ = "IES files of 10,000 x 10,000 and of 10^9 angles";
    const std::string scene =
        small_scene("", "LightSource \"goniometric\" \"string iesname\" [\"lamp.ies\"]");
    const auto lamp = [](const std::string& angles) {
        return "TILT=NONE\n1 1000 1 " + angles + " 1 2 0 0 0 1 1 50\n0 90\n";
    };
    folder_.write("lamp.ies", lamp("10000 10000"));
    expect_error("10^8", render(scene), "a vertical angle is missing");
    folder_.write("lamp.ies", lamp("1000000000 1"));
    expect_error("10^9", render(scene), "the number of vertical angles is 1000000000");
}

TEST_F(StressSizes, FilesThatAreNone) {
    tried_ = "a folder, a device without end and a sparse file of 1 TB as scene, include and mesh";
    std::filesystem::create_directory(folder_ / "folder");
    folder_.write("sparse", "");
    std::filesystem::resize_file(folder_ / "sparse", std::uintmax_t{1} << 40);
    const auto mesh = [](const std::string& name) {
        return shape("\"plymesh\" \"string filename\" [\"" + name + "\"]");
    };
    expect_error("folder", render(mesh("folder")), "no file \"folder\"");
    expect_error("device", render(mesh("/dev/zero")), "\"/dev/zero\" is no regular file");
    expect_error("include", render(small_scene("", "Include \"/dev/zero\"")),
                 "scene.lxs:7:9: error: \"/dev/zero\" is no regular file");
    if (AIPS_SANITIZED) return;  // a terabyte asked for is an error there
    expect_error("mesh", render(mesh("sparse")), "not enough memory for the mesh in \"sparse\"");
    expect_error("include", render(small_scene("", "Include \"sparse\"")),
                 "scene.lxs:7:9: error: can't read ");
}

TEST_F(StressSizes, Settings) {
    tried_ = "integrators' counts of 10^9 and 4294967295";
    const std::string scene = small_scene("SurfaceIntegrator \"aips\"", "Shape \"disk\"");
    for (const std::string setting :
         {"aips.hitpointperpass=1000000000", "aips.hitpointperpass=4294967295"}) {
        expect_error(setting, render(scene, {"--set", setting}), "lessen hitpointperpass");
    }
    for (const std::string setting :
         {"aips.maxnodes=1000000000", "aips.cdfresolution=1000000000", "aips.treedepth=1000000000",
          "aips.maxeyedepth=1000000000", "aips.photonperpass=10000000000", "aips.seed=1e300",
          "aips.startradius=inf", "aips.alpha=nan", "aips.erroralpha=1e39"}) {
        expect_error(setting, render(scene, {"--set", setting}),
                     "command line: --set " + setting + ": error: ");
    }
    expect_error("path",
                 render(small_scene("SurfaceIntegrator \"path\" \"integer maxdepth\" "
                                    "[1000000000]")),
                 "scene.lxs:3:46: error: path: \"maxdepth\" is out of range");
}

/// A fan of triangles around one vertex: what is done around a vertex is not done for each pair.
TEST_F(StressSizes, FanOfAMillion) {
    const int spokes = stress::sized(100'000, 1'000'000);
    std::string file = ply("ascii", std::to_string(spokes + 1), std::to_string(spokes), "uchar");
    file += "0 0 0\n";
    for (int i = 0; i < spokes; ++i)
        file += std::to_string(i) + " 1 " + std::to_string(i % 7) + "\n";
    for (int i = 0; i < spokes; ++i)
        file += "3 0 " + std::to_string(i + 1) + " " + std::to_string((i + 1) % spokes + 1) + "\n";
    folder_.write("mesh", file);
    folder_.write(
        "scene.lxs",
        shape("\"plymesh\" \"string filename\" [\"mesh\"] \"integer nsubdivlevels\" [1]"));
    const BoundedRun run = stress::run_lxsrender(
        folder_, {"scene.lxs", "--passes", "1"},
        {.bounds = {.cpu_seconds = 5 + spokes / 3e4, .megabytes = 250 + spokes * 2e-3}});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_FALSE(run.beyond_bounds);
    tried_ = std::to_string(spokes) + " triangles around one vertex, subdivided once";
    figure_ = stress::figure_of(run);
}

TEST_F(StressSizes, LevelsOfSubdivision) {
    if (!stress::long_form()) GTEST_SKIP() << "ten million triangles: in the long form";
    folder_.write(
        "scene.lxs",
        shape("\"loopsubdiv\" \"integer nlevels\" [1000000000] \"integer indices\" [0 1 2] "
              "\"point P\" [0 0 0 1 0 0 0 1 0]"));
    const BoundedRun run =
        stress::run_lxsrender(folder_, {"scene.lxs", "--passes", "1"},
                              {.bounds = {.cpu_seconds = 60, .megabytes = 3000}});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.err.find("levels of subdivision would make more than"), std::string::npos);
    tried_ = "10^9 levels of subdivision: 11 are used";
    figure_ = stress::figure_of(run);
}

}  // namespace
}  // namespace announced_sizes_test
