// Protects the layers for compositing of whole renders (docs/reference/layers.md): what
// they show of a scene of known answers, by photons and by path tracing, and that the image stays
// the same.
#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <regex>
#include <set>
#include <stdexcept>

#include "rendered_image.h"

namespace layers_test {
namespace {

/// A camera at the origin looks along z at a square mirror at z = 4 that stands square to it; to
/// the left of it at z = 6 a matte wall, which reaches behind the mirror; a pane of no material
/// before all; and behind the camera, at z = -1, a matte wall that the mirror shows.
constexpr const char* kScene = R"(
LookAt 0 0 0  0 0 1  0 1 0
Camera "perspective" "float fov" [60]
Film "fleximage" "integer xresolution" [40] "integer yresolution" [40]
    "float colorspace_red" [0.64 0.33] "float colorspace_green" [0.3 0.6]
    "float colorspace_blue" [0.15 0.06] "float colorspace_white" [0.313334 0.329235]
PixelFilter "box" "float xwidth" [0.5] "float ywidth" [0.5]
WorldBegin
AttributeBegin
    Texture "none" "color" "constant" "color value" [0 0 0]
    LightSource "point" "point from" [0 3 2] "color L" [30 30 30]
AttributeEnd
AttributeBegin
    Material "null"
    Shape "trianglemesh" "integer indices" [0 1 2 0 2 3]
        "point P" [-9 -9 2  9 -9 2  9 9 2  -9 9 2]
AttributeEnd
MakeNamedMaterial "silver" "string type" ["mirror"] "color Kr" [0.5 0.5 0.5]
ObjectBegin "the mirror"
    NamedMaterial "silver"
    Shape "trianglemesh" "string name" ["not this"] "integer indices" [0 1 2 0 2 3]
        "point P" [0 -9 0  9 -9 0  9 9 0  0 9 0]
ObjectEnd
AttributeBegin
    Translate 0 0 4
    ObjectInstance "the mirror"
AttributeEnd
AttributeBegin
    Material "matte" "color Kd" [0.2 0.4 0.6]
    Shape "trianglemesh" "string name" ["the wall"] "integer indices" [0 1 2 0 2 3]
        "point P" [-9 -9 6  9 -9 6  9 9 6  -9 9 6]
AttributeEnd
AttributeBegin
    Material "matte" "color Kd" [0.8 0.6 0.4]
    Shape "trianglemesh" "integer indices" [0 1 2 0 2 3]
        "point P" [-99 -99 -1  99 -99 -1  99 99 -1  -99 99 -1]
AttributeEnd
WorldEnd
)";

std::filesystem::path scene(const render::Folder& folder) {
    auto path = folder.path() / "scene.lxs";
    std::ofstream(path) << kScene;
    return path;
}

struct Layers {
    std::vector<float> image, albedo, normal, depth;
};

Layers layers_of(const std::string& integrator) {
    const render::Folder folder;
    const std::string common = "--passes 4 --quiet --integrator " + integrator + " ";
    const auto path = scene(folder);
    const auto plain = render::render(path, common, folder);
    Layers layers;
    layers.image = render::render(path, common + "--layers all", folder).rgb;
    EXPECT_EQ(layers.image, plain.rgb) << "layers change the image";
    const auto file = folder.path() / "out.exr";
    layers.albedo = render::read_layer(file, "albedo").rgb;
    layers.normal = render::read_channels(file, {"normal.X", "normal.Y", "normal.Z"}).rgb;
    layers.depth = render::read_channels(file, {"depth.Z"}).rgb;
    return layers;
}

/// In a pixel on the right, of the wall, and in one on the left, of the mirror.
void expect_known(const Layers& layers) {
    for (const std::size_t row : {3u, 20u, 36u}) {
        const std::size_t wall = row * 40 + 33, mirror = row * 40 + 5;
        EXPECT_NEAR(layers.depth[wall], 6, 1e-4);
        EXPECT_NEAR(layers.depth[mirror], 4, 1e-4);
        for (const std::size_t pixel : {wall, mirror}) {
            EXPECT_NEAR(layers.normal[3 * pixel], 0, 1e-6);
            EXPECT_NEAR(layers.normal[3 * pixel + 1], 0, 1e-6);
            EXPECT_NEAR(layers.normal[3 * pixel + 2], -1, 1e-6);
        }
        const float of_wall[] = {0.2f, 0.4f, 0.6f}, of_mirrored[] = {0.4f, 0.3f, 0.2f};
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(layers.albedo[3 * wall + c], of_wall[c], 5e-3);        // by way of spectra
            EXPECT_NEAR(layers.albedo[3 * mirror + c], of_mirrored[c], 5e-3);  // by way of spectra
        }
    }
}

TEST(Layers, ShowSurfacesWithPhotons) {
    // How many photons there are is of no matter.
    expect_known(layers_of("aips --set aips.photonperpass=10000"));
    expect_known(layers_of("exphotonmap --set exphotonmap.photonperpass=10000"));
}

TEST(Layers, ShowSurfacesWithPaths) {
    expect_known(layers_of("path"));
}

TEST(Layers, AreNamedAsDocumented) {
    const render::Folder folder;
    const auto path = scene(folder);
    const auto names = [&](const std::string& layers) {
        render::render(path, "--passes 1 --quiet " + layers, folder);
        return render::channel_names(folder.path() / "out.exr");
    };
    using Names = std::set<std::string>;
    EXPECT_EQ(names(""), (Names{"R", "G", "B"}));
    EXPECT_EQ(names("--layers depth"), (Names{"R", "G", "B", "depth.Z"}));
    Names all = names("--layers all");
    std::erase_if(all, [](const std::string& name) { return name.starts_with("Crypto"); });
    EXPECT_EQ(all, (Names{"R",          "G",          "B",          "direct.R",   "direct.G",
                          "direct.B",   "indirect.R", "indirect.G", "indirect.B", "caustics.R",
                          "caustics.G", "caustics.B", "albedo.R",   "albedo.G",   "albedo.B",
                          "normal.X",   "normal.Y",   "normal.Z",   "depth.Z",    "bias.R",
                          "bias.G",     "bias.B"}));
}

/// The id that the file's own header gives a name, as the float of its bits.
float id_in_header(const std::filesystem::path& file, const std::string& key,
                   const std::string& name) {
    const std::string manifest = render::header_text(file, "cryptomatte/" + key + "/manifest");
    std::smatch found;
    if (!std::regex_search(manifest, found, std::regex("\"" + name + "\":\"([0-9a-f]{8})\"")))
        throw std::runtime_error("no \"" + name + "\" in " + manifest);
    return std::bit_cast<float>(static_cast<std::uint32_t>(std::stoul(found[1], nullptr, 16)));
}

/// Masks read by nothing but the published format: a name's id from the header, where it stands in
/// the layers, and the coverage beside it.
TEST(Layers, MasksAreThoseOfThePublishedFormat) {
    const render::Folder folder;
    for (const std::string integrator : {"aips", "path"}) {
        render::render(scene(folder),
                       "--passes 4 --quiet --layers cryptomatte --integrator " + integrator,
                       folder);
        const auto file = folder.path() / "out.exr";
        const std::size_t wall = 20 * 40 + 33, mirror = 20 * 40 + 5;
        const auto expect = [&](const std::string& layer, const std::string& key, std::size_t pixel,
                                const std::string& name) {
            const auto first = render::read_channels(
                file, {layer + "00.R", layer + "00.G", layer + "00.B", layer + "00.A"});
            EXPECT_EQ(render::header_text(file, "cryptomatte/" + key + "/name"), layer);
            EXPECT_EQ(first.rgb[4 * pixel], id_in_header(file, key, name)) << name;
            EXPECT_EQ(first.rgb[4 * pixel + 1], 1) << name;
            EXPECT_EQ(first.rgb[4 * pixel + 3], 0) << name;
            // On the mirror's edge each has its share.
            const std::size_t edge = 20 * 40 + 19;
            EXPECT_NEAR(first.rgb[4 * edge + 1] + first.rgb[4 * edge + 3], 1, 1e-5) << layer;
        };
        expect("CryptoObject", "3ae39a5", wall, "the wall");
        expect("CryptoObject", "3ae39a5", mirror, "the mirror");
        expect("CryptoMaterial", "be359d6", wall, "matte .scene.lxs:[0-9]+.");
        expect("CryptoMaterial", "be359d6", mirror, "silver");
    }
}

}  // namespace
}  // namespace layers_test
