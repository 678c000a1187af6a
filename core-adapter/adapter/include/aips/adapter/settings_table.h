// The table of settings: one row each, with all that is said of it. The plugin's parameters, their
// reading, ranges, reference page and the list of effective settings come from it, and so does the
// check that a saved render goes on with the same ones.
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "aips/adapter/settings.h"

namespace aips {

enum class SettingGroup : std::uint8_t {
    First,   ///< what a user may need first
    Expert,  ///< what the engine decides well where nothing is said
    Study,   ///< parts that can be switched off, all on; named by `disable`
    Paper    ///< of guide=paper alone
};

using SettingMember =
    std::variant<bool Settings::*, std::uint32_t Settings::*, std::uint64_t Settings::*,
                 double Settings::*, Mode Settings::*, GuideKind Settings::*,
                 RadiusKind Settings::*, CriterionKind Settings::*, NeighbourKind Settings::*,
                 PhotonSampler Settings::*>;

/// The most that a scene file's whole number may be: what a double holds exactly.
inline constexpr double kMostCount = 4294967295.0, kMostSeed = 9007199254740992.0;

struct SettingRow {
    std::string_view name;  ///< as scene files write it
    SettingMember member;
    SettingGroup group = SettingGroup::Expert;
    std::string_view doc;                            ///< one or two sentences, with the unit
    double minimum = 0, maximum = kMostCount;        ///< inclusive, of numbers a user may give
    std::span<const std::string_view> choices = {};  ///< by number of the enumeration
    std::span<const std::string_view> aliases = {};  ///< other names of these, in their order
    /// What to write for the default where that is not its number: the usual depth, or -1.
    std::string_view default_text = {};
    std::string_view automatic = {};  ///< what a default is called that the engine decides
    bool (*matters)(const Settings&) = nullptr;  ///< whether it has an effect; null: always
};

/// In the order in which a user reads them.
std::span<const SettingRow> setting_rows();

bool is_default(const SettingRow& row, const Settings& settings);

/// The value as a scene file would write it.
std::string text_of(const SettingRow& row, const Settings& settings);

}  // namespace aips
