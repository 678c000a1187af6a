// guide=adaptive in a photon pass.
#include <utility>

#include "guides/adaptive/adaptive_guide.h"
#include "guides/adaptive/learning_weight.h"
#include "photons/pass_guide.h"

namespace aips {
namespace {

class AdaptivePassGuide : public PassGuide {
  public:
    AdaptivePassGuide(const Scene& scene, const Settings& settings,
                      const DiscreteDistribution& light_choice, const PixelImportance& importance)
        : settings_(settings), guide_(scene, settings, light_choice, importance) {}

    bool wants_points() const override { return true; }
    void begin_with(std::span<const EmissionSeed> starts) override { guide_.begin_with(starts); }
    std::uint64_t begin_pass(const GuidedPass& pass) override {
        return guide_.begin_pass(pass.number, pass.time, pass.image, pass.positions, pass.radii);
    }
    void guide(std::uint64_t /*iteration*/, PhotonInput& input) override {
        input.emission = guide_.emission();
        input.survival = guide_.survival();
        input.score_mix = guide_.score_mix();
        input.split_limit = split_limit(settings_);
        input.log_one_of = guide_.log_one_of();
        input.guide = guide_.bounces();
        input.unguided_roulette = input.guide != nullptr;
        input.log_vertices = input.survival || input.guide;
    }
    std::uint32_t iteration_paths(std::uint64_t /*iteration*/,
                                  std::uint32_t unguided) const override {
        return guide_.iteration_paths(unguided);
    }
    PathLog* log() override { return &log_; }
    bool has_studies() const override { return !last_log_.paths.empty(); }
    void study() override { guide_.study(last_log_); }
    std::uint64_t learn(std::uint32_t paths, const OccupancyGrid& /*near*/,
                        PhotonStore& /*waiting*/) override {
        if (guide_.learns_at_once()) {
            guide_.study(log_);
        } else {
            std::swap(log_, last_log_);
        }
        log_.clear();
        return guide_.update(paths);
    }
    std::uint64_t end_pass() override {
        last_log_.clear();
        return guide_.update(0);
    }
    double weight(std::uint64_t path) const override { return learning_weight(path); }
    void state(StateArchive& archive) override { guide_.state(archive); }
    void learned(LearnedParts& parts) override { guide_.learned(parts); }
    void add_to(EngineStatistics& s) const override {
        s.guide_nodes = guide_.node_count();
        s.guide_bytes = guide_.memory_bytes();
        s.emission_gain = guide_.emission_guide().gain();
        s.survival_gain = guide_.survival_gain();
        if (const BounceGuide* bounces = guide_.bounces()) {
            s.bounce_gain = bounces->tables().gain();
            s.bounce_tables = bounces->tables().tables_in_use();
        }
        s.score_times_cost = guide_.score_times_cost();
        s.pruned_emission = guide_.emission_guide().starved_share(kPrunedDensity);
    }
    std::size_t memory_bytes() const override {
        return guide_.memory_bytes() + log_.memory_bytes() + last_log_.memory_bytes();
    }
    const AdaptiveGuide* adaptive() const override { return &guide_; }

  private:
    const Settings& settings_;
    AdaptiveGuide guide_;
    PathLog log_;       // of the iteration that is traced
    PathLog last_log_;  // of the one before, which may be studied meanwhile
};

}  // namespace

std::unique_ptr<PassGuide> make_adaptive_pass_guide(const Scene& scene, const Settings& settings,
                                                    const DiscreteDistribution& light_choice,
                                                    const PixelImportance& importance) {
    return std::make_unique<AdaptivePassGuide>(scene, settings, light_choice, importance);
}

}  // namespace aips
