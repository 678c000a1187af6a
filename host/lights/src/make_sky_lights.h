// Makes the sun and the sky from their scene statements.
#pragma once

#include "light_statement.h"

namespace lxs {

/// Makes what the light plugin's name asks for: sun, sky, sunsky, sky2 or sunsky2.
void make_sky_lights(const LightStatement& s, Lights& lights);

}  // namespace lxs
