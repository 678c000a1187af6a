// What a directive of pbrt means, by images: the same bits as the statements of our language that
// mean it by definition, or the closed form of a pixel's radiance.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lxs/pbrt/read_pbrt.h"
#include "lxs/spectrum/reflectance_colour.h"
#include "lxs/spectrum/rgb_spectra.h"
#include "path_render.h"
#include "temporary_folder.h"

namespace lxs::test::pbrt_same_image_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kPasses = 16;

/// Options of a small image in pbrt's words; `more` stands before WorldBegin.
std::string options(const std::string& more = "", int depth = 5) {
    return fmt::format("Integrator \"path\" \"integer maxdepth\" {}\n", depth) +
           "Film \"rgb\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
           "PixelFilter \"box\"\n" +
           (more.empty() ? "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 60\n"
                         : more) +
           "WorldBegin\n";
}

PathSettings settings(std::uint32_t depth = 5) {
    PathSettings settings;
    settings.max_depth = depth;
    settings.specular_bounces = 0;
    return settings;
}

std::vector<Rgb> pbrt_image(const std::string& text, const std::string& folder = ".",
                            int passes = kPasses, std::uint32_t depth = 5) {
    return render_image(
        [&](const Registry& registry, Diagnostics& diagnostics) {
            return read_pbrt_text(text, folder + "/test.pbrt", folder, registry, diagnostics);
        },
        settings(depth), passes, folder);
}

/// The world of a scene of ours, seen by the camera of options().
std::vector<Rgb> our_image(const std::string& world, const std::string& camera = "") {
    // pbrt's LookAt has x on the other side.
    const std::string usual =
        "Scale -1 1 1\nLookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [60]\n";
    return render_image((camera.empty() ? usual : camera) + "WorldBegin\n" + world + "WorldEnd\n",
                        settings(), kPasses);
}

void expect_same(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    ASSERT_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (int c = 0; c < 3; ++c)
            EXPECT_FLOAT_EQ(a[i][c], b[i][c]) << "pixel " << i << " channel " << c;
        sum += double(luminance(b[i]));
    }
    EXPECT_GT(sum, 0) << "a black image compares nothing";
}

std::string colour(const Rgb& c) {
    return fmt::format("[{} {} {}]", c.x, c.y, c.z);
}
std::string reflectance(float r, float g, float b) {
    return colour(reflectance_of_colour(Rgb(r, g, b)));
}

/// Facets as pbrt has them.
const std::string kGgx = "\"string distribution\" [\"ggx\"]\n";

/// A lamp above the camera of white light; and a wall behind z = 0, in both languages.
const std::string kLamp = "LightSource \"point\" \"float scale\" 30 \"point3 from\" [1 2 3]\n";
const std::string kOurLamp =
    "LightSource \"point\" \"color L\" [1 1 1] \"float gain\" [30] \"point from\" [1 2 3]\n";
const std::string kWall =
    "\"integer indices\" [0 1 2 0 2 3] \"point3 P\" [-3 -3 0  3 -3 0  3 3 0  -3 3 0] "
    "\"point2 uv\" [0 0 1 0 1 1 0 1]\n";
const std::string kOurWall =
    "Shape \"trianglemesh\" \"integer triindices\" [0 1 2 0 2 3] "
    "\"point P\" [-3 -3 0  3 -3 0  3 3 0  -3 3 0] \"float uv\" [0 0 1 0 1 1 0 1]\n";

std::string wall_of(const std::string& material) {
    return material + "Shape \"trianglemesh\" " + kWall;
}

TEST(PbrtImage, DiffuseUnderAPoint) {
    expect_same(pbrt_image(options() + kLamp +
                           wall_of("Material \"diffuse\" \"rgb reflectance\" [0.8 0.4 0.1]\n")),
                our_image(kOurLamp + "Material \"matte\" \"color Kd\" " +
                          reflectance(0.8f, 0.4f, 0.1f) + "\n" + kOurWall));
}

TEST(PbrtImage, NoMaterialIsGreyOfAHalf) {
    expect_same(pbrt_image(options() + kLamp + wall_of("")),
                our_image(kOurLamp + "Material \"matte\" \"color Kd\" [0.5 0.5 0.5]\n" + kOurWall));
}

TEST(PbrtImage, IrradianceOfAPointHasTheClosedForm) {
    // One unit above the middle of a white wall: E = I / d^2, L = E / pi.
    const auto image = pbrt_image(
        options("LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n") +
        "LightSource \"point\" \"rgb I\" [2 1 0.5] \"float scale\" 3 \"point3 from\" [0 0 1]\n" +
        wall_of("Material \"diffuse\" \"rgb reflectance\" [1 1 1]\n"));
    for (const Rgb& pixel : image) {
        EXPECT_NEAR(pixel.x, 6 / kPi, 2e-3);
        EXPECT_NEAR(pixel.y, 3 / kPi, 2e-3);
        EXPECT_NEAR(pixel.z, 1.5 / kPi, 2e-3);
    }
}

TEST(PbrtImage, PowerAndIlluminanceHaveTheClosedForm) {
    const std::string camera =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n";
    const std::string wall = wall_of("Material \"diffuse\" \"rgb reflectance\" [1 1 1]\n");
    const auto y = [&](const std::string& light) {
        double sum = 0;
        std::string scene = options(camera);
        scene.append(light).append(wall);
        for (const Rgb& pixel : pbrt_image(scene, ".", 64))
            sum += double(luminance(pixel)) / 64;
        return sum;
    };
    EXPECT_NEAR(y("LightSource \"point\" \"float power\" 100 \"point3 from\" [0 0 2]\n"),
                100 / (4 * kPi) / 4 / kPi, 1e-3);
    EXPECT_NEAR(y("LightSource \"distant\" \"float illuminance\" 5 \"point3 from\" [0 0 1] "
                  "\"point3 to\" [0 0 0]\n"),
                5 / kPi, 1e-3);
    EXPECT_NEAR(y("LightSource \"infinite\" \"float illuminance\" 5\n"), 5 / kPi, 2e-2);
    EXPECT_NEAR(y("LightSource \"infinite\" \"rgb L\" [2 2 2]\n"), 2, 1e-2);
}

TEST(PbrtImage, SpectraOfLightsHaveLuminanceOne) {
    const std::string camera =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n";
    for (const std::string light :
         {"\"blackbody L\" 2700", "\"blackbody L\" 6500",
          "\"spectrum L\" [400 1 500 3 600 2 700 9]", "\"spectrum L\" \"stdillum-A\"",
          "\"spectrum L\" \"stdillum-D65\""}) {
        SCOPED_TRACE(light);
        const auto image = pbrt_image(options(camera) + "LightSource \"infinite\" " + light +
                                      " \"float scale\" 4\n");
        EXPECT_NEAR(luminance(image.at(0)), 4, 0.03);
    }
}

TEST(PbrtImage, ImagingRatioIsExposureTimesIso) {
    const std::string camera =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1 \"float "
        "shutterclose\" "
        "0.5\n";
    const std::string text =
        "Integrator \"path\"\nFilm \"rgb\" \"integer xresolution\" 8 \"integer "
        "yresolution\" 8 \"float iso\" 300\nPixelFilter \"box\"\n" +
        camera + "WorldBegin LightSource \"infinite\" \"rgb L\" [2 2 2]\n";
    EXPECT_NEAR(luminance(pbrt_image(text).at(0)), 2 * 0.5 * 300 / 100, 1e-4);
}

TEST(PbrtImage, RoughnessIsGgxAlphaByItsRoot) {
    const std::string glass = "Shape \"sphere\"\n";
    expect_same(
        pbrt_image(options() + kLamp + "LightSource \"infinite\"\n" +
                   "Material \"dielectric\" \"float roughness\" 0.09 \"float eta\" 1.7\n" + glass),
        our_image(kOurLamp +
                  "LightSource \"infinite\" \"color L\" [1 1 1]\nMaterial \"roughglass\" "
                  "\"float index\" [1.7] \"float uroughness\" [0.3] \"float vroughness\" [0.3] " +
                  kGgx + glass));
    expect_same(
        pbrt_image(options() + kLamp + "LightSource \"infinite\"\n" +
                   "Material \"dielectric\" \"float roughness\" 0.09 \"bool remaproughness\" false "
                   "\"float eta\" 1.7\n" +
                   glass),
        our_image(kOurLamp +
                  "LightSource \"infinite\" \"color L\" [1 1 1]\nMaterial \"roughglass\" "
                  "\"float index\" [1.7] \"float uroughness\" [0.09] \"float vroughness\" [0.09] " +
                  kGgx + glass));
}

TEST(PbrtImage, SmoothGlassMetalAndTranslucence) {
    const std::string ball = "Shape \"sphere\" \"float radius\" 1.5\n";
    const std::string our_ball = "Shape \"sphere\" \"float radius\" [1.5]\n";
    const std::string sky = "LightSource \"infinite\" \"float scale\" 0.5\n" + kLamp;
    const std::string our_sky =
        "LightSource \"infinite\" \"color L\" [1 1 1] \"float gain\" [0.5]\n" + kOurLamp;
    expect_same(pbrt_image(options() + sky + "Material \"dielectric\"\n" + ball),
                our_image(our_sky + "Material \"glass\" \"float index\" [1.5]\n" + our_ball));
    expect_same(
        pbrt_image(options() + sky + "Material \"thindielectric\" \"float eta\" 1.4\n" + ball),
        our_image(our_sky +
                  "Material \"glass\" \"float index\" [1.4] \"bool architectural\" "
                  "[\"true\"] \"bool pane\" [\"true\"]\n" +
                  our_ball));
    const auto extinction = [](double r) { return 2 * std::sqrt(r / (1 - r)); };
    expect_same(
        pbrt_image(options() + sky + "Material \"conductor\" \"rgb reflectance\" [0.9 0.6 0.3]\n" +
                   ball),
        our_image(
            our_sky +
            fmt::format("Texture \"f\" \"fresnel\" \"fresnelcolor\" \"color n\" [1 1 1] \"color "
                        "k\" [{} {} {}]\n",
                        extinction(0.9), extinction(0.6), extinction(0.3)) +
            "Material \"mirror\" \"texture fresnel\" \"f\"\n" + our_ball));
    expect_same(pbrt_image(options() + sky +
                           "Material \"conductor\" \"rgb eta\" [0.2 0.9 1.1] \"rgb k\" [3.9 2.4 "
                           "2.1] \"float roughness\" 0.25\n" +
                           ball),
                our_image(our_sky +
                          "Texture \"f\" \"fresnel\" \"fresnelcolor\" \"color n\" [0.2 0.9 1.1] "
                          "\"color k\" [3.9 2.4 2.1]\nMaterial \"metal2\" \"texture fresnel\" "
                          "\"f\" \"float uroughness\" [0.5] \"float vroughness\" [0.5] " +
                          kGgx + our_ball));
    expect_same(
        pbrt_image(options() + sky +
                   "Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" "
                   "\"spectrum k\" \"metal-Au-k\" \"float roughness\" 0.04\n" +
                   ball),
        our_image(our_sky +
                  "Texture \"gold\" \"fresnel\" \"preset\" \"string name\" [\"gold\"]\n"
                  "Material \"metal2\" \"texture fresnel\" \"gold\" \"float uroughness\" [0.2] "
                  "\"float vroughness\" [0.2] " +
                  kGgx + our_ball));
    expect_same(pbrt_image(options() + sky +
                           "Material \"diffusetransmission\" \"rgb reflectance\" [0.2 0.4 0.6] "
                           "\"rgb transmittance\" [0.6 0.4 0.2] \"float scale\" 0.5\n" +
                           ball),
                our_image(our_sky + "Material \"mattetranslucent\" \"color Kr\" " +
                          reflectance(0.1f, 0.2f, 0.3f) + " \"color Kt\" " +
                          reflectance(0.3f, 0.2f, 0.1f) + "\n" + our_ball));
}

TEST(PbrtImage, SmoothMetalReflectsByItsConstants) {
    const auto image = pbrt_image(
        options("LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n") +
        "LightSource \"infinite\"\n" +
        wall_of("Material \"conductor\" \"rgb eta\" [0.2 0.9 1.1] \"rgb k\" [3.9 2.4 2.1]\n"));
    const auto normal = [](double n, double k) {
        return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    };
    EXPECT_NEAR(image.at(27).x, normal(0.2, 3.9), 1e-4);
    EXPECT_NEAR(image.at(27).y, normal(0.9, 2.4), 1e-4);
    EXPECT_NEAR(image.at(27).z, normal(1.1, 2.1), 1e-4);
    // Under 80 degrees from the normal (Born & Wolf, section 14.2), n = 0.9, k = 2.4.
    const auto grazing = pbrt_image(
        options("LookAt 0 9.848 1.736  0 0 0  0 0 1\nCamera \"perspective\" \"float fov\" 0.1\n") +
        "LightSource \"infinite\"\n" +
        wall_of("Material \"conductor\" \"rgb eta\" [0.9 0.9 0.9] \"rgb k\" [2.4 2.4 2.4]\n"));
    const double c = std::cos(80 * kPi / 180), s2 = 1 - c * c, d = 0.81 - 5.76 - s2;
    const double ab = std::sqrt(d * d + 4 * 0.81 * 5.76), a = std::sqrt((ab + d) / 2);
    const double rs = (ab + c * c - 2 * a * c) / (ab + c * c + 2 * a * c);
    const double rp =
        rs * (c * c * ab + s2 * s2 - 2 * a * c * s2) / (c * c * ab + s2 * s2 + 2 * a * c * s2);
    EXPECT_NEAR(grazing.at(27).x, (rs + rp) / 2, 2e-3);
}

TEST(PbrtImage, CoatedDiffuse) {
    const std::string sky = "LightSource \"infinite\" \"float scale\" 0.5\n";
    const std::string ball = "Shape \"sphere\" \"float radius\" 1.5\n";
    expect_same(
        pbrt_image(options() + sky + kLamp +
                   "Material \"coateddiffuse\" \"rgb reflectance\" [0.2 0.4 0.6] \"float eta\" 1.7 "
                   "\"float roughness\" 0.09 \"float thickness\" 0.2 \"integer maxdepth\" 20\n" +
                   ball),
        our_image("LightSource \"infinite\" \"color L\" [1 1 1] \"float gain\" [0.5]\n" + kOurLamp +
                  "Material \"coateddiffuse\" \"color Kd\" " + reflectance(0.2f, 0.4f, 0.6f) +
                  " \"float index\" [1.7] \"float thickness\" [0.2] \"integer maxdepth\" [20] "
                  "\"float uroughness\" [0.3] \"float vroughness\" [0.3]\n"
                  "Shape \"sphere\" \"float radius\" [1.5]\n"));
}

TEST(PbrtImage, MixTakesItsSecondMaterialByTheAmount) {
    const std::string two =
        "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"rgb reflectance\" [1 1 1]\n"
        "MakeNamedMaterial \"b\" \"string type\" \"diffuse\" \"rgb reflectance\" [0 0 0]\n";
    const std::string camera =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n";
    const auto image = pbrt_image(
        options(camera) + "LightSource \"infinite\"\n" + two +
            wall_of("Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" 0.3\n"),
        ".", 64);
    EXPECT_NEAR(luminance(image.at(27)), 0.7, 0.02);
}

TEST(PbrtImage, AlphaCutsOut) {
    const std::string camera =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n";
    const auto image = pbrt_image(options(camera) +
                                      "LightSource \"infinite\" \"rgb L\" [1 1 1]\n"
                                      "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
                                      "Shape \"trianglemesh\" \"float alpha\" 0.25 " +
                                      kWall,
                                  ".", 256);
    double sum = 0;
    for (const Rgb& pixel : image)
        sum += double(luminance(pixel)) / 64;
    EXPECT_NEAR(sum, 0.75, 0.02);
}

TEST(PbrtImage, OpacityOfVersion3CutsOut) {
    files::TemporaryFolder folder;
    folder.write("half.pgm", std::string("P5\n2 1\n255\n") + '\xff' + '\0');
    const std::string world =
        "LightSource \"infinite\" \"color L\" [1 1 1]\n"
        "Texture \"t\" \"color\" \"imagemap\" \"string filename\" \"half.pgm\" "
        "\"string filter\" \"point\"\n"
        "Material \"uber\" \"color Kd\" [0 0 0] \"color Ks\" [0 0 0] ";
    const auto by_texture =
        pbrt_image(options() + world + "\"texture opacity\" \"t\"\nShape \"trianglemesh\" " + kWall,
                   folder.path().string());
    // u goes to the left: its lower half is white, where the black material is.
    EXPECT_NEAR(luminance(by_texture.at(8 * 4 + 6)), 0, 1e-6);
    EXPECT_NEAR(luminance(by_texture.at(8 * 4 + 1)), 1, 1e-3);
    double sum = 0;
    std::string scene =
        options("LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n");
    scene.append(world)
        .append("\"rgb opacity\" [0.3 0.3 0.3]\nShape \"trianglemesh\" ")
        .append(kWall);
    for (const Rgb& pixel : pbrt_image(scene, folder.path().string(), 256))
        sum += double(luminance(pixel)) / 64;
    EXPECT_NEAR(sum, 0.7, 0.02);
}

TEST(PbrtImage, LampsShineAlongTheirNormals) {
    const std::string camera =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 10\n";
    const auto seen = [&](const std::string& more) {
        return double(
            luminance(pbrt_image(options(camera) + "LightSource \"point\" \"float scale\" 1e-9\n" +
                                 "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n" + more)
                          .at(27)));
    };
    const std::string lamp = "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3] \"float scale\" 2\n";
    const std::string down = "\"normal N\" [0 0 -1 0 0 -1 0 0 -1 0 0 -1]\n";
    const std::string shape = "Shape \"trianglemesh\" " + kWall;
    EXPECT_NEAR(seen(lamp + shape), 6, 1e-4);
    EXPECT_NEAR(seen(lamp + "ReverseOrientation\n" + shape), 0, 1e-6);
    EXPECT_NEAR(seen(lamp + "Scale -1 1 1\n" + shape), 6, 1e-4) << "a mirrored face, turned back";
    EXPECT_NEAR(seen(lamp + shape + down), 0, 1e-6) << "faces look where their normals do";
    EXPECT_NEAR(seen(lamp + "ReverseOrientation\n" + shape + down), 6, 1e-4);
    const std::string both =
        "AreaLightSource \"diffuse\" \"rgb L\" [3 3 3] \"bool twosided\" true\n";
    EXPECT_NEAR(seen(both + shape), 3, 1e-4);
    EXPECT_NEAR(seen(both + shape + down), 3, 1e-4);
    EXPECT_NEAR(seen(both + "ReverseOrientation\n" + shape), 3, 1e-4);
    EXPECT_NEAR(seen(both + "ReverseOrientation\n" + shape + down), 3, 1e-4);
    // 36 square units of the wall: L = power / (pi A).
    EXPECT_NEAR(seen("AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"float power\" 100\n" + shape),
                100 / (kPi * 36), 1e-3);
    EXPECT_NEAR(seen("AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"float power\" 100 \"bool "
                     "twosided\" true\n" +
                     shape),
                100 / (2 * kPi * 36), 1e-3);
}

TEST(PbrtImage, ImagesStandUpright) {
    files::TemporaryFolder folder;
    // Two rows: the upper one is white.
    folder.write("rows.pgm", std::string("P5\n1 2\n255\n") + '\xff' + '\0');
    const std::string camera =
        "LookAt 0 0 4  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 60\n";
    const auto image = pbrt_image(
        options(camera) +
            "LightSource \"infinite\"\n"
            "Texture \"rows\" \"spectrum\" \"imagemap\" \"string filename\" \"rows.pgm\" "
            "\"string filter\" \"point\" \"string encoding\" \"linear\"\n" +
            wall_of("Material \"diffuse\" \"texture reflectance\" \"rows\"\n"),
        folder.path().string());
    EXPECT_NEAR(luminance(image.at(8 * 2 + 4)), 1, 0.1);
    EXPECT_NEAR(luminance(image.at(8 * 6 + 4)), 0, 0.01);
}

TEST(PbrtImage, EqualAreaSkyLooksTheRightWay) {
    files::TemporaryFolder folder;
    // Four by four pixels: +z in the middle, the rest dark but for +x (middle of the right edge).
    std::string pixels(std::size_t{4} * 4 * 3, '\0');
    const auto set = [&](std::size_t x, std::size_t y, std::size_t c) {
        pixels[(y * 4 + x) * 3 + c] = '\xff';
    };
    for (const int x : {1, 2})
        for (const int y : {1, 2})
            set(x, y, 0);  // red above
    for (const int y : {1, 2})
        set(3, y, 1);  // green towards +x
    for (const int x : {1, 2})
        set(x, 3, 2);  // blue towards +y
    folder.write("sky.ppm", "P6\n4 4\n255\n" + pixels);
    const auto towards = [&](const std::string& where) {
        return pbrt_image(options("LookAt 0 0 0  " + where +
                                  "  0.1 0.2 0.3\nCamera \"perspective\" \"float fov\" 1\n") +
                              "LightSource \"infinite\" \"string filename\" \"sky.ppm\"\n",
                          folder.path().string())
            .at(27);
    };
    const Rgb up = towards("0 0 1"), x = towards("1 0 0.3"), y = towards("0 1 0.3"),
              down = towards("0 0 -1");
    EXPECT_GT(up.x, 0.9f);
    EXPECT_GT(x.y, 0.3f);
    EXPECT_LT(x.z, 0.05f);
    EXPECT_GT(y.z, 0.3f);
    EXPECT_LT(y.y, 0.05f);
    EXPECT_LT(luminance(down), 0.05f);
}

TEST(PbrtImage, ProjectionStandsUpright) {
    files::TemporaryFolder folder;
    // Red, green over blue, black: pbrt's image lies with its left towards -x, its top towards +y.
    std::string pixels(12, '\0');
    pixels[0] = pixels[4] = pixels[8] = '\xff';
    folder.write("slide.ppm", "P6\n2 2\n255\n" + pixels);
    // Seen by a camera at the projector that looks along +z: x to the right, as in LookAt of pbrt.
    const auto image = pbrt_image(
        options("LookAt 0 0 0  0 0 1  0 1 0\nCamera \"perspective\" \"float fov\" 60\n") +
            "LightSource \"projection\" \"float fov\" 60 \"string filename\" \"slide.ppm\"\n"
            "Translate 0 0 2 Shape \"trianglemesh\" " +
            kWall,
        folder.path().string());
    const auto strongest = [](const Rgb& c) {
        return c.x > c.y ? (c.x > c.z ? 'r' : 'b') : c.y > c.z ? 'g' : c.z > 0 ? 'b' : '-';
    };
    EXPECT_EQ(strongest(image.at(8 * 1 + 1)), 'r');
    EXPECT_EQ(strongest(image.at(8 * 1 + 6)), 'g');
    EXPECT_EQ(strongest(image.at(8 * 6 + 1)), 'b');
    EXPECT_LT(luminance(image.at(8 * 7 + 7)), 0.2 * luminance(image.at(8 * 1 + 6)));
}

TEST(PbrtImage, ProjectionAndGoniometricHaveTheImagesIntensity) {
    files::TemporaryFolder folder;
    folder.write("white.ppm", "P6\n2 2\n255\n" + std::string(12, '\xff'));
    const std::string narrow =
        "LookAt 0 0 0  0 0 1  0 1 0\nCamera \"perspective\" \"float fov\" 0.1\n";
    const std::string wall =
        "Translate 0 0 2 Material \"diffuse\" \"rgb reflectance\" [1 1 1]\n"
        "Shape \"trianglemesh\" " +
        kWall;
    for (const std::string light :
         {"projection\" \"float fov\" 40", "goniometric\" \"rgb I\" [1 1 1]"}) {
        SCOPED_TRACE(light);
        std::string scene = options(narrow);
        scene.append("LightSource \"")
            .append(light)
            .append(" \"string filename\" \"white.ppm\" \"float scale\" 8\n")
            .append(wall);
        const auto image = pbrt_image(scene, folder.path().string());
        EXPECT_NEAR(luminance(image.at(27)), 8 / (4 * kPi), 2e-3);
    }
}

TEST(PbrtImage, GoniometricMapsHaveTheirPoleAlongY) {
    files::TemporaryFolder folder;
    std::string pixels(std::size_t{4} * 4 * 3, '\0');
    for (const std::size_t x : {1, 2})
        for (const std::size_t y : {1, 2})
            pixels[(y * 4 + x) * 3] = '\xff';
    folder.write("up.ppm", "P6\n4 4\n255\n" + pixels);
    const auto lit = [&](const std::string& where) {
        return pbrt_image(options("LookAt 0 0 0  " + where +
                                  "  1 2 3\nCamera \"perspective\" \"float fov\" 1\n") +
                              "LightSource \"goniometric\" \"string filename\" \"up.ppm\"\n"
                              "ReverseOrientation Shape \"sphere\" \"float radius\" 2\n",
                          folder.path().string(), kPasses, 1)
            .at(27)
            .x;
    };
    EXPECT_NEAR(lit("0 1 0"), 0.5 / (4 * kPi), 3e-3);
    EXPECT_LT(lit("0 -1 0"), 0.001f);
    EXPECT_LT(lit("0 0 1"), 0.01f);
}

TEST(PbrtImage, CheckerboardBeginsWithItsFirstTexture) {
    const auto image = pbrt_image(
        options() +
            "LightSource \"infinite\"\n"
            "Texture \"c\" \"spectrum\" \"checkerboard\" \"float uscale\" 2 \"float vscale\" 2 "
            "\"rgb tex1\" [1 1 1] \"rgb tex2\" [0.25 0.25 0.25]\n" +
            wall_of("Material \"diffuse\" \"texture reflectance\" \"c\"\n"),
        ".", 256);
    EXPECT_NEAR(luminance(image.at(8 * 6 + 6)), 1, 0.08)
        << "lower right, as x goes to the left: u and v below a half";
    EXPECT_NEAR(luminance(image.at(8 * 1 + 6)), 0.25, 0.05);
    EXPECT_NEAR(luminance(image.at(8 * 1 + 1)), 1, 0.08);
}

TEST(PbrtImage, InstancesAndScopes) {
    expect_same(
        pbrt_image(
            options() + kLamp +
            "AttributeBegin Material \"diffuse\" \"rgb reflectance\" [0.2 0.3 0.4]\n"
            "ObjectBegin \"ball\" Translate 1 0 0 Shape \"sphere\" \"float radius\" 0.5 ObjectEnd\n"
            "AttributeEnd\nAttributeBegin Scale 1 2 1 ObjectInstance \"ball\" AttributeEnd\n"
            "Rotate 90 0 0 1 ObjectInstance \"ball\"\n"),
        our_image(kOurLamp + "AttributeBegin Material \"matte\" \"color Kd\" " +
                  reflectance(0.2f, 0.3f, 0.4f) +
                  "ObjectBegin \"ball\" Translate 1 0 0 Shape \"sphere\" \"float radius\" [0.5] "
                  "ObjectEnd\n"
                  "AttributeEnd AttributeBegin Scale 1 2 1 ObjectInstance \"ball\" AttributeEnd\n"
                  "Rotate 90 0 0 1 ObjectInstance \"ball\"\n"));
}

/// A grid fills the box between p0 and p1 in the medium's space, and is nothing outside of it.
TEST(PbrtImage, GridOfDensities) {
    const std::string ball = "Shape \"sphere\" \"float radius\" [1.5]\n";
    const auto smoke = pbrt_image(
        options() + kLamp +
        "AttributeBegin\nTranslate 0.2 0 0\nMakeNamedMedium \"smoke\" \"string type\" "
        "\"uniformgrid\" \"integer nx\" 2 \"integer ny\" 1 \"integer nz\" 1 \"float density\" "
        "[4 1] \"float scale\" 0.5 \"rgb sigma_a\" [0.1 0.2 0.3] \"rgb sigma_s\" [0.3 0.2 0.1] "
        "\"point3 p0\" [-1 -1 -1] \"point3 p1\" [1 1 1]\nAttributeEnd\n"
        "MediumInterface \"smoke\" \"\"\nMaterial \"interface\"\n" +
        ball);
    const auto ours = our_image(
        kOurLamp +
            "AttributeBegin\nTranslate 0.2 0 0\nTranslate -1 -1 -1\nScale 2 2 2\n"
            "Texture \"grid\" \"float\" \"densitygrid\" \"integer nx\" [2] \"float density\" "
            "[1 0.25] \"string wrap\" [\"black\"] \"bool cut\" [\"true\"]\nAttributeEnd\n"
            "Texture \"a\" \"color\" \"mix\" \"texture amount\" [\"grid\"] \"color tex1\" "
            "[0 0 0] \"color tex2\" [0.2 0.4 0.6]\n"
            "Texture \"s\" \"color\" \"mix\" \"texture amount\" [\"grid\"] \"color tex1\" "
            "[0 0 0] \"color tex2\" [0.6 0.4 0.2]\n"
            "MakeNamedVolume \"smoke\" \"heterogeneous\" \"texture sigma_a\" [\"a\"] \"texture "
            "sigma_s\" [\"s\"]\nInterior \"smoke\"\nMaterial \"null\"\n" +
            ball,
        "VolumeIntegrator \"multi\"\nScale -1 1 1\nLookAt 0 0 4  0 0 0  0 1 0\nCamera "
        "\"perspective\" \"float fov\" [60]\n");
    expect_same(smoke, ours);
}

TEST(PbrtImage, MediaBetweenInterfaces) {
    const std::string fog =
        "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [0.1 0.2 0.3] "
        "\"rgb sigma_s\" [0.3 0.2 0.1] \"float scale\" 2 \"float g\" 0.4\n";
    expect_same(
        pbrt_image(options() + kLamp + fog +
                   "MediumInterface \"fog\" \"\"\nMaterial \"interface\"\n"
                   "Shape \"sphere\" \"float radius\" 1.5\n"),
        our_image(
            kOurLamp +
                "MakeNamedVolume \"fog\" \"homogeneous\" \"float fresnel\" [1] \"color sigma_a\" "
                "[0.2 0.4 0.6] "
                "\"color sigma_s\" [0.6 0.4 0.2] \"color g\" [0.4 0.4 0.4]\n"
                "Interior \"fog\" Material \"null\"\nShape \"sphere\" \"float radius\" [1.5]\n",
            "VolumeIntegrator \"multi\"\nScale -1 1 1\nLookAt 0 0 4  0 0 0  0 1 0\nCamera "
            "\"perspective\" "
            "\"float fov\" [60]\n"));
}

}  // namespace
}  // namespace lxs::test::pbrt_same_image_test
