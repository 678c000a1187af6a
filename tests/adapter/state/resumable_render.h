// A render that can be interrupted between passes and gone on with in a new engine.
#pragma once

#include <memory>
#include <ostream>

#include "memory_archive.h"
#include "render_mock.h"

namespace mock {

/// A scene, how it is rendered, and for how many passes.
struct ResumableCase {
    std::string name;
    aips::Settings settings;
    bool fog = false;
    unsigned passes = 5;
    std::uint32_t width = 20, height = 15;
    bool wide = false;   ///< a patch of a wide ground, which few photon paths reach
    bool lamps = false;  ///< a room in which images of a lamp are seen
    float moved = 0;     ///< by so much lies one of the lamps elsewhere
    bool another_lamp = false;
    bool open = false;   ///< a room open to the sky, of which photons bring little
    bool gloss = false;  ///< a room with glass, gloss and a point light
};

/// For messages of tests.
inline std::ostream& operator<<(std::ostream& out, const ResumableCase& what) {
    return out << what.name;
}

/// Everything that such a render has: built anew for each.
class ResumableRender {
  public:
    /// `ranks`: with which it renders; null: alone.
    explicit ResumableRender(const ResumableCase& what, aips::Ranks* ranks = nullptr);
    /// Goes on from what was saved; `film` is what it had been given until then.
    ResumableRender(const ResumableCase& what, std::span<const std::byte> state, const Film& film,
                    aips::Ranks* ranks = nullptr);

    /// The pass that comes next.
    void render_pass() { engine_->render_pass(engine_->statistics().passes); }
    void render_to(std::uint64_t passes) {
        while (engine_->statistics().passes < passes)
            render_pass();
    }
    Bytes save();
    /// What was learned, for other renders; or taken from another, before the first pass.
    Bytes save_learned();
    void take_learned(std::span<const std::byte> learned);
    const Film& film() const { return film_; }
    const Log& log() const { return log_; }
    aips::EngineStatistics statistics() const { return engine_->statistics(); }

  private:
    View view_;
    Sampler sampler_;
    Film film_;
    Log log_;
    std::unique_ptr<aips::Engine> engine_;
};

/// Modes with guides, radii, samplers, media, layers: all that states consist of.
std::vector<ResumableCase> resumable_cases();

}  // namespace mock
