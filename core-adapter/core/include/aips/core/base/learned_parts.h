// What a render learned, in parts: another render takes those that belong there.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "aips/core/base/state_archive.h"

namespace aips {

/// Saves parts one after another, or reads them all and gives each to who asks for it by its name.
/// Of what is read nothing is trusted: StateError is thrown for what is damaged, as by
/// StateArchive. A part that nobody asks for, or that fits nothing, is left out without a word;
/// left_out() tells.
class LearnedParts {
  public:
    /// Describes a part by its state, both ways; restoring, it ends with what makes old knowledge
    /// old.
    using Describe = std::function<void(StateArchive&)>;

    /// `archive` outlives it. Throws StateError for what holds no parts.
    explicit LearnedParts(StateArchive& archive);

    /// Saves a part, or restores it if there is one of this name that was saved with this `fit`,
    /// which stands for all that both sides must have alike: whether it did. Once for each name,
    /// which has kLongestName letters at most.
    bool part(std::string_view name, std::uint64_t fit, const Describe& describe);
    /// After the last part.
    void end();

    bool restoring() const { return archive_.restoring(); }
    /// Names of the parts that were read, and taken; or not.
    std::vector<std::string> taken() const { return names(true); }
    std::vector<std::string> left_out() const { return names(false); }

    static constexpr std::size_t kLongestName = 32;

  private:
    struct Part {
        std::string name;
        std::uint64_t fit = 0;
        std::vector<std::byte> content;
        bool taken = false;
    };

    void state_of_part(Part& part);
    std::vector<std::string> names(bool taken) const;

    StateArchive& archive_;
    std::vector<Part> parts_;  // that were read
};

}  // namespace aips
