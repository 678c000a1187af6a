// Is every radius that a study compares at least four times that of its references?
#include "radius_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace bench {
namespace {

constexpr double kLargestShare = 0.25;

/// Largest world-space radius of the scene's references; 0 without radius.
double reference_radius(const Json& scene) {
    double largest = 0;
    if (scene.at("reference").is_null()) return largest;
    for (const auto& [name, image] : scene.at("reference").at("images").items()) {
        const Json radius = image.value("radius", Json());
        if (radius.is_number()) largest = std::max(largest, radius.get<double>());
    }
    return largest;
}

/// Smallest world-space radius that a run of the scene ended with.
double smallest_radius(const Json& runs, const std::string& scene) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Json& run : runs) {
        if (run.at("status") != "done" || run.at("settings").at("scene") != scene) continue;
        const double radius = run.at("integrator_statistics").value("radius", 0.0);
        if (radius > 0) smallest = std::min(smallest, radius);
    }
    return smallest;
}

}  // namespace

std::vector<std::string> radius_warnings(const Json& summary) {
    std::vector<std::string> warnings;
    for (const Json& scene : summary.at("scenes")) {
        const std::string name = scene.at("name");
        const double reference = reference_radius(scene);
        const double smallest = smallest_radius(summary.at("runs"), name);
        if (reference <= kLargestShare * smallest) continue;
        warnings.push_back(
            fmt::format("{}: the references' radius {:.4g} is more than a quarter "
                        "of the smallest one compared, {:.4g}",
                        name, reference, smallest));
    }
    return warnings;
}

}  // namespace bench
