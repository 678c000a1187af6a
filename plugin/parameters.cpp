// Declarations of all parameters, from the table of settings. Names follow LuxRender's sppm where
// it has one, so that a scene changes only the plugin's name.
#include "parameters.h"

#include <algorithm>
#include <array>
#include <deque>
#include <string>
#include <vector>

#include "aips/adapter/settings_table.h"

namespace aips {
namespace {

using lxs::ParameterDeclaration;
using lxs::ParameterType;

ParameterType type_of(const SettingMember& member) {
    const auto type = [](auto pointer) {
        using Value = std::remove_cvref_t<decltype(Settings{}.*pointer)>;
        if constexpr (std::is_same_v<Value, bool>) return ParameterType::Bool;
        if constexpr (std::is_enum_v<Value>) return ParameterType::String;
        return std::is_integral_v<Value> ? ParameterType::Integer : ParameterType::Float;
    };
    return std::visit(type, member);
}

/// Declarations refer to it for ever.
std::string_view kept(std::string text) {
    static std::deque<std::string> texts;
    return texts.emplace_back(std::move(text));
}

/// All that a scene may write: the choices, then their aliases.
std::span<const std::string_view> accepted(const SettingRow& row) {
    if (row.aliases.empty()) return row.choices;
    static std::deque<std::vector<std::string_view>> kept_lists;
    std::vector<std::string_view>& all =
        kept_lists.emplace_back(row.choices.begin(), row.choices.end());
    all.insert(all.end(), row.aliases.begin(), row.aliases.end());
    return all;
}

std::string_view heading_of(SettingGroup group) {
    switch (group) {
        case SettingGroup::First:
            return "First";
        case SettingGroup::Expert:
            return "Expert";
        case SettingGroup::Study:
            return "Parts, to be studied without; \"disable\" names several";
        case SettingGroup::Paper:
            break;
    }
    return "With guide paper";
}

ParameterDeclaration declaration_of(const SettingRow& row, PluginKind kind) {
    ParameterDeclaration d{row.name, type_of(row.member), kept(text_of(row, defaults_of(kind))),
                           row.doc};
    d.group = heading_of(row.group);
    if (d.type == ParameterType::Integer || d.type == ParameterType::Float) {
        d.minimum = row.minimum;
        d.maximum = row.maximum;
    }
    d.choices = accepted(row);
    return d;
}

/// Whether the plugin takes the setting: LuxRender's fix mode and guide, and take of our own parts
/// those that are of use to every photon mapper. exphotonmap has a maxdepth of its own in
/// LuxRender, which bounds the eye path.
bool takes(PluginKind kind, const SettingRow& row) {
    if (kind == PluginKind::Aips) return true;
    if (row.name == "mode" || row.name == "guide" || row.group == SettingGroup::Paper) return false;
    if (row.group == SettingGroup::Study)
        return row.name == "photonocclusion" || row.name == "learnlights";
    if (row.name == "radius") return kind == PluginKind::Sppm;
    const bool of_map = row.name != "maxdepth" && row.name != "photonsampler";
    return of_map || kind != PluginKind::ExPhotonMap;
}

constexpr std::string_view kRadiusOfSppm =
    "How the radius goes on: schedule, the same at all visible points, falling with the photons "
    "shot; adaptive, at each visible point the one that balances noise and bias, between an eighth "
    "of the scheduled and twice it (after Kaplanyan and Dachsbacher 2013).";

ParameterDeclaration disable_declaration() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const SettingRow& row : setting_rows()) {
            if (row.group == SettingGroup::Study) all.push_back(row.name);
        }
        return all;
    }();
    ParameterDeclaration d{"disable", ParameterType::String, "",
                           "Parts that are switched off, as if each were set to \"false\"."};
    d.group = heading_of(SettingGroup::Study);
    d.choices = names;
    d.array = true;
    return d;
}

constexpr ParameterDeclaration no_effect(std::string_view name, ParameterType type,
                                         std::string_view value, std::string_view doc) {
    ParameterDeclaration d{name, type, value, doc};
    d.group = "Without effect, known from LuxRender's scenes";
    d.no_effect = true;
    return d;
}

/// LuxRender's other sppm parameters: accepted so that its scenes load as they are.
std::vector<ParameterDeclaration> foreign_declarations() {
    using T = ParameterType;
    return {
        no_effect("useproba", T::Bool, "true",
                  "The integrator decides: a schedule (Knaus and Zwicker), in ppm the photons."),
        no_effect("lookupaccel", T::String, "hashgrid", "A hashed grid is always used."),
        no_effect("pixelsampler", T::String, "hilbert", "Pixels are always visited in rows."),
        no_effect("parallelhashgridspare", T::Float, "1", "Size of LuxRender's hash grid."),
        no_effect("wavelengthstratificationpasses", T::Integer, "8",
                  "Where wavelengths are needed they are stratified over all passes."),
        no_effect("schedulerblocksize", T::Integer, "0", "Size of LuxRender's work packets."),
        no_effect("startk", T::Integer, "30", "Neighbours of LuxRender's first estimate."),
        no_effect("debug", T::Bool, "false", "LuxRender's own debugging output."),
    };
}

/// LuxRender's parameters of exphotonmap that have no meaning here.
std::vector<ParameterDeclaration> foreign_map_declarations() {
    using T = ParameterType;
    return {
        no_effect("renderingmode", T::String, "directlighting", "Shadow rays plus photons."),
        no_effect("finalgather", T::Bool, "true", "Photons are seen directly."),
        no_effect("finalgathersamples", T::Integer, "32", "Photons are seen directly."),
        no_effect("causticphotons", T::Integer, "20000", "One map holds all photons."),
        no_effect("indirectphotons", T::Integer, "200000", "One map holds all photons."),
        no_effect("directphotons", T::Integer, "200000", "One map holds all photons."),
        no_effect("radiancephotons", T::Integer, "200000", "No radiance photons."),
        no_effect("nphotonsused", T::Integer, "50", "The radius is fixed."),
        no_effect("maxphotondist", T::Float, "0.1", "See startradius."),
        no_effect("maxdepth", T::Integer, "5", "See maxeyedepth."),
    };
}

std::vector<ParameterDeclaration> declarations_of(PluginKind kind) {
    std::vector<ParameterDeclaration> all;
    for (const SettingRow& row : setting_rows()) {
        if (!takes(kind, row)) continue;
        all.push_back(declaration_of(row, kind));
        // The choice that follows startradius and alpha is of aips alone.
        if (row.name == "radius" && kind == PluginKind::Sppm) {
            all.back().doc = kRadiusOfSppm;
            all.back().choices = row.choices.subspan(1);
        }
    }
    if (kind == PluginKind::Aips) {
        const auto part = std::ranges::find(all, "photonocclusion", &ParameterDeclaration::name);
        all.insert(part, disable_declaration());
    }
    const auto foreign =
        kind == PluginKind::ExPhotonMap ? foreign_map_declarations() : foreign_declarations();
    all.insert(all.end(), foreign.begin(), foreign.end());
    return all;
}

}  // namespace

std::span<const ParameterDeclaration> parameter_declarations(PluginKind kind) {
    static const std::array<std::vector<ParameterDeclaration>, 4> all{
        declarations_of(PluginKind::Aips), declarations_of(PluginKind::Sppm),
        declarations_of(PluginKind::Ppm), declarations_of(PluginKind::ExPhotonMap)};
    return all[static_cast<std::size_t>(kind)];
}

}  // namespace aips
