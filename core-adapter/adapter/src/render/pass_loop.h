// The pass loop: eye paths, what each strategy carries to them, film; then all learn from the pass.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "aips/adapter/engine.h"
#include "eye/direct_light.h"
#include "eye/eye_source.h"
#include "layers/light_layers.h"
#include "sample_filter/invalid_sample_filter.h"
#include "strategies/light_strategy.h"

namespace aips {

class PassLoop {
  public:
    /// The host's parts and `settings` outlive it. `needs_points`: some strategy carries light to
    /// visible points.
    PassLoop(const Host& host, const Settings& settings, std::uint32_t eye_paths, bool needs_points,
             LightStrategies strategies);

    /// As those of Engine.
    PassReport render_pass(std::uint64_t pass);
    EngineStatistics statistics() const;
    void state(StateArchive& archive);
    void learned(StateArchive& archive);

  private:
    std::uint64_t look_ahead();
    std::uint64_t begin_pass(std::uint64_t pass);
    std::uint32_t trace_eye_paths(std::uint64_t pass);
    void add_light(const CarriedLight& light, FilmPass& film_pass);
    void learn(const StrategyPass& pass, const FilmPass& film_pass);
    void count_transport();
    void add_parts(const FilmPass& film_pass, FilmPass& parts);
    void count(const PassReport& report, std::uint64_t eye_rays);
    void refuse_powers();
    std::size_t memory_bytes() const;

    Host host_;
    const Settings& settings_;
    std::uint32_t eye_paths_;
    DirectLight direct_light_;
    std::optional<LightLayers> light_layers_;  // if they are asked for and lights are learned
    InvalidSampleFilter filter_;
    std::unique_ptr<EyeSource> eye_;
    LightStrategies strategies_;
    EyeImage image_;
    std::vector<Rgb> eye_radiance_;  // of eye paths and strategies together, if some add to it
    std::vector<Rgb> splat_parts_;   // [splat * kImageParts + part]
    EngineStatistics statistics_;
    LuminanceByLight seen_light_;  // that eye paths brought, summed by light
};

}  // namespace aips
