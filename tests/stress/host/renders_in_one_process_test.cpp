// Protects programs that render more than once: 200 renders one after the other leave nothing
// behind (LeakSanitizer says so in the asan build, resident memory in any), and renders at the same
// time give the bits that each gives alone.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <thread>

#include "lxs/host/process_usage.h"
#include "lxs/host/render_command.h"
#include "lxsrender_process.h"
#include "stress_case.h"

namespace lxs::test::renders_in_one_process_test {
namespace {

/// Everything that holds resources: an image texture, a mesh, an area light, glass, two modules.
std::string rich_scene(const std::string& integrator) {
    return small_scene(
        "SurfaceIntegrator \"" + integrator + "\"\n" +
            "Film \"fleximage\" \"integer xresolution\" [24] \"integer yresolution\" [16]\n",
        "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"t.png\"]\n"
        "Material \"matte\" \"texture Kd\" [\"t\"]\n"
        "Shape \"disk\" \"float radius\" [3] \"float height\" [-1]\n"
        "AttributeBegin\nAreaLightSource \"area\" \"color L\" [3 3 3]\n"
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2]\n"
        "  \"point P\" [0 0 3  1 0 3  0 1 3]\nAttributeEnd\n"
        "ObjectBegin \"o\"\nMaterial \"glass\"\nShape \"sphere\" \"float radius\" [0.3]\n"
        "ObjectEnd\nTranslate 1 -2 0\nObjectInstance \"o\"");
}

class StressRenders : public testing::Test {
  protected:
    StressRenders() {
        const std::string texture = folder_ / "t.png";
        const auto out = OIIO::ImageOutput::create(texture);
        std::vector<unsigned char> pixels(std::size_t{3} * 128 * 128);
        for (std::size_t i = 0; i < pixels.size(); ++i)
            pixels[i] = static_cast<unsigned char>(i * i % 251);
        if (!out->open(texture, OIIO::ImageSpec(128, 128, 3, OIIO::TypeDesc::UINT8)) ||
            !out->write_image(OIIO::TypeDesc::UINT8, pixels.data()) || !out->close()) {
            throw std::runtime_error("no texture");
        }
        for (const char* integrator : {"aips", "path"})
            folder_.write(std::string(integrator) + ".lxs", rich_scene(integrator));
    }
    /// Renders with this integrator; the file's bytes.
    std::string render(const std::string& integrator, const std::string& output,
                       unsigned passes = 2) const {
        CommandLine command;
        command.scene = folder_ / (integrator + ".lxs");
        command.output = folder_ / output;
        command.passes = passes;
        command.plugin_paths = {PLUGINS};
        command.verbosity = Verbosity::Quiet;
        if (integrator == "aips") command.overrides = {"aips.photonperpass=2000"};
        ConsoleLog log(command.verbosity);
        EXPECT_EQ(carry_out(command, log), ExitCode::Success);
        return folder_.read(output);
    }
    TemporaryFolder folder_;
};

TEST_F(StressRenders, TwoHundredLeaveNothingBehind) {
    const int warm_up = 20, renders = stress::sized(200, 2000);
    std::string first;
    std::uint64_t before = 0;
    for (int i = 0; i < renders; ++i) {
        const std::string image = render(i % 2 == 0 ? "aips" : "path", "a.exr", 1);
        if (i == 0) first = image;
        ASSERT_TRUE(i % 2 == 1 || image == first) << i;
        if (i == warm_up) {
            ::malloc_trim(0);
            before = resident_bytes();
        }
    }
    ::malloc_trim(0);
    const auto growth = static_cast<double>(resident_bytes()) - static_cast<double>(before);
    constexpr double kBoundPerRender = 16384;  // bytes
    const double per_render = growth / (renders - warm_up);
#if !defined(__SANITIZE_ADDRESS__)  // which keeps what is freed for a while
    EXPECT_LT(per_render, kBoundPerRender);
#endif
    stress::record(std::to_string(renders) + " renders in one process",
                   std::to_string(per_render) +
                       " bytes of resident memory more per render, of at "
                       "most " +
                       std::to_string(kBoundPerRender));
}

TEST_F(StressRenders, AtTheSameTimeGiveTheBitsOfEachAlone) {
    const std::string aips = render("aips", "alone-aips.exr"), path = render("path", "alone.exr");
    const int rounds = stress::sized(5, 50);
    for (int round = 0; round < rounds; ++round) {
        std::string images[4];
        std::vector<std::thread> threads;
        threads.reserve(4);
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back([&, i] {
                images[i] =
                    render(i % 2 == 0 ? "aips" : "path", "at-once-" + std::to_string(i) + ".exr");
            });
        }
        for (std::thread& thread : threads)
            thread.join();
        EXPECT_EQ(images[0], aips);
        EXPECT_EQ(images[1], path);
        EXPECT_EQ(images[2], aips);
        EXPECT_EQ(images[3], path);
    }
    stress::record(std::to_string(rounds) + " times four renders at once, two scenes, one texture",
                   "all files the same, byte for byte, as alone");
}

}  // namespace
}  // namespace lxs::test::renders_in_one_process_test
