// Protects what each debug layer shows, pixel by pixel: photon densities known from counts and
// disks; node errors, weights, boundaries and guided shares of a guide whose nodes are known; and
// of whole renders whose guide has one node, so that its figures are those of all paths.
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "fixed_guide.h"
#include "layers/debug_layers.h"
#include "render_mock.h"

namespace aips::debug_layer_contents_test {
namespace {

using Layer = std::vector<float>;

/// Eye paths at these film positions, their visible points (if any) at these scene positions.
struct KnownPath {
    Vec2 film;
    bool has_point;
    Vec3 point;
};

EyeImage eye_image(const std::vector<KnownPath>& paths) {
    EyeImage image;
    for (const KnownPath& path : paths) {
        if (path.has_point) {
            VisiblePoint point;
            point.position = path.point;
            point.sample = std::uint32_t(image.positions.size());
            image.visible_points.push_back(point);
        }
        image.positions.push_back(path.film);
        image.radiance.push_back({});
    }
    return image;
}

/// Adds a pass in which these numbers of photons were accepted within these radii.
void add_pass(DebugLayers& layers, const EyeImage& image, const std::vector<std::uint32_t>& photons,
              const std::vector<float>& radii, double weight,
              const BounceStatistics* bounces = nullptr) {
    PhotonFlux flux;
    flux.reset(image.visible_points.size(), 1);
    flux.accepted = photons;
    layers.add_pass(image, flux, radii.empty() ? GatherRadii() : GatherRadii(radii),
                    {.positions = image.positions, .eye = image.radiance, .photon_weight = weight},
                    bounces);
}

/// Pixel (0, 0) of 3 x 2: in a pass of weight 1 two eye paths, of which one has 8 photons in a disk
/// of radius 2, the other none of a surface; in a pass of weight 3 one path with 3 photons within
/// 0.5: (1 x 8 / 4 + 1 x 0 + 3 x 3 / 0.25) / (1 + 1 + 3) / pi = 7.6 / pi.
TEST(DebugLayerContents, PhotonDensityIsTheMeanOfCountsOverDisks) {
    mock::Film film(3, 2);
    DebugLayers layers(film, nullptr);
    const EyeImage first = eye_image({{{0.2f, 0.9f}, true, {}},
                                      {{0.8f, 0.1f}, false, {}},
                                      {{2.5f, 0.5f}, true, {}},
                                      {{1.5f, 1.5f}, false, {}}});
    add_pass(layers, first, {8, 5}, {2.0f, 1.0f}, 1);
    const EyeImage second = eye_image({{{2.1f, 1.9f}, true, {}}, {{0.5f, 0.5f}, true, {}}});
    add_pass(layers, second, {1, 3}, {0.25f, 0.5f}, 3);
    const Layer expected{7.6f, 0, 5, 0, 0, 16};
    const Layer& shown = film.layers().at("photondensity");
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_FLOAT_EQ(shown[i] * std::numbers::pi_v<float>, expected[i]) << "pixel " << i;
}

/// A pass that shot no photons counts: half of the passes, half of the density.
TEST(DebugLayerContents, PhotonDensityCountsPassesWithoutPhotons) {
    mock::Film film(1, 1);
    DebugLayers layers(film, nullptr);
    const EyeImage image = eye_image({{{0.5f, 0.5f}, true, {}}});
    add_pass(layers, image, {4}, {1.0f}, 1);
    add_pass(layers, image, {0}, {}, 1);
    EXPECT_FLOAT_EQ(film.layers().at("photondensity")[0], 2 / std::numbers::pi_v<float>);
}

/// The nodes of a 4 x 3 image after two passes; the points of pixel (x, y) lie at (x, y) of the
/// scene, so that node 0 has the left half, 1 the right of the first row, 2 the rest. The first
/// pass sees pixel (3, 2) in node 0 and knows nothing of (0, 0), which shows no surface at all; the
/// second sees (3, 2) in node 2, but not (0, 1).
class KnownNodes : public testing::Test {
  protected:
    KnownNodes() : bounces_(guide_, 3) {
        bounces_.begin_pass();
        count({0, 0, 0}, 4, 1);
        count({3, 2, 0}, 4, 3);
        DebugLayers layers(film_, &guide_);
        for (const bool is_second : {false, true}) {
            std::vector<KnownPath> paths;
            for (std::uint32_t i = 0; i < 12; ++i) {
                const std::uint32_t x = i % 4, y = i / 4;
                if (i == 0 || (i == 4 && is_second)) continue;
                const Vec3 point =
                    i == 11 && !is_second ? Vec3{0, 0, 0} : Vec3{float(x), float(y), 0};
                paths.push_back({{float(x) + 0.5f, float(y) + 0.25f}, true, point});
            }
            paths.push_back({{0.5f, 0.5f}, false, {}});
            const EyeImage image = eye_image(paths);
            add_pass(layers, image, std::vector<std::uint32_t>(image.visible_points.size()), {}, 1,
                     &bounces_);
        }
    }
    void count(Vec3 position, int all, int guided) {
        for (int i = 0; i < all; ++i)
            bounces_.count(position, i < guided);
    }
    const Layer& layer(const char* name) const { return film_.layers().at(name); }

    static constexpr double kBeyondFloat = 1e300;
    mock::FixedGuide guide_{{{0.5, 3.25, 0}, {0.125, kBeyondFloat, 0}, {2, 0.75, 0}}};
    BounceStatistics bounces_;
    mock::Film film_{4, 3};
};

TEST_F(KnownNodes, NodeErrorIsThatOfThePixelsNode) {
    const float most = std::numeric_limits<float>::max();
    EXPECT_EQ(layer("nodeerror"), (Layer{0, 3.25f, most, most,  //
                                         3.25f, 3.25f, 0.75f, 0.75f, 3.25f, 3.25f, 0.75f, 0.75f}));
}

TEST_F(KnownNodes, NodeWeightIsThatOfThePixelsNode) {
    EXPECT_EQ(layer("nodeweight"), (Layer{0, 0.5f, 0.125f, 0.125f,  //
                                          0.5f, 0.5f, 2, 2,         //
                                          0.5f, 0.5f, 2, 2}));
}

TEST_F(KnownNodes, NodeBoundariesAreBetweenPixelsOfDifferentNodes) {
    EXPECT_EQ(layer("nodeedges"), (Layer{0, 1, 1, 1,  //
                                         0, 1, 1, 1,  //
                                         0, 1, 1, 0}));
}

TEST_F(KnownNodes, GuidedShareIsThatOfTheBouncesInThePixelsNode) {
    EXPECT_EQ(layer("guidedshare"), (Layer{0, 0.25f, 0, 0,              //
                                           0.25f, 0.25f, 0.75f, 0.75f,  //
                                           0.25f, 0.25f, 0.75f, 0.75f}));
}

/// A paper guide that never splits, so that it has one node.
Settings one_node(std::uint64_t seed) {
    Settings settings = mock::small_settings(seed, 5000);
    settings.guide = GuideKind::Paper;
    settings.max_nodes = 1;
    settings.debug_layers = true;
    return settings;
}

/// A wall fills the right quarter of the view, nothing the rest: the node's weight is the share of
/// eye rays that meet the wall, summed over the passes.
TEST(OneNode, WeightIsTheShareOfEyeRaysThatMetASurface) {
    constexpr std::uint32_t kSize = 8, kPasses = 3;
    mock::Scene scene;
    mock::Surface wall;
    wall.shape = mock::Quad{{0.5f, 1, -4}, {4, 0, 0}, {0, 0, 8}};
    scene.add(wall);
    scene.add_point_light({0.75f, 0, 0}, {1, 1, 1});
    scene.finish();
    Settings settings = one_node(3);
    settings.direct_light_sampling = false;
    const auto camera = mock::camera_along_y({0, 0, 0}, 1, kSize, kSize);
    const auto r = mock::render(scene, camera, kSize, kSize, settings, kPasses);
    const Layer& weight = r.film.layers().at("nodeweight");
    for (std::size_t i = 0; i < weight.size(); ++i)
        EXPECT_EQ(weight[i], i % kSize < 6 ? 0 : 0.25f * kPasses) << "pixel " << i;
    EXPECT_EQ(r.film.layers().at("nodeedges"), Layer(weight.size(), 0));
}

/// The only node's share is that of all bounces of the last pass.
TEST(OneNode, GuidedShareIsThatOfAllBouncesOfTheLastPass) {
    constexpr std::uint32_t kSize = 6;
    const mock::Scene scene = mock::lamp_box({}, {});
    const auto camera = mock::camera_along_y({0, -0.95f, 0}, 0.9f, kSize, kSize);
    const auto after = [&](std::uint32_t passes) {
        return mock::render(scene, camera, kSize, kSize, one_node(4), passes);
    };
    const auto before = after(1).statistics;
    const auto r = after(2);
    const double guided = double(r.statistics.guided_bounces - before.guided_bounces);
    const auto share = float(guided / double(r.statistics.bounces - before.bounces));
    EXPECT_GT(share, 0.3);
    EXPECT_EQ(r.film.layers().at("guidedshare"), Layer(std::size_t{kSize} * kSize, share));
}

}  // namespace
}  // namespace aips::debug_layer_contents_test
