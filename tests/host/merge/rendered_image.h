// An image as lxsrender writes it, for tests.
#pragma once

#include <cstdint>

#include "lxs/imaging/exr_image.h"

namespace lxs::test {

/// 3 x 2 pixels whose values are `value` (and standard errors `error`), after `samples` passes of
/// one sample per pixel with `seed`.
ExrImage rendered(std::uint64_t seed, int samples, float value, float error);

}  // namespace lxs::test
