// The engine as LuxRender's half of the shim sees it: passes, one after another. C++17.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lux_view.h"

namespace aips::luxrender {

/// A parameter of the scene file's SurfaceIntegrator statement.
struct GivenParameter {
    enum class Type { Float, Integer, Bool, String };
    Type type = Type::Float;
    std::string name;
    double number = 0;  ///< of a float, integer or bool
    std::string text;   ///< of a string
};

/// A parameter that the engine knows.
struct KnownParameter {
    GivenParameter::Type type = GivenParameter::Type::Float;
    std::string name;
};

/// All parameters that may be asked for; those of other types than these do not occur.
std::vector<KnownParameter> known_parameters();

/// A render in LuxRender's process.
class EngineRun {
  public:
    virtual ~EngineRun() = default;
    /// Renders the next pass into the film, by at most `threads` threads.
    virtual void render_pass(unsigned threads) = 0;
    virtual std::uint64_t photon_paths() const = 0;
    /// What the engine refused because it was not finite or negative, one line each.
    virtual std::vector<std::string> refused() const = 0;
};

/// `view` outlives the run. `passes_before`: those that a film which was resumed already has; what
/// follows has other random numbers than they had. Throws std::exception with one clear message for
/// parameters that are wrong or contradict each other.
std::unique_ptr<EngineRun> start_engine(LuxView& view, const std::vector<GivenParameter>& given,
                                        std::uint64_t passes_before);

}  // namespace aips::luxrender
