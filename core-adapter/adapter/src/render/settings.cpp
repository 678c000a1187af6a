// Checks and description of the engine's settings.
#include "aips/adapter/settings.h"

#include <stdexcept>

#include "aips/adapter/settings_table.h"

namespace aips {
namespace {

/// Whether a number is one that a user may give; other values always are.
bool in_range(const SettingRow& row, const Settings& settings) {
    const auto in_range = [&](auto member) {
        using Value = std::remove_cvref_t<decltype(settings.*member)>;
        if constexpr (!std::is_arithmetic_v<Value> || std::is_same_v<Value, bool>) return true;
        const auto value = static_cast<double>(settings.*member);
        return value >= row.minimum && value <= row.maximum;
    };
    return std::visit(in_range, row.member);
}

}  // namespace

void validate(const Settings& s) {
    for (const SettingRow& row : setting_rows()) {
        if (!is_default(row, s) && !in_range(row, s))
            throw std::invalid_argument(std::string(row.name) + " is " + text_of(row, s) +
                                        ": out of its range");
    }
    if (s.photon_sampler == PhotonSampler::AdaptiveChains && s.guide != GuideKind::None) {
        throw std::invalid_argument("photonsampler amc needs guide none");
    }
}

std::string describe(const Settings& s) {
    std::string text;
    for (const SettingRow& row : setting_rows()) {
        if (row.matters && !row.matters(s)) continue;
        const bool unchanged = is_default(row, s);
        const bool always = row.group == SettingGroup::First || row.group == SettingGroup::Paper;
        if (unchanged && !always) continue;
        const bool automatic = unchanged && !row.automatic.empty();
        text += text.empty() ? "" : ", ";
        text += std::string(row.name) + " = " +
                (automatic ? std::string(row.automatic) : text_of(row, s));
    }
    return text;
}

}  // namespace aips
