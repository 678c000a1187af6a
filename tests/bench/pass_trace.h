// What a render has done after a pass, and a record of it that stays small however long it runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// Sums over the passes done; times are of passes alone.
struct PassTotals {
    std::uint64_t passes = 0;
    double wall_s = 0, cpu_s = 0;
    std::uint64_t photon_paths = 0, rays = 0;
    double samples_per_pixel = 0;
    std::uint64_t resident_bytes = 0;  ///< after the pass
};

class PassTrace {
  public:
    static constexpr std::size_t kMostEntries = 256;

    /// Keeps every pass until there are too many, then every second one, and so on; always the
    /// last.
    void add(const PassTotals& totals);
    std::vector<PassTotals> entries() const;

  private:
    std::vector<PassTotals> kept_;
    PassTotals last_;
    std::uint64_t stride_ = 1;
};

}  // namespace bench
