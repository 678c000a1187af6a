// Protects that a way of carrying light is added without touching the pass loop: one that stands in
// no list of the engine brings its light into the image beside the photons', is told of each pass,
// and is saved, restored and counted with the rest.
#include "strategies/light_strategy.h"

#include <gtest/gtest.h>

#include "render/pass_loop.h"
#include "render_mock.h"
#include "state/memory_archive.h"

namespace aips::light_strategy_test {
namespace {

constexpr std::uint32_t kSize = 12, kEyePaths = kSize * kSize;
constexpr unsigned kPasses = 3;

/// Lets every surface that takes photons glow, brighter from pass to pass: pass n brings n + 1
/// times what the eye path's throughput is. The order of passes thereby shows in the image.
class Glow : public LightStrategy {
  public:
    explicit Glow(PassMean mean) : mean_(mean) {}

    CarriedLight carry(const StrategyPass& pass, PassReport& report) override {
        radiance_.assign(pass.image.radiance.size(), Rgb{});
        for (const VisiblePoint& point : pass.image.visible_points)
            radiance_[point.sample] += point.throughput * static_cast<float>(brightness_);
        report.rays += 1;
        return {radiance_, mean_, 1};
    }
    void end_pass(const StrategyPass& pass, const FilmPass& film_pass) override {
        EXPECT_EQ(film_pass.positions.size(), pass.image.positions.size());
        ++brightness_;
    }
    void state(StateArchive& archive, const EyeImage& /*image*/) override {
        archive.value(brightness_);
    }
    void state_of_seconds(StateArchive& /*archive*/) override {}
    void add_to(EngineStatistics& statistics) const override { statistics.bounces += brightness_; }
    std::size_t memory_bytes() const override { return radiance_.capacity() * sizeof(Rgb); }
    std::size_t memory_bound_bytes() const override { return kEyePaths * sizeof(Rgb); }

  private:
    PassMean mean_;
    std::uint64_t brightness_ = 1;
    std::vector<Rgb> radiance_;
};

enum class With { Nothing, Photons, Glow, Both };

/// A render of which each part outlives the loop.
struct Render {
    explicit Render(With with)
        : view(mock::half_mirror_view(kSize, kSize)),
          film(kSize, kSize),
          plan(make_plan(view.scene, settings())),
          loop(host(), plan.settings(), kEyePaths, true, strategies(with)) {}

    static Settings settings() {
        Settings s = mock::small_settings(5, 2000);
        s.guide = GuideKind::Adaptive;
        // Without photons no eye path goes on, and its numbers never begin anew.
        s.continue_eye_paths = false;
        return s;
    }
    Host host() { return {view.scene, view.camera, sampler, film, log}; }
    LightStrategies strategies(With with) {
        LightStrategies chosen;
        if (with == With::Photons || with == With::Both)
            chosen = make_strategies(host(), plan, kEyePaths);
        if (with == With::Glow || with == With::Both)
            chosen.push_back(std::make_unique<Glow>(PassMean::Alike));
        return chosen;
    }
    void run(unsigned first, unsigned last) {
        for (unsigned pass = first; pass < last; ++pass)
            loop.render_pass(pass);
    }

    mock::View view;
    mock::Film film;
    mock::Sampler sampler{5};
    mock::Log log;
    Plan plan;
    PassLoop loop;
};

std::vector<double> image_of(With with) {
    Render render(with);
    render.run(0, kPasses);
    return mock::luminances(render.film);
}

TEST(LightStrategy, BringsItsLightBesideThePhotons) {
    const auto nothing = image_of(With::Nothing), photons = image_of(With::Photons);
    const auto glow = image_of(With::Glow), both = image_of(With::Both);
    double sum = 0;
    for (std::size_t i = 0; i < both.size(); ++i) {
        EXPECT_NEAR(both[i] - photons[i], glow[i] - nothing[i], 1e-4 * both[i]);
        sum += glow[i] - nothing[i];
    }
    // The mean over passes of brightness 1, 2 and 3; throughputs are 1 but for the ball's mirror.
    EXPECT_NEAR(sum / double(both.size()), 2, 0.2);
}

TEST(LightStrategy, IsSavedRestoredAndCounted) {
    Render whole(With::Both), first(With::Both), second(With::Both);
    whole.run(0, kPasses);
    first.run(0, 2);
    mock::Saving saving;
    first.loop.state(saving);
    mock::Restoring restoring(saving.saved());
    second.loop.state(restoring);
    EXPECT_EQ(restoring.remaining(), 0u);
    second.run(2, kPasses);
    first.run(2, kPasses);
    EXPECT_EQ(mock::luminances(first.film), mock::luminances(whole.film));
    const EngineStatistics a = second.loop.statistics(), b = whole.loop.statistics();
    EXPECT_EQ(a.bounces, b.bounces);
    EXPECT_EQ(a.passes, kPasses);
    EXPECT_LE(b.memory_bytes, b.memory_bound_bytes);
}

TEST(LightStrategy, TwoThatWeighTheirPassesAreRefused) {
    Render parts(With::Glow);
    LightStrategies two;
    two.push_back(std::make_unique<Glow>(PassMean::Weighted));
    two.push_back(std::make_unique<Glow>(PassMean::Weighted));
    PassLoop loop(parts.host(), parts.plan.settings(), kEyePaths, true, std::move(two));
    EXPECT_THROW(loop.render_pass(0), std::logic_error);
}

}  // namespace
}  // namespace aips::light_strategy_test
