// Statistics files of several renders of one scene, summed up.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lxs {

/// What renders of different seeds took and met, together. Counts and seconds are summed;
/// luminances are means, each render weighing as many samples per pixel as it has; of memory the
/// greatest is kept. docs/reference/command-line.md has the keys.
class StatisticsSums {
  public:
    /// Of the statistics file `name`, of lxsrender or of lxsmerge, its text. Throws MergeRefusal,
    /// and then holds what it held, if it is none, or if it is of no image of these seeds.
    void add(std::string_view text, const std::string& name,
             const std::vector<std::uint64_t>& seeds_of_images);

    /// After at least one add(); a file that holds it as "renders" may be added again.
    nlohmann::ordered_json merged() const;

  private:
    nlohmann::ordered_json sums_;
    std::map<std::uint64_t, std::string> seeds_;  ///< and the file that has it
};

}  // namespace lxs
