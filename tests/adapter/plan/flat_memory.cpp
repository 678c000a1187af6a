// Whether an engine's memory stays within its bound and flat from pass to pass.
#include "flat_memory.h"

#include <gtest/gtest.h>

namespace mock {

using namespace aips;

EngineStatistics expect_flat_memory(const Scene& scene, const aips::Camera& camera,
                                    std::uint32_t width, std::uint32_t height,
                                    const Settings& settings, unsigned settled) {
    const Sampler sampler(1);
    Film film(width, height);
    Log log;
    Engine engine({scene, camera, sampler, film, log}, settings);
    for (std::uint64_t pass = 0; pass < settled; ++pass)
        engine.render_pass(pass);
    const auto early = engine.statistics();
    for (std::uint64_t pass = settled; pass < settled + 24; ++pass)
        engine.render_pass(pass);
    EngineStatistics late = engine.statistics();
    EXPECT_LE(late.memory_bytes, late.memory_bound_bytes);
    EXPECT_LE(double(late.memory_bytes), 1.02 * double(early.memory_bytes));
    return late;
}

}  // namespace mock
