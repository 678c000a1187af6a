// Protects: guide=none and each guide have the same expectation on real scenes, at the same
// radius schedule.
#include <gtest/gtest.h>

#include <iostream>

#include "seeded_renders.h"

namespace guide_agreement_test {
namespace {

constexpr int kWidth = 48, kHeight = 32, kBlock = 8;
constexpr std::size_t kColumns = kWidth / kBlock, kRows = kHeight / kBlock;
/// In one render of glass-ball in twenty an eye path comes out of the ball beside the lamp, and one
/// pixel outshines the image, whatever guides photons. With none of these seeds.
constexpr unsigned kFirstSeed = 300, kSeeds = 10;
/// Of all tests of one scene together.
constexpr double kSignificance = 0.01;

/// Blocks that are tested together, and the relative bias of all of them that must be found.
struct Region {
    std::string name;
    std::vector<std::size_t> blocks;
    double planted;
};

/// Few passes, many seeds. The radius is wide, and the same for both: a caustic is blurred then,
/// and calm, which leaves the means of both guides equal as before. Emitter paths, which
/// guide=paper does not have, would find the lamp in the ball that no eye path of these seeds
/// meets.
statistics::BlockMeans renders(const std::filesystem::path& scene, const std::string& guide,
                               const render::Folder& folder) {
    return render::seeded_block_means(
        scene,
        "--passes 2 --set aips.photonperpass=60000 --set aips.startradius=4 "
        "--set aips.guidescout=false --set aips.guidelamps=false --set aips.guide=" +
            guide,
        folder, {.first = kFirstSeed, .count = kSeeds}, kBlock);
}

using Edits = std::vector<std::pair<std::string, std::string>>;

/// A guide, and what is compared of its images.
struct Guided {
    std::string guide;
    std::vector<Region> regions;
};

void check(const std::string& name, const std::string& guide, const std::vector<Region>& regions,
           const statistics::BlockMeans& plain, const statistics::BlockMeans& guided) {
    const double significance = kSignificance / double(regions.size());
    for (const Region& region : regions) {
        const auto a = statistics::select(plain, region.blocks);
        const auto b = statistics::select(guided, region.blocks);
        const auto same = statistics::compare_paired(a, b, significance);
        std::cout << name << ", " << guide << ", " << region.name << ": " << same.describe()
                  << "\n";
        EXPECT_FALSE(same.differs()) << region.name << ": " << same.describe();
        const auto biased =
            statistics::compare_paired(a, statistics::scaled(b, 1 + region.planted), significance);
        EXPECT_TRUE(biased.differs())
            << "a planted bias of " << 100 * region.planted << " % of the " << region.name
            << " went unnoticed: " << biased.describe();
    }
}

void check(const std::string& name, const std::vector<Guided>& all, const Edits& edits = {}) {
    const render::Folder folder;
    const auto scene =
        render::edited_scene(render::small_scene(name, folder, kWidth, kHeight), folder, edits);
    const auto plain = renders(scene, "none", folder);
    for (const Guided& one : all)
        check(name, one.guide, one.regions, plain, renders(scene, one.guide, folder));
}

/// Blocks of the columns and rows [from, to), or all others.
std::vector<std::size_t> blocks(std::size_t from_column, std::size_t to_column,
                                std::size_t from_row, std::size_t to_row, bool inside) {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < kColumns * kRows; ++k) {
        const std::size_t x = k % kColumns, y = k / kColumns;
        const bool in = x >= from_column && x < to_column && y >= from_row && y < to_row;
        if (in == inside) chosen.push_back(k);
    }
    return chosen;
}

// Photons that start elsewhere, as with guide=adaptive, share nothing within a pair: less can be
// found.
TEST(GuideAgreement, GlassBall) {
    const auto caustic = blocks(2, 4, 1, 3, true), rest = blocks(2, 4, 1, 3, false);
    const std::string ball = "glass ball and caustic", others = "all but the caustic";
    check("glass-ball", {{"paper", {{ball, caustic, 0.02}, {others, rest, 0.01}}},
                         {"adaptive", {{ball, caustic, 0.02}, {others, rest, 0.02}}},
                         {"adaptive --set aips.guidebounces=false",
                          {{ball, caustic, 0.02}, {others, rest, 0.02}}}});
}
TEST(GuideAgreement, CornellBox) {
    const auto image = blocks(0, kColumns, 0, kRows, true);
    check("cornell-box",
          {{"paper", {{"image", image, 0.01}}}, {"adaptive", {{"image", image, 0.01}}}});
}
// Each pass has wavelengths of its own, drawn from the lamp's line as well: what the guide has
// learned from some it uses for others. Passes in which it learns count for less, so that the two
// means differ by their wavelengths too: less can be found.
TEST(GuideAgreement, AdaptiveByWavelengths) {
    check("cornell-box", {{"adaptive", {{"image", blocks(0, kColumns, 0, kRows, true), 0.08}}}},
          {{"WorldBegin",
            "WorldBegin\nTexture \"lamp\" \"color\" \"lampspectrum\" \"string name\" [\"LPS\"]"},
           {"\"color L\" [14 13 11]", "\"texture L\" [\"lamp\"] \"float gain\" [0.007]"}});
}

}  // namespace
}  // namespace guide_agreement_test
