// Protects what is learned of direct light where an eye path's first ray shares it with shadow
// rays: both ways of reckoning it have one expectation, and near large lights sharing is calmer.
#include <gtest/gtest.h>

#include <cmath>

#include "render_mock.h"
#include "traced_eye_image.h"

namespace aips::shared_direct_light_test {
namespace {

constexpr std::uint32_t kSize = 32, kPaths = 256 * kSize * kSize;
/// Beyond this a mean of differences is no chance: two-sided, significance 6e-5.
constexpr double kMostStandardErrors = 4;

struct Differences {
    double points = 0, alone = 0, sum = 0, squares = 0, alone_squares = 0, shared_squares = 0;

    explicit Differences(const EyeImage& image) {
        for (const VisiblePoint& point : image.visible_points) {
            if (!point.continued) continue;
            const double a = point.direct_alone, s = point.direct_shared;
            points += 1;
            alone += a;
            sum += a - s;
            squares += (a - s) * (a - s);
            alone_squares += a * a;
            shared_squares += s * s;
        }
    }
    double standard_error() const { return std::sqrt(squares); }
};

/// A closed box that shines, seen by eye paths of which one in four goes on.
EyeImage shining_box(const Vec3& eye) {
    mock::Scene scene;
    mock::Surface surface;
    surface.emitted = {1, 1, 1};
    scene.add_box({-1, -1, -1}, {1, 1, 1}, surface);
    scene.finish();
    const EyeShares shares(scene.bounds());
    return mock::traced_eye_image(scene, mock::camera_along_y(eye, 0.4f, kSize, kSize), kSize,
                                  kPaths, mock::small_settings(5, 1), &shares);
}

TEST(SharedDirectLight, SameExpectation) {
    const Differences found(shining_box({0, -0.5f, 0}));
    ASSERT_NEAR(found.points, 0.25 * kPaths, 0.0025 * kPaths);
    EXPECT_NEAR(found.sum, 0, kMostStandardErrors * found.standard_error());
    EXPECT_GT(0.02 * found.alone, kMostStandardErrors * found.standard_error())
        << "a planted error of 2 % would go unnoticed";
}

TEST(SharedDirectLight, CalmerWhereLightIsNear) {
    const Differences found(shining_box({0.7f, -0.5f, 0.7f}));
    EXPECT_LT(found.shared_squares, 0.5 * found.alone_squares);
}

}  // namespace
}  // namespace aips::shared_direct_light_test
