// Protects the choice of lights: its frequencies are the probabilities that it states.
#include "path/light_selector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace lxs::test::light_selector_test {
namespace {

class PowerOnly : public Light {
  public:
    explicit PowerOnly(float power, bool at_infinity = false)
        : power_(power), at_infinity_(at_infinity) {}
    std::string_view kind() const override { return "test"; }
    std::uint32_t group() const override { return 0; }
    float power() const override { return power_; }
    bool at_infinity() const override { return at_infinity_; }
    bool sample_emission(const PrimaryPoint& /*u*/, EmissionSample& /*sample*/) const override {
        return false;
    }
    bool sample_direct(const Vec3& /*p*/, const Vec3& /*n*/, const Vec2& /*u*/,
                       DirectSample& /*sample*/) const override {
        return false;
    }
    float pdf_direct(const Vec3& /*p*/, const Vec3& /*n*/, const Vec3& /*wi*/,
                     const Vec3& /*light_p*/, const Vec3& /*light_n*/,
                     std::uint32_t /*primitive*/) const override {
        return 0;
    }

  private:
    float power_;
    bool at_infinity_;
};

const PowerOnly kWeak(1), kDead(0), kStrong(6), kSky(3, true);
const Light* const kLights[] = {&kWeak, &kDead, &kStrong, &kSky};

TEST(LightSelector, FrequenciesAreTheStatedProbabilities) {
    constexpr int kDraws = 100'000;
    for (const LightStrategy strategy :
         {LightStrategy::Power, LightStrategy::LogPower, LightStrategy::Uniform}) {
        const LightSelector selector(kLights, strategy);
        ASSERT_EQ(selector.choices(), 1u);
        std::map<const Light*, int> counts;
        for (int i = 0; i < kDraws; ++i) {
            // A stratified u: counts may be off by one at each border.
            const LightChoice choice = selector.choose(0, (static_cast<float>(i) + 0.5f) / kDraws);
            EXPECT_EQ(choice.probability, selector.probability(choice.light));
            ++counts[choice.light];
        }
        EXPECT_EQ(counts.count(&kDead), 0u);
        for (const auto& [light, count] : counts) {
            EXPECT_NEAR(count, selector.probability(light) * kDraws, 2);
        }
    }
}

/// A probability below the steps of random numbers would never, or far too often, be drawn.
TEST(LightSelector, ProbabilitiesAreCountsOfRandomNumbers) {
    const PowerOnly least(1e-12f), dim(1e-9f), half(1), other(1);
    const Light* const lights[] = {&half, &dim, &other, &least};
    const LightSelector selector(lights, LightStrategy::Power);
    std::map<const Light*, double> drawn;
    const float step = 0x1p-24f;
    for (int i = 0; i < 1 << 24; ++i)
        drawn[selector.choose(0, static_cast<float>(i) * step).light] += double{step};
    for (const Light* light : lights) {
        EXPECT_EQ(drawn[light], double{selector.probability(light)}) << light->power();
        EXPECT_GT(drawn[light], 0) << light->power();
    }
}

TEST(LightSelector, PowerIsProportional) {
    const LightSelector selector(kLights, LightStrategy::Power);
    EXPECT_FLOAT_EQ(selector.probability(&kWeak), 0.1f);
    EXPECT_FLOAT_EQ(selector.probability(&kStrong), 0.6f);
    EXPECT_FLOAT_EQ(selector.probability(&kSky), 0.3f);
    EXPECT_EQ(selector.probability(&kDead), 0);
}

TEST(LightSelector, AllAsksEachLightOnce) {
    const LightSelector selector(kLights, LightStrategy::All);
    ASSERT_EQ(selector.choices(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(selector.choose(i, 0.3f).probability, 1);
    ASSERT_EQ(selector.at_infinity().size(), 1u);
    EXPECT_EQ(selector.at_infinity()[0], &kSky);
}

TEST(LightSelector, NoLiveLightMeansNoChoice) {
    const Light* const dead[] = {&kDead};
    EXPECT_EQ(LightSelector(dead, LightStrategy::Power).choices(), 0u);
    EXPECT_EQ(LightSelector(dead, LightStrategy::All).choices(), 0u);
}

/// Where shadow rays found one of three lights alone, it is asked most; other places, and lights
/// without power, are asked as before.
TEST(LightSelector, PlacesAskWhatTheyLearned) {
    LightSelector selector(kLights, LightStrategy::Learned, {Vec3(-1.0f), Vec3(1.0f)});
    const Vec3 up(0, 0, 1), here(0.5f, 0.5f, 0);
    ASSERT_TRUE(selector.learns());
    EXPECT_FLOAT_EQ(selector.probability(&kStrong, selector.at(here, up)), 0.6f);
    std::vector<aips::LightSample> samples;
    for (int i = 0; i < 4096; ++i) {
        const LightChoice choice = selector.choose(0, (static_cast<float>(i) + 0.5f) / 4096);
        samples.push_back({{here.x, here.y, here.z},
                           {up.x, up.y, up.z},
                           choice.index,
                           choice.probability,
                           choice.light == &kWeak ? 1.0f : 0.0f});
    }
    selector.learn(samples, samples.size(), 1);
    const LightTable table = selector.at(here, up);
    EXPECT_GT(selector.probability(&kWeak, table), 0.85f);
    EXPECT_EQ(selector.probability(&kDead, table), 0);
    double sum = 0;
    for (const Light* light : kLights)
        sum += double{selector.probability(light, table)};
    EXPECT_EQ(sum, 1);
    int weak = 0;
    for (int i = 0; i < 4096; ++i) {
        const LightChoice choice = selector.choose(0, (static_cast<float>(i) + 0.5f) / 4096, table);
        EXPECT_EQ(choice.probability, selector.probability(choice.light, table));
        weak += choice.light == &kWeak ? 1 : 0;
    }
    EXPECT_NEAR(weak, double{selector.probability(&kWeak, table)} * 4096, 2);
    EXPECT_FLOAT_EQ(selector.probability(&kWeak), 0.1f);
}

TEST(LightSelector, LearnsNothingWhereThereIsNoChoice) {
    const Light* const one[] = {&kDead, &kSky};
    const LightSelector selector(one, LightStrategy::Learned);
    EXPECT_FALSE(selector.learns());
    EXPECT_EQ(selector.at(Vec3(0.0f), Vec3(0, 0, 1)), nullptr);
    EXPECT_FALSE(LightSelector(kLights, LightStrategy::Power).learns());
}

TEST(LightSelector, LargestUGivesTheLastLight) {
    const LightSelector selector(kLights, LightStrategy::Power);
    EXPECT_EQ(selector.choose(0, std::nextafter(1.0f, 0.0f)).light, &kSky);
}

}  // namespace
}  // namespace lxs::test::light_selector_test
