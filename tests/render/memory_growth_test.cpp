// Protects: a long render takes no more memory than a short one, and no more than was announced.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "rendered_image.h"

namespace memory_growth_test {
namespace {

constexpr int kWidth = 120, kHeight = 80;
constexpr int kEarly = 40, kLate = 110;

/// Peak resident memory in bytes and the integrator's statistics of a run.
nlohmann::json run(const std::filesystem::path& scene, int passes, const render::Folder& folder,
                   const std::string& options = "") {
    const auto stats = folder.path() / "stats.json";
    render::render(scene,
                   "--passes " + std::to_string(passes) +
                       " --set aips.photonperpass=30000 --set aips.maxnodes=1024 --stats '" +
                       stats.string() + "' " + options,
                   folder);
    std::ifstream in(stats);
    return nlohmann::json::parse(in);
}

double peak(const nlohmann::json& figures) {
    return figures.at("peak memory bytes").get<double>();
}

void expect_below_bound(const nlohmann::json& figures) {
    const auto& engine = figures.at("aips");
    EXPECT_LE(engine.at("engine_bytes").get<double>(),
              engine.at("engine_bound_bytes").get<double>());
}

/// Stack, arenas, and what the C library keeps for a thread: 0.7 MB where there were few, 0.2 MB
/// where there were many.
TEST(MemoryGrowth, AThreadTakesLittle) {
    if (AIPS_SANITIZED) GTEST_SKIP() << "a sanitizer has memory of its own for each thread";
    constexpr double kOfAThread = 1024 * 1024;
    const render::Folder folder;
    const auto scene = render::small_scene("glass-ball", folder, kWidth, kHeight);
    const auto one = run(scene, 3, folder, "--threads 1");
    for (const int threads : {4, 64}) {
        const auto many = run(scene, 3, folder, "--threads " + std::to_string(threads));
        EXPECT_LE(peak(many) - peak(one), kOfAThread * threads) << threads << " threads";
        expect_below_bound(many);
        // The bound counts what the engine has for each thread.
        EXPECT_GT(many.at("aips").at("engine_bound_bytes").get<double>(),
                  one.at("aips").at("engine_bound_bytes").get<double>());
    }
}

/// By then the guide has split most of its leaves, and buffers hold nearly the largest pass that
/// they will meet: 1.2 to 1.8 MB more follow. A pass that left one float a pixel behind would
/// add 2.7.
TEST(MemoryGrowth, FlatOnceTheGuideHasLearned) {
    if (AIPS_SANITIZED) GTEST_SKIP() << "a sanitizer keeps what was freed";
    const render::Folder folder;
    const auto scene = render::small_scene("glass-ball", folder, kWidth, kHeight);
    const auto early = run(scene, kEarly, folder);
    const auto late = run(scene, kLate, folder);
    EXPECT_LE(peak(late) - peak(early), sizeof(float) * kWidth * kHeight * (kLate - kEarly));
    expect_below_bound(late);
}

}  // namespace
}  // namespace memory_growth_test
