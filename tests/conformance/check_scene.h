// Renders a scene with one integrator and compares it with its reference.
#pragma once

#include <filesystem>

#include "conformance_table.h"

namespace conformance {

struct CheckSettings {
    Budget budget;
    std::filesystem::path renderer = LXSRENDER;
    unsigned threads = 0;        ///< 0: all processors
    std::filesystem::path keep;  ///< folder for the images, or nothing
};

/// A render that ends with an error gives a row that tells so.
Row check_scene(const Scene& scene, const std::string& integrator, const CheckSettings& settings);

}  // namespace conformance
