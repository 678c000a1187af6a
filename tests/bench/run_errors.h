// The errors of a run's snapshots, put into its document.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "reference_store.h"

namespace bench {

/// References by scene, read once.
class ReferenceCache {
  public:
    explicit ReferenceCache(std::filesystem::path root) : root_(std::move(root)) {}
    /// Null if the scene has none. Throws StudyError.
    const References* find(const std::string& scene, const std::string& scene_sha1,
                           std::uint32_t width_px, std::uint32_t height_px = 0);

  private:
    std::filesystem::path root_;
    std::map<std::filesystem::path, std::optional<References>> known_;  ///< by their folder
};

/// Fills "error" of the snapshots, "references" and "at_budget" of a run that is done, from the
/// images below `folder`; with no references they become null. Returns false if the run was already
/// measured with these references.
bool measure_run(const std::filesystem::path& folder, const References* references, Json& run);

/// "at_budget" of a run whose snapshots are measured.
Json errors_at_budgets(const Json& run);

/// Index of the snapshot taken for a budget; nothing if there is none.
std::optional<std::size_t> snapshot_for(const Json& run, const std::string& clock, double budget_s);

}  // namespace bench
