// Settings of the integrator `path`.
#include "path/path_settings.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace lxs {
namespace {

/// Without maxdepth: what light needs through thirty panes.
constexpr std::uint32_t kUsualSpecularBounces = 64;

/// A value and what the scene language calls it.
template <class Value>
struct Named {
    std::string_view name;
    Value value;
};

// LuxRender's names, and `learned`. Its `importance` and its kin come down to a choice by power;
// `auto` leaves the choice to the renderer.
constexpr auto kLightStrategies = std::to_array<Named<LightStrategy>>({
    {"learned", LightStrategy::Learned},
    {"auto", LightStrategy::Learned},
    {"one", LightStrategy::Uniform},
    {"all", LightStrategy::All},
    {"importance", LightStrategy::Power},
    {"powerimp", LightStrategy::Power},
    {"allpowerimp", LightStrategy::All},
    {"autopowerimp", LightStrategy::Power},
    {"logpowerimp", LightStrategy::LogPower},
});
constexpr auto kRouletteStrategies = std::to_array<Named<RouletteStrategy>>({
    {"efficiency", RouletteStrategy::Efficiency},
    {"probability", RouletteStrategy::Probability},
    {"none", RouletteStrategy::None},
});

template <class Table>
constexpr auto names_of(const Table& table) {
    std::array<std::string_view, std::tuple_size_v<Table>> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = table[i].name;
    return names;
}
constexpr auto kLightStrategyNames = names_of(kLightStrategies);
constexpr auto kRouletteNames = names_of(kRouletteStrategies);

/// The reader has already refused names that are not in the table.
template <class Table>
auto value_of(const Table& table, std::string_view name) {
    for (const auto& [known, value] : table) {
        if (known == name) return value;
    }
    return table.front().value;
}

template <class Table, class Value>
std::string_view name_of(const Table& table, Value value) {
    for (const auto& [name, known] : table) {
        if (known == value) return name;
    }
    return {};
}

constexpr std::array kDeclarations = {
    ParameterDeclaration{.name = "maxdepth",
                         .type = ParameterType::Integer,
                         .default_text = "16",
                         .doc = "Most bounces of a path; passing straight through null materials "
                                "or architectural glass is no bounce. Unless it is given, the "
                                "first 64 at specular surfaces do not count.",
                         .minimum = 0,
                         .maximum = 1'000'000},
    ParameterDeclaration{.name = "rrstrategy",
                         .type = ParameterType::String,
                         .default_text = "efficiency",
                         .doc = "Russian roulette from the fourth bounce on: by the path's "
                                "throughput, with rrcontinueprob, or none.",
                         .choices = kRouletteNames},
    ParameterDeclaration{.name = "rrcontinueprob",
                         .type = ParameterType::Float,
                         .default_text = "0.65",
                         .doc = "Probability of going on, for rrstrategy probability.",
                         .minimum = 0.01,
                         .maximum = 1},
    ParameterDeclaration{.name = "includeenvironment",
                         .type = ParameterType::Bool,
                         .default_text = "true",
                         .doc = "The camera sees lights at infinity directly."},
    ParameterDeclaration{.name = "directlightsampling",
                         .type = ParameterType::Bool,
                         .default_text = "true",
                         .doc = "Next-event estimation at every bounce, combined with scattered "
                                "rays by multiple importance sampling; without it point, spot and "
                                "distant lights give no light."},
    ParameterDeclaration{.name = "lightstrategy",
                         .type = ParameterType::String,
                         .default_text = "auto",
                         .doc = "Lights asked at a bounce: one by what earlier passes found "
                                "there (learned, auto), all (also allpowerimp), one at random, one "
                                "by power (importance, powerimp, autopowerimp), one by the "
                                "logarithm of its power (logpowerimp).",
                         .choices = kLightStrategyNames},
    ParameterDeclaration{.name = "shadowraycount",
                         .type = ParameterType::Integer,
                         .default_text = "1",
                         .doc = "Shadow rays a light and bounce; always one.",
                         .minimum = 1,
                         .no_effect = true},
};

}  // namespace

std::span<const ParameterDeclaration> PathSettings::declarations() {
    return kDeclarations;
}

PathSettings PathSettings::read(const ParameterReader& parameters) {
    PathSettings settings;
    settings.max_depth =
        static_cast<std::uint32_t>(parameters.integer("maxdepth", settings.max_depth));
    // Who gives a depth wants that one, even if it is the default's.
    settings.specular_bounces = parameters.given("maxdepth") ? 0 : kUsualSpecularBounces;
    settings.roulette =
        value_of(kRouletteStrategies, parameters.string("rrstrategy", "efficiency"));
    settings.continue_probability =
        static_cast<float>(parameters.number("rrcontinueprob", settings.continue_probability));
    settings.include_environment =
        parameters.boolean("includeenvironment", settings.include_environment);
    settings.direct_light_sampling =
        parameters.boolean("directlightsampling", settings.direct_light_sampling);
    settings.lights = value_of(kLightStrategies, parameters.string("lightstrategy", "auto"));
    return settings;
}

std::string PathSettings::text() const {
    const std::string specular =
        specular_bounces ? fmt::format(" beside {} at specular surfaces", specular_bounces) : "";
    return fmt::format(
        "maxdepth {} bounces{}, rrstrategy {}, rrcontinueprob {}, includeenvironment {}, "
        "directlightsampling {}, lightstrategy {}",
        max_depth, specular, name_of(kRouletteStrategies, roulette), continue_probability,
        include_environment, direct_light_sampling, name_of(kLightStrategies, lights));
}

}  // namespace lxs
