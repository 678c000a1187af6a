// Independent photon paths, and those of Markov chains.
#include "photons/photon_source.h"

#include "photons/photon_chains.h"

namespace aips {
namespace {

class IndependentPaths : public PhotonSource {
  public:
    float reach(const GatherRadii& radii) const override { return radii.reach(); }
    void mark_reach(std::span<const Vec3> /*visible_points*/, float /*radius*/) override {}
    void begin_pass(const PassPhotons& /*photons*/) override {}
    std::uint32_t iteration_paths() const override { return kPlainIterationPaths; }
    PhotonCounts trace(const PhotonInput& input, const IterationPaths& paths,
                       InvalidSampleFilter& filter, const PathTraces& traces) override {
        return tracer_.trace(input, paths.photons.before, paths.first, paths.count, filter,
                             traces.photons, traces.log, traces.collisions);
    }
    double end_pass() override { return 1; }
    void state(StateArchive& /*archive*/) override {}
    void add_to(EngineStatistics& /*statistics*/) const override {}
    std::size_t memory_bytes() const override { return tracer_.memory_bytes(); }

  private:
    PhotonTracer tracer_;
};

class PathsOfChains : public PhotonSource {
  public:
    float reach(const GatherRadii& radii) const override { return PhotonChains::reach(radii); }
    void mark_reach(std::span<const Vec3> visible_points, float radius) override {
        chains_.mark_reach(visible_points, radius);
    }
    void begin_pass(const PassPhotons& photons) override { chains_.begin_pass(photons.paths); }
    std::uint32_t iteration_paths() const override { return chains_.round_paths(); }
    PhotonCounts trace(const PhotonInput& input, const IterationPaths& paths,
                       InvalidSampleFilter& filter, const PathTraces& traces) override {
        return chains_.trace(input, paths.count, filter, traces.photons);
    }
    double end_pass() override { return chains_.end_pass(); }
    void state(StateArchive& archive) override { chains_.state(archive); }
    void add_to(EngineStatistics& statistics) const override {
        statistics.measured_paths = chains_.totals().measured;
        statistics.visible_paths = chains_.totals().visible;
        statistics.mutation_size = chains_.mutation_size();
    }
    std::size_t memory_bytes() const override { return chains_.memory_bytes(); }

  private:
    PhotonChains chains_;
};

}  // namespace

std::unique_ptr<PhotonSource> make_photon_source(bool chains) {
    if (chains) return std::make_unique<PathsOfChains>();
    return std::make_unique<IndependentPaths>();
}

}  // namespace aips
