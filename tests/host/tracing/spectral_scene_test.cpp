// A scene with colours that are given as spectra: it says what they need, and in a spectral render
// lights and media have their spectra.
#include <gtest/gtest.h>

#include <cmath>

#include "fakes.h"
#include "lxs/spectrum/daylight.h"
#include "lxs/spectrum/rgb_spectra.h"

namespace lxs::test::spectral_scene_test {
namespace {

CurvePointer bell(double centre, double width) {
    return std::make_shared<SpectralCurve>(
        [=](double nm) { return std::exp(-0.5 * std::pow((nm - centre) / width, 2)); }, "bell");
}

/// A colour with a spectrum beside it.
class Coloured final : public ColorTexture {
  public:
    Coloured(const Rgb& rgb, CurvePointer spectrum) : rgb_(rgb), spectrum_(std::move(spectrum)) {}
    Rgb evaluate(const TexturePoint&) const override { return rgb_; }
    std::optional<Rgb> constant() const override { return rgb_; }
    CurvePointer spectrum() const override { return spectrum_; }

  private:
    Rgb rgb_;
    CurvePointer spectrum_;
};

const Rgb kLampColour(2.8f, 0.6f, 0);

Primitive lamp(const CurvePointer& spectrum) {
    Primitive shape = primitive(parallelogram(Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
    shape.emission = emission(Rgb(1.0f));
    shape.emission->radiance = std::make_shared<Coloured>(kLampColour, spectrum);
    return shape;
}

std::unique_ptr<TraceScene> traced(SceneContents contents) {
    std::unique_ptr<Scene> scene = trace(std::move(contents));
    return std::unique_ptr<TraceScene>(dynamic_cast<TraceScene*>(scene.release()));
}
std::unique_ptr<TraceScene> traced(Primitive only) {
    SceneContents contents;
    contents.primitives = {std::move(only)};
    return traced(std::move(contents));
}

TEST(SpectralScene, SaysWhetherRgbMisrepresentsItsSpectra) {
    EXPECT_FALSE(traced(lamp(nullptr))->spectral_need().given);
    const auto smooth = traced(lamp(bell(550, 60)));
    EXPECT_TRUE(smooth->spectral_need().given);
    EXPECT_FALSE(smooth->spectral_need().misrepresented());
    const auto line = traced(lamp(bell(589.3, 1.5)));
    EXPECT_TRUE(line->spectral_need().misrepresented());
    EXPECT_EQ(line->spectral_need().worst.pair, "bell on a green surface");
}

TEST(SpectralScene, OnlyMediaThatAreUsedCount) {
    SceneContents contents;
    contents.primitives = {lamp(nullptr)};
    const auto medium = std::make_shared<Medium>(Rgb(0.1f), 1.0f);
    contents.media.emplace_back(medium, MediumSpectra{bell(600, 5), nullptr});
    EXPECT_FALSE(traced(contents)->spectral_need().given);
    contents.primitives[0].interior = medium;
    EXPECT_TRUE(traced(contents)->spectral_need().misrepresented());
}

// Of a lamp's own luminance, however narrow its band, and the same met by a ray as sampled.
TEST(SpectralScene, LampsHaveTheirSpectrumAndTheirLuminance) {
    const CurvePointer spectrum = bell(589.3, 4);
    const auto scene = traced(lamp(spectrum));
    const WavelengthDensity density = scene->wavelength_density();
    double sum = 0, common = 0;
    constexpr int kPasses = 2000;
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        const Wavelengths w = wavelengths_of_pass(0, pass, density);
        scene->set_wavelengths(w);
        DirectSample sample;
        ASSERT_TRUE(scene->lights()[0]->sample_direct(Vec3(0.5f, 0.5f, 2), Vec3(0, 0, -1),
                                                      Vec2(0.5f), sample));
        SurfaceHit met;
        ASSERT_TRUE(hit(*scene, ray(Vec3(0.5f, 0.5f, 2), Vec3(0, 0, -1)), met));
        EXPECT_EQ(met.emitted, sample.radiance);
        const Imath::V3d rgb = Imath::V3d(sample.radiance) * w.to_rgb;
        sum += 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
        for (int i = 0; i < 3; ++i) {
            const double nm = w.nm[static_cast<std::size_t>(i)];
            if (spectrum->at(nm) < 1e-3) continue;
            const double factor = sample.radiance[i] * daylight(nm) / spectrum->at(nm);
            if (common == 0) common = factor;
            EXPECT_NEAR(factor, common, 0.01 * common) << nm;
        }
    }
    // A spectrum is in watts per nanometre, of which its colour is one of light.
    const double expected = double(kLuminanceOfFlatSpectrum) * double(luminance(kLampColour));
    EXPECT_NEAR(sum / kPasses, expected, 0.01 * expected);
}

TEST(SpectralScene, MediaHaveTheSpectraOfTheirCoefficients) {
    SceneContents contents;
    contents.primitives = {lamp(nullptr)};
    const auto medium =
        std::make_shared<Medium>(MediumCoefficients{Rgb(0.1f), Rgb(0.4f), Rgb(0.0f)}, IndexCurve{});
    contents.media.emplace_back(medium, MediumSpectra{bell(600, 30), nullptr});
    contents.primitives[0].interior = medium;
    const auto scene = traced(std::move(contents));
    const Wavelengths w = wavelengths_of_pass(0, 5);
    scene->set_wavelengths(w);
    for (int i = 0; i < 3; ++i) {
        const double t = (w.nm[static_cast<std::size_t>(i)] - 600) / 30;
        EXPECT_NEAR(medium->coefficients().absorption[i], std::exp(-0.5 * t * t), 1e-3);
        EXPECT_NEAR(medium->coefficients().scattering[i], 0.4f, 1e-6);
    }
}

}  // namespace
}  // namespace lxs::test::spectral_scene_test
