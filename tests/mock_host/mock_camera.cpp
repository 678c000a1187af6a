// The mock host's pinhole camera.
#include "mock_camera.h"

namespace mock {

using namespace aips;

CameraRay Camera::generate(const CameraSample& sample, float time) const {
    const float x = 2 * sample.film.x / float(width_) - 1;
    const float y = 2 * sample.film.y / float(height_) - 1;
    CameraRay ray;
    ray.ray = {eye_, normalize(forward_ + right_ * x + down_ * y), time, nullptr};
    ray.spread = length(right_) / float(width_);
    return ray;
}

}  // namespace mock
