// Files and formulas of optical constants.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "materials/optical_table.h"
#include "shading_fixture.h"
#include "temporary_folder.h"

namespace lxs::optical_table_test {
namespace {

using namespace shading;

class OpticalTableTest : public ::testing::Test {
  protected:
    std::string write(const std::string& text) {
        std::string path = folder_ / "metal.nk";
        std::ofstream(path) << text;
        return path;
    }
    OpticalTable read(const std::string& text, OpticalFormat format = OpticalFormat::Any) {
        return read_optical_table(write(text), format, {});
    }

    files::TemporaryFolder folder_;
    ShadingFixture scene_;
};

TEST_F(OpticalTableTest, SopraInElectronvoltsAndMicrometres) {
    // 2 eV, 2.5 eV, 3 eV.
    const OpticalTable energies = read("1 2.0 3.0 2\n0.3 3.1\n0.4 2.9\n0.5 2.7\n");
    ASSERT_EQ(energies.size(), 3u);
    EXPECT_NEAR(energies[0].wavelength, 1239.84198 / 3, 1e-3);
    EXPECT_EQ(energies[0].n, 0.5);
    EXPECT_NEAR(energies[2].wavelength, 1239.84198 / 2, 1e-3);
    EXPECT_EQ(energies[2].k, 3.1);
    const OpticalTable lengths = read("2 0.4 0.8 1\n1.1 4\n1.3 6\n", OpticalFormat::Sopra);
    EXPECT_NEAR(constants_at(lengths, 500).n, 1.15, 1e-6);
    EXPECT_NEAR(constants_at(lengths, 500).k, 4.5, 1e-6);
}

TEST_F(OpticalTableTest, ColumnsInAnyUnit) {
    for (const char* text : {"; gold\n4000 1.5 2\n8000 0.5 4\n", "400, 1.5, 2\n800, 0.5, 4\n",
                             "# um\r\n0.8 0.5 4\r\n0.4 1.5 2\r\n"}) {
        const OpticalTable table = read(text);
        ASSERT_EQ(table.size(), 2u) << text;
        EXPECT_NEAR(constants_at(table, 600).n, 1, 1e-6) << text;
        EXPECT_EQ(constants_at(table, 100).n, 1.5);
        EXPECT_EQ(constants_at(table, 900).k, 4);
    }
}

TEST_F(OpticalTableTest, BadFilesAreSaid) {
    for (const char* text :
         {"", "gold\n", "400 1\n500 1 2 3 4\n", "400 -1 2\n", "400 1 2\nx 1 2\n"})
        EXPECT_THROW(read(text), InputError) << text;
    EXPECT_THROW(read("400 1 2\n", OpticalFormat::Sopra), InputError);
    EXPECT_THROW(read_optical_table("/no/such.nk", OpticalFormat::Any, {}), InputError);
}

TEST_F(OpticalTableTest, MetalsAndTexturesReadThem) {
    const std::string path = write("; perfect\n4000 0.5 30\n7000 0.5 30\n");
    const auto metal = scene_.make_material("metal", {text("filename", path)});
    BsdfMemory memory;
    const Rgb albedo = memory.scatter(*metal, shading_point())->albedo({0, 0, 1}, kGlossy);
    const float r = (0.25f + 900) / (2.25f + 900);  // ((n-1)^2 + k^2) / ((n+1)^2 + k^2)
    EXPECT_NEAR(albedo.x, r, 1e-4f);
    const auto texture = scene_.make_fresnel("luxpop", {text("filename", path)});
    EXPECT_TRUE(texture->constant()->conductor);
    EXPECT_EQ(texture->constant()->k, Rgb(30.0f));
    EXPECT_THROW(scene_.make_fresnel("sopra", {text("filename", path)}), InputError);
    EXPECT_THROW(scene_.make_fresnel("sopra"), InputError);
    EXPECT_TRUE(scene_.diagnostics.warnings.empty());
}

// Malitson 1965, table I: n(0.5893 um) = 1.45840, n(0.4358 um) = 1.46669.
TEST_F(OpticalTableTest, SellmeierIsFusedSilica) {
    const FresnelValue value = *scene_.make_fresnel("sellmeier")->constant();
    EXPECT_NEAR(value.eta.x, 1.4565f, 2e-4f);  // 650 nm
    EXPECT_NEAR(value.eta.z, 1.4656f, 2e-4f);  // 450 nm
    EXPECT_FALSE(value.conductor);
}

TEST_F(OpticalTableTest, AbbeNumberSpreadsTheIndex) {
    const FresnelValue value =
        *scene_.make_fresnel("abbe", {number("V", 30), number("n", 1.6)})->constant();
    // Cauchy through the d line: B (1/F^2 - 1/C^2) = (n - 1) / V.
    const double b = 0.6 / 30 / (1 / (0.4861327 * 0.4861327) - 1 / (0.6562725 * 0.6562725));
    EXPECT_NEAR(value.eta.z - value.eta.x, b * (1 / (0.45 * 0.45) - 1 / (0.65 * 0.65)), 1e-5);
    EXPECT_THROW(scene_.make_fresnel("abbe", {text("mode", "x")}), InputError);
}

TEST_F(OpticalTableTest, MixOfConstants) {
    scene_.fresnels["gold"] = scene_.make_fresnel("preset", {text("name", "gold")});
    const auto gold = *scene_.fresnels["gold"]->constant();
    const auto mix = scene_.make_fresnel(
        "mix", {texture("tex1", "gold"), number("tex2", 1.5), number("amount", 0.25)});
    EXPECT_NEAR(mix->constant()->eta.x, 0.75f * gold.eta.x + 0.25f * 1.5f, 1e-5f);
    EXPECT_NEAR(mix->constant()->k.y, 0.75f * gold.k.y, 1e-5f);
}

}  // namespace
}  // namespace lxs::optical_table_test
