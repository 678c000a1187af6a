// Sums of optical constants, with which the textures that blend floats and colours blend them, too.
#pragma once

#include "lxs/scene/texture.h"

namespace lxs {

inline FresnelValue operator*(const FresnelValue& value, float weight) {
    return {value.eta * weight, value.k * weight, value.conductor};
}
/// A conductor has its part in every sum that names it.
inline FresnelValue operator+(const FresnelValue& a, const FresnelValue& b) {
    return {a.eta + b.eta, a.k + b.k, a.conductor || b.conductor};
}
inline FresnelValue& operator+=(FresnelValue& sum, const FresnelValue& term) {
    return sum = sum + term;
}

}  // namespace lxs
