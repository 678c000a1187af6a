// Checks and description of the engine's settings.
#include "aips/adapter/settings.h"

#include <stdexcept>

#include "aips/adapter/settings_table.h"

namespace aips {
namespace {

/// Throws if a number that differs from the default is out of its range.
void check_range(const SettingRow& row, const Settings& settings) {
    constexpr Settings kDefaults;
    const auto check = [&](auto member) {
        using Value = std::remove_cvref_t<decltype(settings.*member)>;
        if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
            const Value value = settings.*member;
            if (value == kDefaults.*member) return;
            if (double(value) >= row.minimum && double(value) <= row.maximum) return;
            throw std::invalid_argument(std::string(row.name) + " is " + text_of(row, settings) +
                                        ": out of its range");
        }
    };
    std::visit(check, row.member);
}

bool is_default(const SettingRow& row, const Settings& settings) {
    constexpr Settings kDefaults;
    return std::visit([&](auto member) { return settings.*member == kDefaults.*member; },
                      row.member);
}

}  // namespace

void validate(const Settings& s) {
    for (const SettingRow& row : setting_rows())
        check_range(row, s);
    if (s.photon_sampler == PhotonSampler::AdaptiveChains && s.guide != GuideKind::None) {
        throw std::invalid_argument("photonsampler amc needs guide none");
    }
}

std::string describe(const Settings& s) {
    std::string text;
    for (const SettingRow& row : setting_rows()) {
        const bool automatic = !row.automatic.empty() && is_default(row, s);
        if (row.matters && !row.matters(s)) continue;
        if (row.group != SettingGroup::First && row.group != SettingGroup::Paper &&
            is_default(row, s))
            continue;
        text += text.empty() ? "" : ", ";
        text += std::string(row.name) + " = " +
                (automatic ? std::string(row.automatic) : text_of(row, s));
    }
    return text;
}

}  // namespace aips
