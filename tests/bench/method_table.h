// Which methods there are: tests/bench/methods.json.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bench {

/// A way to render a scene. Overrides are "parameter=value" of the integrator.
struct Method {
    std::string name;
    std::string description;
    std::string integrator;
    std::string sampler;           ///< "": the scene's own
    std::vector<std::string> set;  ///< in every variant
    bool has_variants = true;      ///< false: without radius, one run counts in both variants
};

struct MethodTable {
    std::vector<Method> methods;
    std::vector<Method> references;  ///< what reference images are made with
    unsigned photons_per_pass = 0;   ///< given to every method that has variants
    double fixed_startradius = 0;    ///< of variant "fixed", in pixel footprints
};

inline constexpr const char* kFixed = "fixed";
inline constexpr const char* kShipped = "shipped";
inline constexpr const char* kAny = "any";

/// Throws StudyError.
MethodTable read_method_table(const std::filesystem::path& file);

/// The method of that name; throws StudyError listing those that there are.
const Method& find_method(const std::vector<Method>& methods, const std::string& name);

/// All overrides of a run as "integrator.parameter=value": the method's, photons per pass, the
/// variant's, then those of `more` (already in that form) that name its integrator.
std::vector<std::string> overrides(const MethodTable& table, const Method& method,
                                   const std::string& variant,
                                   const std::vector<std::string>& more);

/// Value of "startradius" among overrides in the form above.
std::optional<double> startradius(const std::vector<std::string>& overrides);

}  // namespace bench
