// The same hits, ties included, whatever number of threads the process allows; and building a scene
// leaves that number alone.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fakes.h"
#include "run_on_threads.h"

namespace lxs::test::determinism_test {
namespace {

constexpr int kGrid = 40;

/// A wavy grid, `copies` times in one mesh: each point is a tie.
TriangleMesh coincident_grids(int copies) {
    TriangleMesh mesh;
    for (int copy = 0; copy < copies; ++copy) {
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        for (int i = 0; i < kGrid * kGrid; ++i) {
            const int row = i / kGrid;
            const auto x = static_cast<float>(i % kGrid), y = static_cast<float>(row);
            mesh.positions.emplace_back(x, y, std::sin(0.3f * x) * std::cos(0.2f * y));
        }
        for (std::uint32_t y = 0; y + 1 < kGrid; ++y) {
            for (std::uint32_t x = 0; x + 1 < kGrid; ++x) {
                const std::uint32_t a = base + y * kGrid + x;
                mesh.indices.insert(mesh.indices.end(),
                                    {a, a + 1, a + kGrid + 1, a, a + kGrid + 1, a + kGrid});
            }
        }
    }
    return mesh;
}

struct Met {
    std::uint32_t primitive, material;
    float distance;
    bool operator==(const Met&) const = default;
};

std::vector<Met> meet(const Scene& scene) {
    std::mt19937 random(1);
    std::vector<Met> all;
    for (int i = 0; i < 20000; ++i) {
        float x = static_cast<float>(random() >> 8) * 0x1p-24f * (kGrid - 1);
        float y = static_cast<float>(random() >> 8) * 0x1p-24f * (kGrid - 1);
        if (i % 3 == 0) x = std::floor(x);  // along edges
        if (i % 6 == 0) y = std::floor(y);  // through vertices
        SurfaceHit result;
        if (hit(scene, ray(Vec3(x, y, 9), Vec3(0, 0, -1)), result))
            all.push_back({result.primitive, result.material, result.distance});
    }
    return all;
}

std::unique_ptr<Scene> scene_with_ties() {
    SceneContents contents = instanced({primitive(coincident_grids(4))}, {Matrix(), Matrix()});
    for (std::uint32_t i = 0; i < 4; ++i) {
        contents.primitives.push_back(primitive(coincident_grids(4)));
        contents.primitives.back().material_index = i + 1;
    }
    return trace(std::move(contents));
}

TEST(Determinism, SameHitsForAnyNumberOfBuildThreads) {
    std::vector<Met> reference;
    for (const unsigned threads : {1u, 2u, 3u, 8u}) {
        const auto met = concurrency::run_on(threads, [] { return meet(*scene_with_ties()); });
        EXPECT_GT(met.size(), 19000u);
        if (reference.empty()) reference = met;
        EXPECT_EQ(met, reference) << threads << " threads";
    }
}

TEST(Determinism, BuildingLeavesTheProcessItsThreads) {
    const auto allowed = [] {
        return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    };
    const std::size_t before = allowed();
    const auto scene = scene_with_ties();
    EXPECT_EQ(allowed(), before);
}

}  // namespace
}  // namespace lxs::test::determinism_test
