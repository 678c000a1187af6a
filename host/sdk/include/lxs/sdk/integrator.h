// What a surface integrator plugin implements. The host owns the loop over passes, budgets,
// progress and output; the integrator renders one pass at a time.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lxs/sdk/camera.h"
#include "lxs/sdk/film.h"
#include "lxs/sdk/invalid_samples.h"
#include "lxs/sdk/log.h"
#include "lxs/sdk/ranks.h"
#include "lxs/sdk/scene.h"
#include "lxs/sdk/state_archive.h"
#include "lxs/sdk/transport_statistics.h"

namespace lxs {

/// What a render is asked to be; fixed for its whole length.
struct RenderSettings {
    unsigned threads = 0;  ///< 0: all; the host has already limited oneTBB to it
    std::uint64_t seed = 0;
    /// transport_statistics() will be asked for: counts what it needs.
    bool transport_statistics = false;
};

/// The parts of the host that an integrator works with; they outlive it.
struct RenderContext {
    const Scene& scene;
    const Camera& camera;
    const Sampler& sampler;
    Film& film;
    Log& log;
    RenderSettings settings;
    Ranks* ranks = nullptr;  ///< that share each pass; null: this process renders alone
};

/// What one pass did, for progress and budgets.
struct PassReport {
    std::uint64_t photon_paths = 0;
    std::uint64_t rays = 0;
    double samples_per_pixel = 1;
};

/// Named figures for the statistics file, in the order given.
using Statistics =
    std::vector<std::pair<std::string, std::variant<double, std::uint64_t, std::string>>>;

class Integrator {
  public:
    virtual ~Integrator() = default;
    /// Called once, before the first pass. Throws std::runtime_error with one clear message when
    /// the scene can't be rendered.
    virtual void prepare(const RenderContext& context) = 0;
    /// Renders pass number `pass` (from 0) and adds it to the film.
    virtual PassReport render_pass(std::uint64_t pass) = 0;
    /// False if radiance is carried from one pass to a later one (frozen eye paths, Markov chains):
    /// the passes of a render can't then each have wavelengths of their own. Asked before
    /// prepare().
    virtual bool passes_stand_alone() const { return true; }
    /// Whether the ranks of RenderContext share the work of each pass, and the image has the same
    /// bits with any number of them. Asked before prepare().
    virtual bool shares_passes() const { return false; }
    virtual Statistics statistics() const { return {}; }
    /// Contributions left out of the image because they were not finite or negative, by the
    /// material, the light or whatever else they came from: reported at the end of the render.
    virtual InvalidSampleList invalid_samples() const { return {}; }
    /// What became of light and photons so far; empty for an integrator that does not tell. The
    /// image is the same bit for bit whether it is asked for or not.
    virtual TransportStatistics transport_statistics() const { return {}; }
    /// Saves everything that one pass leaves for later ones, or restores it: after prepare() with
    /// the same scene, settings and seed, instead of the passes that led to it. Later passes then
    /// give the same bits as if there had been no interruption; statistics go on likewise. Throws
    /// StateError if what is restored doesn't fit; another exception if there is no such state.
    virtual void state(StateArchive& /*archive*/) {
        throw std::runtime_error("this integrator can't be checkpointed");
    }
    /// After any pass: saves what was learned for renders of scenes that are much like this one.
    /// Or takes it, after prepare() and before the first pass: it may only steer where samples go,
    /// must soon be outweighed by what is learned anew, and parts that don't fit are left out.
    /// Throws StateError if it is damaged or of another version; another exception if nothing is
    /// ever learned.
    virtual void learned(StateArchive& /*archive*/) {
        throw std::runtime_error("this integrator keeps nothing of what it learns");
    }
};

}  // namespace lxs
