// Which methods there are: tests/bench/methods.json.
#include "method_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>

#include "study_file.h"

namespace bench {
namespace {

Method read_method(const Json& json) {
    Method method;
    method.name = json.at("name");
    method.description = json.at("description");
    method.integrator = json.at("integrator");
    method.sampler = json.value("sampler", "");
    method.set = json.value("set", std::vector<std::string>{});
    method.has_variants = json.value("variants", true);
    return method;
}

std::vector<Method> read_methods(const Json& list) {
    std::vector<Method> methods;
    for (const Json& json : list)
        methods.push_back(read_method(json));
    return methods;
}

}  // namespace

MethodTable read_method_table(const std::filesystem::path& file) {
    const Json json = read_json(file);
    try {
        return {read_methods(json.at("methods")), read_methods(json.at("references")),
                json.at("photons_per_pass"), json.at("fixed_startradius")};
    } catch (const Json::exception& error) {
        throw StudyError(fmt::format("'{}': {}", file.string(), error.what()));
    }
}

const Method& find_method(const std::vector<Method>& methods, const std::string& name) {
    std::vector<std::string> names;
    for (const Method& method : methods) {
        if (method.name == name) return method;
        names.push_back(method.name);
    }
    throw StudyError(fmt::format("unknown method \"{}\"; known: {}", name, fmt::join(names, ", ")));
}

std::vector<std::string> overrides(const MethodTable& table, const Method& method,
                                   const std::string& variant,
                                   const std::vector<std::string>& more) {
    const std::string prefix = method.integrator + '.';
    std::vector<std::string> all;
    const bool varied = method.has_variants && variant != kAny;
    // The last one counts: a method that has a number of its own keeps it.
    if (varied) all.push_back(fmt::format("{}photonperpass={}", prefix, table.photons_per_pass));
    for (const std::string& text : method.set)
        all.push_back(prefix + text);
    if (varied && variant == kFixed) {
        all.push_back(prefix + "alpha=1");
        all.push_back(fmt::format("{}startradius={}", prefix, table.fixed_startradius));
    }
    for (const std::string& text : more) {
        if (text.starts_with(prefix)) all.push_back(text);
    }
    return all;
}

std::optional<double> startradius(const std::vector<std::string>& overrides) {
    std::optional<double> radius;
    for (const std::string& text : overrides) {
        constexpr std::string_view kKey = ".startradius=";
        const auto at = text.find(kKey);
        if (at != std::string::npos) radius = std::strtod(text.c_str() + at + kKey.size(), nullptr);
    }
    return radius;
}

}  // namespace bench
