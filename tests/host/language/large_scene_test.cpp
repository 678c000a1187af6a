// Inline arrays of millions of numbers: read right; the time is reported, not judged.
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

#include "scene_fakes.h"

namespace lxs::test {
namespace {

std::string grid_mesh(int side) {
    std::string text = "Shape \"trianglemesh\" \"point P\" [\n";
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            text += std::to_string(x * 0.125) + " " + std::to_string(y * -0.25) + " 1.5\n";
        }
    }
    text += "] \"integer indices\" [\n";
    for (int y = 0; y + 1 < side; ++y) {
        for (int x = 0; x + 1 < side; ++x) {
            const int a = y * side + x;
            for (const int i : {a, a + 1, a + side, a + 1, a + side + 1, a + side}) {
                text += std::to_string(i);
                text += ' ';
            }
            text += '\n';
        }
    }
    return text + "]\n";
}

TEST(LargeScene, MillionsOfInlineNumbers) {
    constexpr int kSide = 600;
    const std::string world = grid_mesh(kSide);
    const auto begin = std::chrono::steady_clock::now();
    const SceneContents contents = read_world(world);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    const auto& mesh = std::get<TriangleMesh>(contents.primitives.at(0).geometry);
    ASSERT_EQ(mesh.positions.size(), static_cast<std::size_t>(kSide) * kSide);
    ASSERT_EQ(mesh.indices.size(), static_cast<std::size_t>(kSide - 1) * (kSide - 1) * 6);
    EXPECT_EQ(mesh.positions.back(), Vec3(599 * 0.125f, 599 * -0.25f, 1.5f));
    EXPECT_EQ(mesh.indices.back(), static_cast<std::uint32_t>(kSide * (kSide - 1) + kSide - 2));
    const auto count = static_cast<double>(mesh.positions.size() * 3 + mesh.indices.size());
    std::cout << "[  report  ] " << count / 1e6 << " million numbers in " << elapsed.count()
              << " s\n";
}

TEST(LargeScene, ManyStatementsOnOneLine) {
    std::string world;
    for (int i = 0; i < 200000; ++i)
        world += "Identity ";
    EXPECT_EQ(error_of_world(world + "Shape \"sphere\""), "");
}

}  // namespace
}  // namespace lxs::test
