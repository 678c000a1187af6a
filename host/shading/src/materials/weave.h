// Weaves: which yarn lies on top where, and how it is bent there.
#pragma once

namespace lxs::shading {

/// A weave whose picks (rows of weft) each repeat the one below, shifted: plain weave, twills and
/// satins. As many warp ends as picks make the repeat. `up` neighbouring ends lie above the first
/// pick, and the same number above pick r, moved by `shift` * r ends to the right.
struct Weave {
    int ends = 2;             ///< yarns of either kind in the repeat
    int up = 1;               ///< 1 to ends - 1
    int shift = 1;            ///< the move, or counter, of the weave; shares no divisor with `ends`
    float thick_pick = 1.0f;  ///< height of the first pick; that of the others is 1

    /// Whether warp end `end` lies above pick `pick`; both may be any number.
    bool warp_on_top(int end, int pick) const;
};

/// A place on the part of a yarn that shows between the yarns that cross above it.
struct WovenPlace {
    bool warp = true;  ///< warp runs along v, weft along u
    float along = 0;   ///< -1 to 1 over the part's length, towards growing v or u
    float across = 0;  ///< -1 to 1 over its width, towards growing u or v
    float length = 1;  ///< of the part, in its widths
};

/// The place at `x`, `y`, which count repeats of the weave along u and v; zero if they are no
/// numbers.
WovenPlace locate_in_weave(const Weave& weave, float x, float y);

}  // namespace lxs::shading
