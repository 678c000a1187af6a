// Protects the tables of lights: each place asks the lights that light it, none weighs more than
// the plain choice allows, and memory is bounded.
#include "aips/core/tables/light_tables.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "aips/core/sampling/random.h"

namespace aips::light_tables_test {
namespace {

constexpr Bounds kScene{{0, 0, 0}, {1, 1, 1}};
constexpr Vec3 kUp{0, 0, 1};

LightTables equal_lights(std::size_t lights) {
    const std::vector<float> weights(lights, 1.0f);
    return {kScene, DiscreteDistribution(weights), light_table_settings(lights)};
}

/// Of all lights the first alone lights the left half of the scene, the last alone the right one.
void learn_halves(LightTables& tables, std::uint32_t lights, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        RandomStream random(1, std::uint64_t(round), 0, RandomDomain::Eye);
        for (int i = 0; i < 4000; ++i) {
            const float x = random.next(), y = random.next();
            LightSample s;
            s.position = {x, y, 0};
            s.normal = kUp;
            const DiscreteSample chosen = tables.at(s.position, s.normal).sample(random.next());
            s.light = std::uint32_t(chosen.index);
            s.pdf = chosen.pdf;
            s.value = s.light == (x < 0.5f ? 0 : lights - 1) ? 1 : 0;
            EXPECT_TRUE(tables.add(s));
        }
        tables.update(4000);
    }
}

TEST(LightTables, StartWithThePlainChoice) {
    const std::vector<float> weights{1, 0, 3};
    const LightTables tables(kScene, DiscreteDistribution(weights), light_table_settings(3));
    for (const Vec3 normal : {kUp, Vec3{-1, 0, 0}}) {
        const DiscreteDistribution& choice = tables.at({0.3f, 0.9f, 0.1f}, normal);
        EXPECT_NEAR(choice.pdf(0), 0.25, 1e-6);
        EXPECT_EQ(choice.pdf(1), 0);
        EXPECT_NEAR(choice.pdf(2), 0.75, 1e-6);
    }
}

/// A bright place tells others which lights there are, not how much is to be seen of them.
TEST(LightTables, DimPlacesLearnAsSoonAsBrightOnes) {
    LightTables tables = equal_lights(2);
    const Vec3 down{0, 0, -1};
    for (int i = 0; i < 4000; ++i) {
        const std::uint32_t light = i % 2;
        EXPECT_TRUE(tables.add({{0.5f, 0.5f, 0.5f}, kUp, light, 0.5f, light == 0 ? 1e3f : 0.0f}));
        if (i < 400) {
            EXPECT_TRUE(
                tables.add({{0.5f, 0.5f, 0.5f}, down, light, 0.5f, light == 1 ? 1e-3f : 0.0f}));
        }
    }
    tables.update(4400);
    EXPECT_GT(tables.at({0.5f, 0.5f, 0.5f}, kUp).pdf(0), 0.8);
    EXPECT_GT(tables.at({0.5f, 0.5f, 0.5f}, down).pdf(1), 0.8);
}

TEST(LightTables, AskTheLightsThatLightAPlace) {
    constexpr std::uint32_t kLights = 20;
    LightTables tables = equal_lights(kLights);
    learn_halves(tables, kLights, 100);
    // Of what is not drawn as without tables.
    const double most = 0.92 * (1 - light_table_settings(kLights).plain_share);
    for (const float y : {0.1f, 0.5f, 0.9f}) {
        EXPECT_GT(tables.at({0.2f, y, 0}, kUp).pdf(0), most);
        EXPECT_GT(tables.at({0.8f, y, 0}, kUp).pdf(kLights - 1), most);
    }
    EXPECT_GT(tables.leaf_count(), 6u);
}

TEST(LightTables, NoLightIsAskedMuchLessThanWithoutThem) {
    constexpr std::uint32_t kLights = 20;
    LightTables tables = equal_lights(kLights);
    learn_halves(tables, kLights, 20);
    const double least = light_table_settings(kLights).plain_share / kLights;
    RandomStream random(2, 0, 0, RandomDomain::Eye);
    for (int i = 0; i < 1000; ++i) {
        const float x = random.next(), y = random.next();
        double sum = 0;
        for (std::size_t light = 0; light < kLights; ++light) {
            const double pdf = double(tables.at({x, y, 0}, kUp).pdf(light));
            EXPECT_GE(pdf, 0.999 * least);
            sum += pdf;
        }
        EXPECT_NEAR(sum, 1, 1e-6);
    }
}

TEST(LightTables, UnusableSamplesTeachNothing) {
    const std::vector<float> weights{1, 0};
    LightTables tables(kScene, DiscreteDistribution(weights), light_table_settings(2));
    const LightSample good{{0.5f, 0.5f, 0}, kUp, 0, 0.5f, 1};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -1.0f}) {
        LightSample s = good;
        s.value = bad;
        EXPECT_FALSE(tables.add(s)) << bad;
    }
    for (const float bad : {nan, 0.0f, -1.0f}) {
        LightSample s = good;
        s.pdf = bad;
        EXPECT_FALSE(tables.add(s)) << bad;
    }
    LightSample s = good;
    s.light = 2;
    EXPECT_FALSE(tables.add(s));
    s = good;
    s.light = 1;
    EXPECT_FALSE(tables.add(s)) << "a dead light";
    s = good;
    s.position.x = nan;
    EXPECT_FALSE(tables.add(s));
    tables.update(0);
    EXPECT_EQ(tables.at(good.position, kUp).pdf(0), 1);
    EXPECT_TRUE(tables.add(good));
    tables.update(1);
    EXPECT_EQ(tables.at(good.position, kUp).pdf(1), 0);
}

TEST(LightTables, SettingsAreChecked) {
    const std::vector<float> weights{1, 1}, dead{0, 0};
    const DiscreteDistribution two(weights);
    EXPECT_THROW(LightTables(kScene, DiscreteDistribution(dead), {}), std::invalid_argument);
    for (const double share : {0.0, 1.1, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        LightTableSettings settings;
        settings.plain_share = share;
        EXPECT_THROW(LightTables(kScene, two, settings), std::invalid_argument) << share;
    }
    LightTableSettings settings;
    settings.prior_count = 0;
    EXPECT_THROW(LightTables(kScene, two, settings), std::invalid_argument);
}

TEST(LightTables, MemoryIsBounded) {
    for (const std::uint32_t lights : {2u, 30u, 5000u}) {
        LightTables tables = equal_lights(lights);
        learn_halves(tables, lights, 10);
        const std::size_t bound =
            LightTables::memory_bound_bytes(light_table_settings(lights), lights);
        EXPECT_LE(tables.memory_bytes(), bound) << lights;
        EXPECT_LE(bound, std::size_t{4} << 20) << lights;
    }
}

}  // namespace
}  // namespace aips::light_tables_test
