// Emitters seen through glass and in mirrors: emitter paths beside eye paths, weighed against them.
#pragma once

#include "emitter_paths/emitter_pass.h"
#include "strategies/light_strategy.h"

namespace aips {

class EmitterStrategy : public LightStrategy {
  public:
    /// `host`'s parts outlive it; `eye_paths` of a pass, a multiple of the film's pixels.
    EmitterStrategy(const Host& host, std::uint32_t eye_paths);

    const EmitterImages* emitter_images() const override { return &images_; }
    std::uint64_t begin_pass(const ComingPass& pass) override;
    CarriedLight carry(const StrategyPass& pass, PassReport& report) override;
    void end_pass(const StrategyPass& pass, const FilmPass& film_pass) override;
    void state(StateArchive& archive, const EyeImage& image) override;
    /// Its time is that of eye paths.
    void state_of_seconds(StateArchive& /*archive*/) override {}
    void add_to(EngineStatistics& statistics) const override;
    std::size_t memory_bytes() const override;
    std::size_t memory_bound_bytes() const override;

  private:
    void search(const ComingPass& pass);
    std::uint32_t later_searches() const;

    Log& log_;
    std::size_t pixels_, groups_;
    std::uint32_t eye_paths_;
    EmitterImages images_;
    EmitterSplats splats_;
    double mean_luminance_ = 0;  // of the image; 0: not known
    LuminanceByLight light_;     // mean luminance of emitter paths by light, summed over passes
    std::uint64_t passes_ = 0;   // so many
    std::uint64_t paths_ = 0, searches_ = 0, search_rays_ = 0, rays_ = 0;
    std::uint64_t pass_rays_ = 0;
    double eye_rays_ = 0;  // of the last pass, without those
};

}  // namespace aips
