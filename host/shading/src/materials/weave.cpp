// Weaves: which yarn lies on top where, and how it is bent there.
#include "weave.h"

#include <algorithm>
#include <cmath>

namespace lxs::shading {
namespace {

/// Remainder in [0, n).
int wrapped(int i, int n) {
    return (i % n + n) % n;
}

/// A row of steps along one axis of the repeat, in yarns: the first is `first` wide, others 1.
struct Steps {
    int count;
    float first;

    float total() const { return first + static_cast<float>(count - 1); }
    /// Where step i begins; i may lie beyond the repeat.
    float edge(int i) const {
        const int k = wrapped(i, count), repeats = (i - k) / count;
        const float within = k == 0 ? 0.0f : first + static_cast<float>(k - 1);
        return static_cast<float>(repeats) * total() + within;
    }
    /// Step that holds `position` in [0, total).
    int at(float position) const {
        if (position < first) return 0;
        return std::min(1 + static_cast<int>(position - first), count - 1);
    }
};

/// Place in the repeat, in [0, 1).
float within_repeat(float x) {
    const float part = x - std::floor(x);
    return part >= 0 && part < 1 ? part : 0.0f;
}

/// `position` on [low, high] as -1 to 1.
float centred(float position, float low, float high) {
    return std::clamp((2 * position - low - high) / (high - low), -1.0f, 1.0f);
}

}  // namespace

bool Weave::warp_on_top(int end, int pick) const {
    return wrapped(end - shift * wrapped(pick, ends), ends) < up;
}

WovenPlace locate_in_weave(const Weave& weave, float x, float y) {
    const Steps warps{weave.ends, 1}, picks{weave.ends, weave.thick_pick};
    const float u = within_repeat(x) * warps.total(), v = within_repeat(y) * picks.total();
    const int end = warps.at(u), pick = picks.at(v);
    WovenPlace place;
    place.warp = weave.warp_on_top(end, pick);
    // The part goes on until the other yarn crosses above, which it does within the repeat.
    int first = place.warp ? pick : end, last = first + 1;
    const auto shows = [&](int i) {
        return (place.warp ? weave.warp_on_top(end, i) : weave.warp_on_top(i, pick)) == place.warp;
    };
    while (shows(first - 1))
        --first;
    while (shows(last))
        ++last;
    const Steps &lengthwise = place.warp ? picks : warps, &sideways = place.warp ? warps : picks;
    const int side = place.warp ? end : pick;
    const float low = lengthwise.edge(first), high = lengthwise.edge(last);
    const float left = sideways.edge(side), right = sideways.edge(side + 1);
    place.along = centred(place.warp ? v : u, low, high);
    place.across = centred(place.warp ? u : v, left, right);
    place.length = (high - low) / (right - left);
    return place;
}

}  // namespace lxs::shading
