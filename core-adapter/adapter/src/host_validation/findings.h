// What a check of a host has found so far, and the counts that findings are made from.
#pragma once

#include <string>
#include <vector>

#include "aips/adapter/host_validation.h"
#include "tolerances.h"

namespace aips {

/// 'light 3 "area"'.
std::string light_subject(const Scene& scene, LightIndex light);
/// 'material 2 "glass"'.
std::string material_subject(const Scene& scene, std::uint32_t material);
/// A number with three digits.
std::string figure(double value);

/// How often something was looked at, and how often it was wrong.
struct CheckStatistics {
    std::uint64_t looked = 0, wrong = 0;
    std::string example;  ///< of what was wrong, the first

    /// Returns `fine`. `describe` makes the example.
    template <class Describe>
    bool look(bool fine, const Describe& describe) {
        ++looked;
        if (!fine && wrong++ == 0) example = describe();
        return fine;
    }
    /// Whether more was wrong than the rounding of a sound host explains.
    bool over(double share) const { return wrong > 0 && double(wrong) > share * double(looked); }
    /// 'example (12 of 40)'.
    std::string text() const;
};

class HostFindings {
  public:
    void add(HostFinding finding) { all_.push_back(std::move(finding)); }
    /// Adds a finding where `statistics` has more wrong than `share`; whether it did.
    bool add_if_over(const CheckStatistics& statistics, double share, const std::string& subject,
                     const std::string& check, const std::string& expected);
    std::vector<HostFinding> take() { return std::move(all_); }

  private:
    std::vector<HostFinding> all_;
};

}  // namespace aips
