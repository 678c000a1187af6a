// One set of defaults: what the plugin says of a parameter, what it does without it, and what
// aips::Settings has are the same, parameter by parameter.
#include <gtest/gtest.h>

#include <algorithm>

#include "parameters.h"

namespace aips::defaults_test {
namespace {

using lxs::ParameterDeclaration;
using lxs::ParameterType;

class Silent final : public lxs::Diagnostics {
  public:
    void warning(const lxs::SourceLocation&, const std::string&) override {}
    void unknown_parameter(const lxs::SourceLocation&, const std::string& message) override {
        ADD_FAILURE() << message;
    }
};

Settings read(PluginKind kind, std::vector<lxs::ParameterValue> values) {
    lxs::ParameterSet set;
    set.values = std::move(values);
    Silent silent;
    return read_settings(kind, lxs::ParameterReader(set, parameter_declarations(kind), silent));
}

/// A declared parameter with a value that is written in a scene as `text`.
lxs::ParameterValue written(const ParameterDeclaration& d, const std::string& text) {
    lxs::ParameterValue value;
    value.name = d.name;
    if (d.type == ParameterType::Bool) {
        value.type = "bool";
        value.values = std::vector<bool>{text == "true"};
    } else if (d.type == ParameterType::String) {
        value.type = "string";
        value.values = std::vector<std::string>{text};
    } else {
        value.type = d.type == ParameterType::Integer ? "integer" : "float";
        value.values = std::vector<double>{std::stod(text)};
    }
    return value;
}

/// Some value that is not the default.
std::string another(const ParameterDeclaration& d) {
    if (d.type == ParameterType::Bool) return d.default_text == "true" ? "false" : "true";
    if (d.type == ParameterType::String) {
        return std::string(*std::find_if(d.choices.begin(), d.choices.end(),
                                         [&](auto c) { return c != d.default_text; }));
    }
    const double value = std::stod(std::string(d.default_text));
    if (d.type == ParameterType::Integer) return std::to_string(int(value) + 1);
    return std::to_string(value > 0 ? value / 2 : (d.minimum + std::min(d.maximum, 2.0)) / 2);
}

constexpr std::array kKinds{PluginKind::Aips, PluginKind::Sppm, PluginKind::Ppm,
                            PluginKind::ExPhotonMap};

TEST(Defaults, OfThePluginAreThoseOfTheSettings) {
    EXPECT_EQ(read(PluginKind::Aips, {}), Settings{});
    EXPECT_TRUE(adapts_radius(read(PluginKind::Aips, {})));
    EXPECT_TRUE(adapts_radius(Settings{}));
}

TEST(Defaults, AreWhatIsDeclaredOfEachParameter) {
    for (const PluginKind kind : kKinds) {
        for (const ParameterDeclaration& d : parameter_declarations(kind)) {
            if (d.no_effect || d.array) continue;
            Settings given = read(kind, {written(d, std::string(d.default_text))});
            // Who gives these wants a schedule of radii, even if it is the default's.
            if (d.name == "startradius" || d.name == "alpha") given.radius = read(kind, {}).radius;
            // Who gives a depth wants specular surfaces counted, even if it is the default's.
            if (d.name == "maxeyedepth") given.max_eye_depth = read(kind, {}).max_eye_depth;
            if (d.name == "maxphotondepth")
                given.max_photon_depth = read(kind, {}).max_photon_depth;
            EXPECT_EQ(given, read(kind, {}))
                << "plugin " << int(kind) << ": " << d.name << " " << d.default_text;
        }
    }
}

TEST(Defaults, EachParameterHasItsPlaceInTheSettings) {
    for (const PluginKind kind : kKinds) {
        for (const ParameterDeclaration& d : parameter_declarations(kind)) {
            if (d.no_effect) continue;
            std::vector<lxs::ParameterValue> values{written(d, another(d))};
            // Chains sample photons where no guide does.
            if (d.name == "photonsampler" && kind == PluginKind::Aips) {
                for (const ParameterDeclaration& guide : parameter_declarations(kind)) {
                    if (guide.name == "guide") values.push_back(written(guide, "none"));
                }
            }
            Settings without = read(kind, {values.begin() + 1, values.end()});
            EXPECT_NE(read(kind, values), without) << "plugin " << int(kind) << ": " << d.name;
        }
    }
}

TEST(Defaults, HaltonIsLuxRendersNameOfTheSobolSequence) {
    for (const PluginKind kind : {PluginKind::Aips, PluginKind::Sppm, PluginKind::Ppm}) {
        lxs::ParameterValue sampler;
        sampler.name = "photonsampler";
        sampler.type = "string";
        for (const std::string name : {"halton", "sobol"}) {
            sampler.values = std::vector{name};
            EXPECT_EQ(read(kind, {sampler}), read(kind, {}))
                << "plugin " << int(kind) << ": " << name;
        }
    }
}

TEST(Defaults, DisabledPartsAreThoseThatEachOneSwitchesOff) {
    lxs::ParameterValue disabled;
    disabled.name = "disable";
    disabled.type = "string";
    disabled.values = std::vector<std::string>{"guidechains", "learnlights"};
    Settings expected;
    expected.guide_chains = expected.learn_lights = false;
    EXPECT_EQ(read(PluginKind::Aips, {disabled}), expected);
}

TEST(Defaults, ARadiusOfOnesOwnHasItsSchedule) {
    Settings settings;
    settings.start_radius = 3;
    EXPECT_FALSE(adapts_radius(settings));
    settings = {};
    settings.alpha = 1;
    EXPECT_FALSE(adapts_radius(settings));
    settings = {};
    settings.guide = GuideKind::Paper;
    EXPECT_FALSE(adapts_radius(settings));
    settings.radius = RadiusKind::Adaptive;
    EXPECT_TRUE(adapts_radius(settings));
    for (const PluginKind kind : {PluginKind::Sppm, PluginKind::Ppm, PluginKind::ExPhotonMap})
        EXPECT_FALSE(adapts_radius(read(kind, {})));
}

}  // namespace
}  // namespace aips::defaults_test
