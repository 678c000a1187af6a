// The engine: adaptive importance photon shooting as a pass loop on abstract host types.
//
// References: Liu & Zheng 2014 (guidance), Knaus & Zwicker 2011 (progressive radius), Hachisuka,
// Ogaki & Jensen 2008 (a radius per visible point), Hachisuka & Jensen 2009 (eye paths renewed in
// each pass), Jensen 1996 (photon mapping).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "aips/adapter/camera.h"
#include "aips/adapter/ranks.h"
#include "aips/adapter/scene.h"
#include "aips/adapter/settings.h"
#include "aips/adapter/transport_statistics.h"
#include "aips/core/base/state_archive.h"

namespace aips {

/// The host's parts; they outlive the engine.
struct Host {
    const Scene& scene;
    const Camera& camera;
    const Sampler& sampler;
    Film& film;
    Log& log;
    /// With which this process renders; null: alone. All have the same scene and settings; each
    /// gets all of the image, and films that need it not may drop it.
    Ranks* ranks = nullptr;
};

/// What one pass did.
struct PassReport {
    std::uint64_t photon_paths = 0;
    std::uint64_t rays = 0;
    std::uint32_t eye_paths = 0;
    /// Of the density estimate, scene units (mode=ppm: mean over the visible points); 0 when no
    /// photons were shot.
    float radius = 0;
};

/// Totals of a render so far.
struct EngineStatistics {
    std::uint64_t passes = 0;
    std::uint64_t eye_paths = 0;
    std::uint64_t eye_rays = 0;  ///< shadow rays and emitter_rays included
    /// Eye paths that went on from their visible points, for the image or to learn what that brings
    std::uint64_t continued_paths = 0;
    /// Share of the light that eye paths and photons both can carry to visible points which eye
    /// paths now do
    double eye_share = 0;
    std::uint64_t emitter_paths = 0;     ///< drawn through images of emitters
    std::uint64_t emitter_searches = 0;  ///< for such images
    std::uint64_t emitter_rays = 0;      ///< of both
    std::uint64_t emitter_images = 0;    ///< known now
    std::uint64_t photon_paths = 0;
    std::uint64_t photon_rays = 0;
    std::uint64_t photons = 0;    ///< stored, but for those that shadow rays own
    std::uint64_t split_off = 0;  ///< guide=adaptive: photons that came from splitting others
    std::uint64_t gathered = 0;   ///< photon contributions to visible points
    std::uint64_t bounces = 0;
    std::uint64_t guided_bounces = 0;
    /// Markov chains: independent photon paths that measure which share reaches visible points
    std::uint64_t measured_paths = 0;
    /// Of these, those that did; where they weigh differently, as many of equal weight tell as much
    std::uint64_t visible_paths = 0;
    double mutation_size = 0;  ///< of Markov chains: see docs/understand/chains.md
    std::uint64_t guide_nodes = 0;
    std::uint64_t guide_bytes = 0;
    /// guide=adaptive: plain second moment times cost of emission over guided
    double emission_gain = 0;
    /// The same of roulette by score over that by power; 1 without it.
    double survival_gain = 0;
    /// guide=adaptive: second moment of directions without their tables over that with them
    double bounce_gain = 0;
    std::uint64_t bounce_tables = 0;  ///< guide=adaptive: tables of directions in use
    /// guide=adaptive: mean score of a photon path times its mean cost in rays, lately
    double score_times_cost = 0;
    /// guide=adaptive: photon paths that roulette by score ended, and that by power would not have
    std::uint64_t pruned_paths = 0;
    /// guide=adaptive: share of what the lights emit that now gets under a quarter of its photons
    double pruned_emission = 0;
    double eye_seconds = 0, photon_seconds = 0, gather_seconds = 0, guide_seconds = 0;
    double plan_seconds = 0;             ///< pilot pass, noise, pixels' weights
    float radius = 0;                    ///< of the last pass
    std::uint32_t photons_per_pass = 0;  ///< of the next pass that shoots
    std::size_t memory_bytes = 0;        ///< held by the engine now
    std::size_t memory_bound_bytes = 0;
    /// Contributions refused because they were not finite or negative, by origin: 'material "red"',
    /// 'light 3 (area)', or what dims light on its way.
    std::vector<std::pair<std::string, std::uint64_t>> refused;
    TransportStatistics transport;  ///< counts only if the settings ask for it
};

/// Renders one pass after another. The image is a pure function of (scene, settings, passes):
/// threads, ranks and their timing have no influence.
class Engine {
  public:
    /// Throws std::invalid_argument for settings that contradict each other. Logs the settings, the
    /// memory bound and what the scene does not need.
    Engine(const Host& host, const Settings& settings);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Renders pass number `pass` and adds it to the film; passes are rendered in order from 0.
    PassReport render_pass(std::uint64_t pass);
    EngineStatistics statistics() const;
    /// Between two passes: saves everything that later passes and the statistics rest on, but for
    /// the film, which is the host's. Or restores it, into a new engine with the same scene,
    /// settings and film size, instead of the passes that led to it: render_pass() then goes on
    /// with number statistics().passes, and the film gets the same bits as without an interruption.
    ///
    /// Throws StateError, with one clear message, if what is restored is damaged or belongs to
    /// other settings; the engine is then to be dropped. Nothing that is restored can make later
    /// passes take more memory than the bound. Frozen visible points are not saved but traced anew,
    /// which takes an eye pass. What is saved is a function of scene, settings and passes, but for
    /// its last kStateSecondsBytes, the times.
    void state(StateArchive& archive);
    /// After any pass: saves what was learned for renders of other scenes that are much like this
    /// one, as the next frame of an animation is. Or takes it, before the first pass.
    ///
    /// What was learned steers where samples go and no more: the expectation of the image stays as
    /// it is, whatever was taken. It counts for little, and what was decided by it is judged anew.
    /// Parts that fit nothing here (other lights, another film size) are left out; the log tells.
    /// Throws StateError if it is damaged or of another version; the engine is then to be dropped.
    void learned(StateArchive& archive);
    static constexpr std::size_t kStateSecondsBytes = 6 * sizeof(double);

  private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace aips
