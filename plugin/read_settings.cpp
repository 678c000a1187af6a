// The settings that a scene's parameters ask for.
#include <algorithm>

#include "aips/adapter/settings_table.h"
#include "parameters.h"

namespace aips {
namespace {

/// The value that the scene gives, in place of what stands there.
struct Read {
    const lxs::ParameterReader& in;
    const SettingRow& row;

    void operator()(bool& value) const { value = in.boolean(row.name, value); }
    void operator()(double& value) const { value = in.number(row.name, value); }
    /// -1 is the greatest number, as which a bound bounds nothing.
    template <class Integer>
    requires std::is_integral_v<Integer>
    void operator()(Integer& value) const { value = static_cast<Integer>(in.integer(row.name, 0)); }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    void operator()(Enumeration& value) const {
        const std::string choice = in.string(row.name, row.choices[std::size_t(value)]);
        auto number = std::ranges::find(row.choices, choice) - row.choices.begin();
        if (number == std::ssize(row.choices))
            number = std::ranges::find(row.aliases, choice) - row.aliases.begin();
        value = static_cast<Enumeration>(number);
    }
};

void read_disabled(const lxs::ParameterReader& in, Settings& s) {
    const std::vector<std::string> names = in.strings("disable");
    for (const SettingRow& row : setting_rows()) {
        if (row.group != SettingGroup::Study) continue;
        if (std::ranges::find(names, row.name) == names.end()) continue;
        s.*std::get<bool Settings::*>(row.member) = false;
    }
}

/// Who gives a radius, or how it falls, wants that one, even if it is the default's.
void follow_own_radius(const lxs::ParameterReader& in, Settings& s) {
    const bool own = in.given("startradius") || in.given("alpha");
    if (s.radius == RadiusKind::Automatic && own) s.radius = RadiusKind::Schedule;
    if (s.radius == RadiusKind::Adaptive && !adapts_radius(s)) {
        in.diagnostics().warning(in.where("radius"),
                                 "radius \"adaptive\" is ignored: it takes effect with mode "
                                 "\"progressive\"");
    }
}

/// A guide decides itself where photon paths go. A scene of LuxRender's sppm that asks for amc
/// renders under guides too: a warning, not an error.
void check_photon_sampler(const lxs::ParameterReader& in, Settings& s) {
    if (s.photon_sampler != PhotonSampler::AdaptiveChains || s.guide == GuideKind::None) return;
    s.photon_sampler = PhotonSampler::Sequence;
    in.diagnostics().warning(in.where("photonsampler"),
                             "photonsampler \"amc\" is ignored: the guide decides where photon "
                             "paths go; it takes effect with guide \"none\"");
}

}  // namespace

Settings defaults_of(PluginKind kind) {
    Settings settings;
    if (kind == PluginKind::Aips) return settings;
    settings.guide = GuideKind::None;
    settings.continue_eye_paths = false;
    settings.guide_emitters = false;
    settings.correct_edges = false;
    settings.photon_occlusion = false;
    settings.narrow_radii = false;
    settings.photons_per_pass = kUsualPhotonsPerPass;
    settings.radius = RadiusKind::Schedule;
    if (kind == PluginKind::Ppm) settings.mode = Mode::Ppm;
    if (kind == PluginKind::ExPhotonMap) settings.mode = Mode::PhotonMap;
    return settings;
}

Settings read_settings(PluginKind kind, const lxs::ParameterReader& parameters) {
    Settings settings = defaults_of(kind);
    for (const lxs::ParameterDeclaration& declared : parameter_declarations(kind)) {
        if (declared.no_effect || !parameters.given(declared.name)) continue;
        const auto row = std::ranges::find(setting_rows(), declared.name, &SettingRow::name);
        if (row == setting_rows().end()) continue;
        std::visit([&](auto member) { Read{parameters, *row}(settings.*member); }, row->member);
    }
    if (kind == PluginKind::Aips) read_disabled(parameters, settings);
    check_photon_sampler(parameters, settings);
    if (kind == PluginKind::Aips || kind == PluginKind::Sppm)
        follow_own_radius(parameters, settings);
    return settings;
}

}  // namespace aips
