// What photon paths contributed, and cost, from each of their vertices on: the suffix score.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contribution/constants.h"
#include "contribution/path_log.h"

namespace aips {

struct PathContribution {
    double score = 0;  ///< of all photons that came after
    double cost = 0;   ///< in rays
};

/// Of one iteration's log.
class PathContributions {
  public:
    /// `scores`: of the log's photons, which stay as they are as long as scores() is asked for.
    void measure(const PathLog& log, std::span<const double> scores);

    /// [path]: of the whole path.
    std::span<const PathContribution> paths() const { return paths_; }
    /// [vertex of the log]: of one of the photons that went on from there.
    std::span<const PathContribution> vertices() const { return vertices_; }
    /// Of a path's photons.
    std::span<const double> scores(const PathRecord& path) const {
        return scores_.subspan(path.first_photon, path.photons);
    }

    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() with so many paths of at most `depth` vertices.
    static std::size_t memory_bound_bytes(std::size_t paths, std::size_t depth);

  private:
    void measure_path(const PathLog& log, std::size_t number);

    std::span<const double> scores_;
    std::vector<PathContribution> paths_, vertices_;
};

}  // namespace aips
