// Protects the first rule of guiding: it changes variance, never expectation; and that guide=paper
// learns what the paper says (weights where eye rays end, errors, nodes that split).
#include "guides/paper/paper_guide.h"

#include <gtest/gtest.h>

#include "aips/core/base/arena.h"
#include "aips/core/sampling/random.h"
#include "block_test.h"
#include "render_mock.h"
#include "test_form.h"

namespace aips::guide_test {
namespace {

constexpr std::uint32_t kWidth = 32, kHeight = 24;

/// What guide=paper may be switched to for study.
struct Switches {
    CriterionKind criterion = CriterionKind::Paper;
    bool present_errors = true;
    bool direct_photons = true;
};

Settings switched(Settings settings, Switches to) {
    settings.guide = GuideKind::Paper;
    settings.error_criterion = to.criterion;
    settings.present_errors = to.present_errors;
    settings.direct_photons = to.direct_photons;
    return settings;
}

/// Block means of renders with different seeds; unguided if `switches` is null. Without shadow rays
/// all light comes by photons: more for the guide to spoil.
statistics::BlockMeans renders(bool shadow_rays, const Switches* switches, std::uint64_t first_seed,
                               unsigned seeds = statistics::sized(10u, 30u)) {
    const auto [scene, camera] = mock::half_mirror_view(kWidth, kHeight);
    statistics::BlockMeans means;
    for (unsigned s = 0; s < seeds; ++s) {
        // alpha 1 keeps the radius, and a fixed start radius is the same for both: equal bias.
        Settings settings = mock::small_settings(first_seed + s, 8000);
        if (switches) settings = switched(settings, *switches);
        settings.start_radius = 1;
        settings.iteration_photons = 1000;
        settings.initial_photons = 500;
        settings.direct_light_sampling = shadow_rays;
        const auto r = mock::render(scene, camera, kWidth, kHeight, settings, 6);
        means.push_back(statistics::block_means(mock::luminances(r.film), kWidth, kHeight, 8));
    }
    return means;
}

/// 13 tests per comparison at a family-wise significance of 1 %, fixed seeds.
void expect_same_expectation(const statistics::BlockMeans& plain,
                             const statistics::BlockMeans& guided) {
    const auto same = statistics::compare(plain, guided, 0.01);
    EXPECT_FALSE(same.differs()) << same.describe();
    const double planted = statistics::sized(0.05, 0.02);
    EXPECT_LT(same.detectable, planted) << same.describe();
    const auto found = statistics::compare(plain, statistics::scaled(guided, 1 + planted), 0.01);
    EXPECT_TRUE(found.differs()) << "a planted bias went unnoticed: " << found.describe();
}

TEST(PaperGuide, SameExpectationAsUnguided) {
    const auto plain = renders(false, nullptr, 1000);
    const Switches faithful, landed{.present_errors = false}, image{CriterionKind::Image};
    expect_same_expectation(plain, renders(false, &faithful, 2000));
    expect_same_expectation(plain, renders(false, &landed, 4000));
    expect_same_expectation(plain, renders(false, &image, 3000));
}

/// Photons that shadow rays own train the guide, and never reach the image.
TEST(PaperGuide, SameExpectationAsUnguidedBesideShadowRays) {
    const auto plain = renders(true, nullptr, 5000);
    std::uint64_t first_seed = 6000;
    for (const bool present : {true, false}) {
        for (const bool first : {true, false}) {
            const Switches switches{CriterionKind::Paper, present, first};
            expect_same_expectation(plain, renders(true, &switches, first_seed));
            first_seed += 1000;
        }
    }
}

/// In a black box under a lamp nothing lands but what shadow rays own.
mock::Rendering black_box(Switches switches) {
    mock::Material black;
    black.reflectance = {0, 0, 0};
    const mock::Scene scene = mock::lamp_box(black, black);
    const auto camera = mock::camera_along_y({0, -0.9f, 0}, 1, kWidth, kHeight);
    return mock::render(scene, camera, kWidth, kHeight,
                        switched(mock::small_settings(3, 8000), switches), 2);
}

TEST(PaperGuide, LearnsFromPhotonsThatShadowRaysOwn) {
    const mock::Rendering learned = black_box({});
    EXPECT_GT(learned.statistics.guide_nodes, 100u);
    EXPECT_EQ(learned.statistics.photons, 0u) << "none is for the image";
    EXPECT_EQ(learned.statistics.gathered, 0u);
    EXPECT_LE(learned.statistics.memory_bytes, learned.statistics.memory_bound_bytes);
    EXPECT_EQ(black_box({.direct_photons = false}).statistics.guide_nodes, 1u);
    // They are worth nothing to the photons' image.
    EXPECT_EQ(black_box({CriterionKind::Image}).statistics.guide_nodes, 1u);
}

/// Without shadow rays there is nothing that they own.
TEST(PaperGuide, FirstPhotonsArePhotonsLikeOthersWithoutShadowRays) {
    const auto image = [](bool direct_photons) {
        const auto [scene, camera] = mock::half_mirror_view(kWidth, kHeight);
        Settings settings =
            switched(mock::small_settings(4, 8000), {.direct_photons = direct_photons});
        settings.direct_light_sampling = false;
        return mock::render(scene, camera, kWidth, kHeight, settings, 2).film.image();
    };
    EXPECT_EQ(image(true), image(false));
}

Bounds unit_box() {
    return {{0, 0, 0}, {1, 1, 1}};
}

Settings guide_settings() {
    Settings settings;
    settings.node_photons = 8;
    settings.max_nodes = 64;
    return settings;
}

Photon photon_at(Vec3 position, Vec3 previous, float power) {
    Photon photon;
    photon.position = position;
    photon.previous = previous;
    photon.direction = normalize(previous - position);
    photon.power = {power, power, power};
    photon.depth = 2;
    return photon;
}

/// Directions at the middle of a matte ceiling; null if the guide knows none.
const GuidedDirections* from_ceiling(const PaperGuide& guide, Arena& arena) {
    const Bsdf* matte = mock::make_bsdf({}, {0, 0, -1}, {0, 0, -1}, arena);
    return guide.directions({{0.5f, 0.5f, 1}, {0, 0, -1}, {0, 0, -1}, matte, {0, 0, -1}}, arena);
}

/// Photons of uneven power on the floor [0,1]^2, seen by eye rays in its quarter at the origin.
TEST(PaperGuide, ErrorsAndTablesFollowVisibleNoise) {
    PaperGuide guide(unit_box(), guide_settings());
    std::vector<Vec3> eye;
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x)
            eye.push_back({0.025f + 0.05f * float(x), 0.025f + 0.05f * float(y), 0});
    }
    for (int pass = 0; pass < 3; ++pass) {
        guide.begin_pass(eye, eye.size());
        std::vector<Photon> photons;
        RandomStream random(5, std::uint64_t(pass), 0, RandomDomain::Photon);
        for (int i = 0; i < 400; ++i) {
            const Vec2 u = random.next2();
            photons.push_back(photon_at({u.x, u.y, 0}, {0.5f, 0.5f, 1}, 0.5f + random.next()));
            // What the ceiling's middle sees of the floor.
            photons.push_back(photon_at({0.5f, 0.5f, 1}, {u.x, u.y, 0}, 1));
        }
        guide.update(photons, {});
    }
    const NodeTree& tree = guide.tree();
    EXPECT_GT(tree.node_count(), 8u);
    EXPECT_LE(tree.node_count(), 64u);
    const Node& seen = tree.node(tree.locate({0.1f, 0.1f, 0}));
    const Node& unseen = tree.node(tree.locate({0.9f, 0.9f, 0}));
    EXPECT_GT(seen.weight, unseen.weight);
    EXPECT_GT(seen.error, unseen.error);

    // From the ceiling, the direction to the seen quarter is worth more than the opposite one.
    Arena arena;
    const GuidedDirections* directions = from_ceiling(guide, arena);
    ASSERT_NE(directions, nullptr);
    EXPECT_GT(directions->pdf(normalize(Vec3{-0.4f, -0.4f, -1})),
              2 * directions->pdf(normalize(Vec3{0.4f, 0.4f, -1})));
}

/// A node's error is what its photons contribute to the image, whatever their power, and the
/// ceiling sends photons to where that is most.
TEST(PaperGuide, ErrorsAndTablesFollowScores) {
    Settings settings = guide_settings();
    settings.error_criterion = CriterionKind::Image;
    PaperGuide guide(unit_box(), settings);
    ASSERT_TRUE(guide.needs_scores());
    guide.begin_pass(std::vector<Vec3>(100, Vec3{0.9f, 0.9f, 0}), 100);
    std::vector<Photon> photons;
    std::vector<double> scores;
    RandomStream random(6, 0, 0, RandomDomain::Photon);
    for (int i = 0; i < 400; ++i) {
        const Vec2 u = random.next2();
        const float power = 0.5f + random.next();
        const bool valuable = u.x < 0.5f && u.y < 0.5f;
        photons.push_back(photon_at({u.x, u.y, 0}, {0.5f, 0.5f, 1}, power));
        scores.push_back((valuable ? 9.0 : 1.0) * double(power) * double(power));
    }
    guide.update(photons, scores);
    const NodeTree& tree = guide.tree();
    EXPECT_NEAR(tree.node(tree.locate({0.1f, 0.1f, 0})).error, 3, 1e-5);
    EXPECT_NEAR(tree.node(tree.locate({0.9f, 0.9f, 0})).error, 1, 1e-5);

    Arena arena;
    const GuidedDirections* directions = from_ceiling(guide, arena);
    ASSERT_NE(directions, nullptr);
    EXPECT_GT(directions->pdf(normalize(Vec3{-0.4f, -0.4f, -1})),
              2 * directions->pdf(normalize(Vec3{0.4f, 0.4f, -1})));
}

TEST(PaperGuide, FirstIterationOfAPassIsPlain) {
    const PaperGuide guide(unit_box(), guide_settings());
    EXPECT_FALSE(guide.guides(0));
    EXPECT_TRUE(guide.guides(1));
    EXPECT_EQ(guide.iteration_paths(0), guide_settings().initial_photons);
    EXPECT_EQ(guide.iteration_paths(7), guide_settings().iteration_photons);
}

}  // namespace
}  // namespace aips::guide_test
