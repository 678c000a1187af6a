// Makes lights at a point whose intensity follows an image or a photometric file.
#pragma once

#include "light_statement.h"

namespace lxs {

/// A point or goniometric light with mapname, iesname or both (their product); `color` names the
/// parameter of its colour.
void make_goniometric(const LightStatement& s, Lights& lights);

/// Light "projection": an image thrown from one point to another.
void make_projection(const LightStatement& s, Lights& lights);

}  // namespace lxs
