// What photon paths were worth, and cost, from each of their vertices on: the suffix score.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "worth/constants.h"
#include "worth/path_log.h"

namespace aips {

struct Worth {
    double score = 0;  ///< of all landings that came after
    double cost = 0;   ///< in rays
};

/// Of one iteration's log.
class PathWorths {
  public:
    /// `scores`: of the log's landings, which stay as they are as long as scores() is asked for.
    void measure(const PathLog& log, std::span<const double> scores);

    /// [path]: of the whole path.
    std::span<const Worth> paths() const { return paths_; }
    /// [vertex of the log]: of one of the photons that went on from there.
    std::span<const Worth> vertices() const { return vertices_; }
    /// Of a path's landings.
    std::span<const double> scores(const PathRecord& path) const {
        return scores_.subspan(path.first_landing, path.landings);
    }

    std::size_t memory_bytes() const;
    /// Upper bound of memory_bytes() with so many paths of at most `depth` vertices.
    static std::size_t memory_bound_bytes(std::size_t paths, std::size_t depth);

  private:
    void measure_path(const PathLog& log, std::size_t number);

    std::span<const double> scores_;
    std::vector<Worth> paths_, vertices_;
};

}  // namespace aips
