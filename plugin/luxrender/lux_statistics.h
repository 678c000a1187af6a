// What LuxRender's console and interface show of a render by aips.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "lux.h"

#include "rendererstatistics.h"

namespace aips::luxrender {

class LuxStatistics final : public lux::RendererStatistics {
  public:
    LuxStatistics();
    ~LuxStatistics() override;

    std::atomic<std::uint64_t> passes{0}, photon_paths{0};
    std::atomic<unsigned> threads{1};

    bool has_slave_nodes() { return getSlaveNodeCount() > 0; }

  private:
    class Long;
    class Short;
    /// "12 passes, 3.4 M photon paths"
    std::string progress() const;

    double getEfficiency() override { return 0; }
    double getEfficiencyWindow() override { return 0; }
    unsigned getThreadCount() override { return threads; }
    void resetDerived() override {}
    void updateStatisticsWindowDerived() override {}
};

}  // namespace aips::luxrender
