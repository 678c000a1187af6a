// Protects: textures by the grids of OpenVDB and NanoVDB files have the values of their voxels
// where the file's transform puts them, straight lines in between and nothing around; what is
// damaged is told.
//
// volumes/grids.vdb.gz, by python3-openvdb: voxel (i - 3, j - 2, k - 9) of the FloatGrid "density"
// is 1 + i + 10 j + 100 k for i < 6, j < 4, k < 10, that of the Vec3SGrid "colour" is 1, 2 and 3
// times as much; scaled by 0.5 and moved by (1, 2, 3). "mask" is a BoolGrid.
#include <gtest/gtest.h>
#include <zlib.h>

#include <array>

#define NANOVDB_USE_ZIP 1
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

#include "shading_fixture.h"
#include "temporary_folder.h"

namespace lxs::volume_file_test {
namespace {

constexpr std::array<int, 3> kFirst{-3, -2, -9}, kVoxels{6, 4, 10};

float value_of(int i, int j, int k) {
    return 1 + float(i) + 10 * float(j) + 100 * float(k);
}

class VolumeFile : public ::testing::TestWithParam<std::string> {
  protected:
    /// The grids as a file of the format that the test is for.
    std::string file() const {
        const std::string name = "grids." + GetParam();
        if (GetParam() == "vdb") return folder_.write(name, unpacked(LXS_VOLUMES "/grids.vdb.gz"));
        write_nanovdb(folder_ / name);
        return folder_ / name;
    }

    static std::string unpacked(const char* path) {
        std::string all;
        const gzFile file = gzopen(path, "rb");
        std::array<char, 4096> part{};
        for (int read; (read = gzread(file, part.data(), part.size())) > 0;)
            all.append(part.data(), std::size_t(read));
        gzclose(file);
        return all;
    }

    static void write_nanovdb(const std::string& path) {
        nanovdb::GridBuilder<float> density(0);
        nanovdb::GridBuilder<nanovdb::Vec3f> colour(nanovdb::Vec3f(0));
        auto to_density = density.getAccessor();
        auto to_colour = colour.getAccessor();
        for (int k = 0; k < kVoxels[2]; ++k) {
            for (int j = 0; j < kVoxels[1]; ++j) {
                for (int i = 0; i < kVoxels[0]; ++i) {
                    const nanovdb::Coord at{i + kFirst[0], j + kFirst[1], k + kFirst[2]};
                    const float value = value_of(i, j, k);
                    to_density.setValue(at, value);
                    to_colour.setValue(at, nanovdb::Vec3f(value, 2 * value, 3 * value));
                }
            }
        }
        std::vector<nanovdb::GridHandle<>> grids;
        grids.push_back(density.getHandle(0.5, nanovdb::Vec3d(1, 2, 3), "density",
                                          nanovdb::GridClass::FogVolume));
        grids.push_back(colour.getHandle(0.5, nanovdb::Vec3d(1, 2, 3), "colour"));
        nanovdb::io::writeGrids(path, grids, nanovdb::io::Codec::ZIP);
    }

    /// Where a voxel's value stands, from its number from kFirst on.
    static TexturePoint at(float i, float j, float k) {
        TexturePoint point;
        point.p = Vec3(i + float(kFirst[0]), j + float(kFirst[1]), k + float(kFirst[2])) * 0.5f +
                  Vec3(1, 2, 3);
        return point;
    }

    /// The message of a file that can't be read.
    std::string refusal(const std::string& path, const std::string& grid = "density") {
        try {
            scene_.make_float("densitygrid", {text("filename", path), text("gridname", grid)});
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    files::TemporaryFolder folder_;
    ShadingFixture scene_;
};

TEST_P(VolumeFile, HasItsValuesWhereItsTransformPutsThem) {
    const auto density = scene_.make_float("densitygrid", {text("filename", file())});
    const auto colour =
        scene_.make_color("densitygrid", {text("filename", file()), text("gridname", "colour")});
    for (int k = 0; k < kVoxels[2]; ++k) {
        for (int j = 0; j < kVoxels[1]; ++j) {
            for (int i = 0; i < kVoxels[0]; ++i) {
                const TexturePoint voxel = at(float(i), float(j), float(k));
                const float value = value_of(i, j, k);
                ASSERT_NEAR(density->evaluate(voxel), value, 1e-3f) << i << ' ' << j << ' ' << k;
                ASSERT_TRUE(colour->evaluate(voxel).equalWithAbsError(
                    Rgb(value, 2 * value, 3 * value), 3e-3f));
            }
        }
    }
    EXPECT_NEAR(density->evaluate(at(1.5f, 2.25f, 6.75f)), 1 + 1.5f + 22.5f + 675, 1e-2f);
    EXPECT_NEAR(density->evaluate(at(0, 0, -0.5f)), 0.5f, 1e-3f);
    for (const float outside : {-1.01f, 6.01f, 40.0f, -1e30f})
        EXPECT_EQ(density->evaluate(at(outside, 1, 1)), 0);
    EXPECT_NEAR(density->cell_size(), 0.5f, 1e-6f);
}

TEST_P(VolumeFile, GreyOfColoursAndColoursOfGrey) {
    const auto grey =
        scene_.make_float("densitygrid", {text("filename", file()), text("gridname", "colour")});
    EXPECT_NEAR(grey->evaluate(at(1, 1, 1)), 2 * value_of(1, 1, 1), 1e-3f);
    const auto colour = scene_.make_color("densitygrid", {text("filename", file())});
    EXPECT_TRUE(colour->evaluate(at(1, 1, 1)).equalWithAbsError(Rgb(value_of(1, 1, 1)), 1e-3f));
}

TEST_P(VolumeFile, MissingGridsAndDamageAreTold) {
    const std::string whole = file();
    EXPECT_NE(refusal(whole, "smoke").find("it has no grid \"smoke\", but \""), std::string::npos);
    const std::string bytes = folder_.read("grids." + GetParam());
    for (const double share : {0.02, 0.3, 0.9}) {
        const std::string cut =
            folder_.write("cut", bytes.substr(0, std::size_t(share * double(bytes.size()))));
        // One of them lies last.
        EXPECT_NE((refusal(cut) + refusal(cut, "colour")).find("cannot read grid"),
                  std::string::npos)
            << share;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, VolumeFile, ::testing::Values("vdb", "nvdb"),
                         [](const auto& format) { return format.param; });

TEST(OtherVolumeFiles, AreTold) {
    ShadingFixture scene;
    try {
        scene.make_float("densitygrid", {text("filename", LXS_VOLUMES "/grids.vdb.gz")});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("neither an OpenVDB nor a NanoVDB file"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace lxs::volume_file_test
