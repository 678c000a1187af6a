// The order of a host's check: surfaces, materials, lights.
#include "aips/adapter/host_validation.h"

#include "check_lights.h"
#include "check_materials.h"

namespace aips {

std::vector<HostFinding> validate_host(const Scene& scene, const HostValidationSettings& settings) {
    HostFindings findings;
    if (scene.light_groups() == 0) {
        findings.add({"scene", "light groups", "0", "at least 1"});
    }
    const MetSurfaces surfaces(scene, settings, findings);
    if (!surfaces.sound()) return findings.take();
    check_materials(scene, settings, surfaces, findings);
    check_lights(scene, settings, surfaces, findings);
    return findings.take();
}

}  // namespace aips
