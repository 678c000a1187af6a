// Settings of the integrator `path`: declaration, defaults, parsing, printing.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "lxs/sdk/parameters.h"

namespace lxs {

/// How a path's end is chosen at random before maxdepth.
enum class RouletteStrategy : std::uint8_t {
    Efficiency,   ///< go on with the probability min(1, largest channel of the throughput)
    Probability,  ///< go on with a fixed probability
    None
};

/// Which lights a vertex asks for direct light.
enum class LightStrategy : std::uint8_t {
    All,      ///< every light
    Uniform,  ///< one, all equally likely
    Power,    ///< one, in proportion to its power
    Learned,  ///< one, by what shadow rays found at such places in earlier passes
    LogPower  ///< one, in proportion to log(1 + power)
};

struct PathSettings {
    std::uint32_t max_depth = 16;  ///< most bounces of a path; straight passage is no bounce
    /// Bounces from purely specular surfaces that do not count for max_depth.
    std::uint32_t specular_bounces = 0;
    RouletteStrategy roulette = RouletteStrategy::Efficiency;
    float continue_probability = 0.65f;  ///< of RouletteStrategy::Probability
    bool include_environment = true;     ///< the camera sees lights at infinity directly
    bool direct_light_sampling = true;
    LightStrategy lights = LightStrategy::Learned;

    static std::span<const ParameterDeclaration> declarations();
    static PathSettings read(const ParameterReader& parameters);
    /// One line for the log.
    std::string text() const;
};

}  // namespace lxs
