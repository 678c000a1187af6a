// Protects: a node's error, and the paper's tables made of it, stay finite and usable with no
// photon, with one, without variance, and with errors of 0, denormal, 1e38 or NaN.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "aips/core/tables/paper_tables.h"
#include "aips/core/trees/kd_tree.h"
#include "stress_case.h"

namespace node_statistics_test {
namespace {

using namespace aips;
using namespace stress;

constexpr Bounds kUnit{{0, 0, 0}, {1, 1, 1}};
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Gives every node the same error.
class FixedError final : public ErrorCriterion {
  public:
    explicit FixedError(double error) : error_(error) {}
    double error(const NodeView&) const override { return error_; }

  private:
    double error_;
};

double error_of(int photons, float power, bool flat) {
    NodeTree tree(flat ? Bounds{{0, 0, 0}, {1, 1, 0}} : kUnit, {.max_nodes = 1});
    tree.add_eye_rays(std::vector<Vec3>{{0.5f, 0.5f, 0}}, 1);
    for (int i = 0; i < photons; ++i)
        tree.insert({0.25f + 0.5f * float(i % 2), 0.5f, 0}, power);
    tree.update_errors(PaperErrorCriterion(), false);
    const double first = tree.node(0).error;
    tree.end_pass();
    tree.update_errors(PaperErrorCriterion(), false);
    EXPECT_EQ(tree.node(0).error, first) << "a pass without photons keeps the error";
    return first;
}

TEST(StressNodeErrors, AreFiniteWithoutPhotonsAndWithoutVariance) {
    for (const bool flat : {false, true}) {
        for (const float power : {0.0f, 1e-45f, 1.0f, 1e30f, 3e38f}) {
            EXPECT_EQ(error_of(0, power, flat), 0);
            EXPECT_EQ(error_of(1, power, flat), 0);
            for (const int photons : {2, 3, 100}) {
                const double error = error_of(photons, power, flat);
                EXPECT_TRUE(std::isfinite(error) && error >= 0) << photons << ' ' << power;
            }
        }
    }
    NodeTree tree(kUnit, {});
    for (const float power : {std::nanf(""), -1.0f, std::numeric_limits<float>::infinity()})
        EXPECT_EQ(tree.insert({0.5f, 0.5f, 0.5f}, power), NodeTree::kNoNode);
    record("0, 1, 2, 3, 100 photons of equal power, 0 to 3e38; powers NaN, -1, infinite",
           "errors finite; 0 for fewer than two photons; odd powers refused");
}

TEST(StressNodeErrors, OddErrorsMakeUsableTables) {
    int tried = 0;
    for (const double ours : {0.0, 5e-324, 1e-310, 1.0, 1e38, 1e280, std::nan(""), kInf, -1.0}) {
        for (const double theirs : {0.0, 5e-324, 1.0, 1e38, 1e280}) {
            NodeTree tree(kUnit, {.max_nodes = 2, .node_photons = 2});
            for (const float x : {0.1f, 0.2f, 0.9f})
                tree.insert({x, 0.5f, 0.5f}, 1);
            tree.update_errors(FixedError(theirs), false);
            tree.insert({0.9f, 0.5f, 0.5f}, 1);
            tree.update_errors(FixedError(ours), true);  // of the upper node alone
            const bool usable = ours >= 0 && std::isfinite(ours);
            ASSERT_EQ(tree.node(1).error, usable ? ours : theirs);
            PaperTables tables({});
            Photon photon;
            photon.depth = 2;
            photon.position = {0.9f, 0.5f, 0.5f};
            photon.previous = {0.1f, 0.5f, 0.5f};
            photon.direction = {-1, 0, 0};
            tables.update(tree, std::vector(1000, photon));
            double sum = 0;
            for (const float relative : tables.relative_error(0)) {
                ASSERT_TRUE(relative > 0 && std::isfinite(relative));
                sum += double(relative);
            }
            ASSERT_NEAR(sum / 64, 1, 1e-5);
            ++tried;
        }
    }
    record("errors 0, denormal, 1e38, 1e280, NaN, infinite, negative in " + std::to_string(tried) +
               " pairs of nodes",
           "tables positive, mean 1");
}

}  // namespace
}  // namespace node_statistics_test
