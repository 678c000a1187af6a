// The state of a render as the page of --serve gets it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lxs/host/budget.h"
#include "lxs/host/command_line.h"
#include "lxs/host/progress.h"
#include "lxs/host/render_session.h"

namespace lxs {

/// The estimated error after a pass.
struct ErrorPoint {
    double seconds = 0;
    double error = 0;  ///< ErrorEstimate::relative()
    std::uint64_t passes = 0;
};

/// The error over time, in at most some hundred points.
class ErrorCurve {
  public:
    /// Takes in the latest estimate, if it is a new one.
    void add(const RenderTotals& totals, const std::optional<ErrorEstimate>& estimate);
    const std::vector<ErrorPoint>& points() const { return points_; }

  private:
    std::vector<ErrorPoint> points_;
    std::uint64_t every_ = 1;  ///< estimates to a point
    std::uint64_t seen_ = 0;
    std::uint64_t last_passes_ = 0;
};

struct LiveState {
    const char* phase;    ///< preparing, rendering, paused, saving, ended
    std::string message;  ///< what there is to say at the end
    RenderTotals totals = {};
    std::optional<double> target_error = {};
    const ErrorCurve& curve;
    const std::vector<std::string>& layers;
    std::optional<TransportStatistics> transport = {};
};

/// One JSON object.
std::string live_state_json(const CommandLine& command, const RenderSession& session,
                            const Budget& budget, const LiveState& state);

}  // namespace lxs
