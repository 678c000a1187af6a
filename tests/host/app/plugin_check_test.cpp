// Protects the host from modules whose declarations can't be right: each mistake has its message,
// before anything is done with what was declared.
#include "lxs/host/plugin_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "lxs/host/failure.h"

namespace lxs::test::plugin_check_test {
namespace {

using testing::HasSubstr;

std::unique_ptr<Integrator> create(const ParameterReader& /*parameters*/) {
    return {};
}

/// What the check says of a module with these integrators; empty if it has no objection.
std::string objection(std::span<const IntegratorPlugin> integrators) {
    const PluginModule module{kAbiVersion, "test", integrators};
    try {
        check_module(&module, "some.so");
        return {};
    } catch (const PluginFailure& failure) {
        return failure.what();
    }
}

std::string objection(std::span<const ParameterDeclaration> parameters) {
    const IntegratorPlugin plugin{"mine", "doc", parameters, &create};
    return objection(std::span(&plugin, 1));
}

std::string objection(const ParameterDeclaration& parameter) {
    return objection(std::span(&parameter, 1));
}

ParameterDeclaration named(std::string_view name) {
    ParameterDeclaration parameter;
    parameter.name = name;
    return parameter;
}

ParameterDeclaration with_default(ParameterType type, std::string_view text) {
    ParameterDeclaration parameter = named("a");
    parameter.type = type;
    parameter.default_text = text;
    return parameter;
}

/// A span or text of absurd size over memory that nobody may read.
template <class T>
std::span<const T> absurd() {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): no object is there
    return {reinterpret_cast<const T*>(std::uintptr_t{64}), std::size_t{1} << 40};
}

TEST(PluginCheck, ModuleWithoutDescription) {
    EXPECT_THROW(check_module(nullptr, "some.so"), PluginFailure);
}

TEST(PluginCheck, AnotherAbiVersionIsSeenBeforeAnythingElseIsRead) {
    const PluginModule module{kAbiVersion - 1, {}, absurd<IntegratorPlugin>()};
    EXPECT_THROW(check_module(&module, "some.so"), PluginFailure);
}

TEST(PluginCheck, Integrators) {
    EXPECT_THAT(objection(absurd<IntegratorPlugin>()), HasSubstr("its list of integrators has "));
    EXPECT_THAT(objection(std::span<const IntegratorPlugin>(
                    static_cast<const IntegratorPlugin*>(nullptr), 2)),
                HasSubstr("its list of integrators has 2 entries"));
    const IntegratorPlugin nameless[] = {{"", "doc", {}, &create}};
    EXPECT_THAT(objection(nameless), HasSubstr("without a usable name"));
    const IntegratorPlugin unprintable[] = {{"a\nb", "doc", {}, &create}};
    EXPECT_THAT(objection(unprintable), HasSubstr("without a usable name"));
    const IntegratorPlugin twins[] = {{"a", "doc", {}, &create}, {"a", "doc", {}, &create}};
    EXPECT_THAT(objection(twins), HasSubstr("offers integrator \"a\" twice"));
    const IntegratorPlugin barren[] = {{"a", "doc", {}, nullptr}};
    EXPECT_THAT(objection(barren), HasSubstr("has no create function"));
    const std::string_view endless(absurd<char>().data(), absurd<char>().size());
    const IntegratorPlugin rambling[] = {{"a", endless, {}, &create}};
    EXPECT_THAT(objection(rambling), HasSubstr("its description has 1099511627776 bytes"));
    const IntegratorPlugin endlessly_named[] = {{endless, "doc", {}, &create}};
    EXPECT_THAT(objection(endlessly_named), HasSubstr("without a usable name"));
}

TEST(PluginCheck, ParameterNames) {
    EXPECT_THAT(objection(absurd<ParameterDeclaration>()),
                HasSubstr("its list of parameters has 1099511627776 entries"));
    EXPECT_THAT(objection(named("")), HasSubstr("declares a parameter without a usable name"));
    EXPECT_THAT(objection(named({})), HasSubstr("declares a parameter without a usable name"));
    const ParameterDeclaration twins[] = {named("a"), named("b"), named("a")};
    EXPECT_THAT(objection(twins), HasSubstr("parameter \"a\" is declared twice"));
}

TEST(PluginCheck, Ranges) {
    ParameterDeclaration reversed = named("a");
    reversed.minimum = 2;
    reversed.maximum = 1;
    EXPECT_THAT(objection(reversed), HasSubstr("has no values: its range is from 2 to 1"));
    ParameterDeclaration no_number = named("a");
    no_number.minimum = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(objection(no_number), HasSubstr("has no values: its range is from nan"));
}

TEST(PluginCheck, TypesAndChoices) {
    ParameterDeclaration unknown = named("a");
    unknown.type = static_cast<ParameterType>(99);
    EXPECT_THAT(objection(unknown), HasSubstr("is of no known type"));
    ParameterDeclaration endless = named("a");
    endless.choices = absurd<std::string_view>();
    EXPECT_THAT(objection(endless), HasSubstr("its list of choices has 1099511627776 entries"));
    const std::string_view choices[] = {"one", {}};
    ParameterDeclaration nameless = named("a");
    nameless.choices = choices;
    EXPECT_THAT(objection(nameless), HasSubstr("has a choice without a usable name"));
}

TEST(PluginCheck, DefaultsThatTheParameterItselfWouldRefuse) {
    EXPECT_THAT(objection(with_default(ParameterType::Float, "many")),
                HasSubstr("has a default that it would not take: \"many\""));
    EXPECT_THAT(objection(with_default(ParameterType::Bool, "yes")), HasSubstr("would not take"));
    ParameterDeclaration small = with_default(ParameterType::Integer, "9");
    small.maximum = 8;
    EXPECT_THAT(objection(small), HasSubstr("would not take"));
    const std::string_view choices[] = {"one", "two"};
    ParameterDeclaration chosen = with_default(ParameterType::String, "three");
    chosen.choices = choices;
    EXPECT_THAT(objection(chosen), HasSubstr("would not take"));
    chosen.default_text = "two";
    EXPECT_EQ(objection(chosen), "");
    EXPECT_EQ(objection(with_default(ParameterType::Float, "-1.5e3")), "");
    EXPECT_EQ(objection(with_default(ParameterType::Float, "")), "");
    EXPECT_EQ(objection(with_default(ParameterType::Color, "0.5 0.5 0.5")), "");
}

}  // namespace
}  // namespace lxs::test::plugin_check_test
