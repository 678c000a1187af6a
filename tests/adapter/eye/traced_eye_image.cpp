// One eye pass by itself.
#include "traced_eye_image.h"

namespace mock {

aips::EyeImage traced_eye_image(const Scene& scene, const Camera& camera, std::uint32_t size,
                                std::uint32_t paths, const aips::Settings& settings,
                                const aips::EyeShares* shares) {
    const Sampler sampler(settings.seed);
    const aips::DirectLight direct(scene, false);
    aips::InvalidSampleFilter filter(scene);
    aips::EyeImage image;
    trace_eye_pass({scene, camera, sampler, direct, settings, size, size, paths, true, shares}, 0,
                   0, filter, image);
    return image;
}

}  // namespace mock
