// Registers "aips" with LuxRender as the shared object is loaded.
#include "lux_renderer.h"

#include "dynload.h"

namespace {

const lux::DynamicLoader::RegisterRenderer<aips::luxrender::LuxRenderer> kRenderer("aips");
const lux::DynamicLoader::RegisterSurfaceIntegrator<aips::luxrender::LuxIntegrator> kIntegrator(
    "aips");

}  // namespace
