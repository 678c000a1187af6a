// Stands for the Bsdf of a visible point that another rank has.
#pragma once

#include "aips/adapter/bsdf.h"

namespace aips {

/// Tells that the point has one. To ask it anything else is a mistake of ours: it throws
/// std::logic_error.
const Bsdf* foreign_bsdf();

}  // namespace aips
