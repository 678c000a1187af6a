// Uniform directions and caps.
#include "direction_proposal.h"

namespace aips {
namespace {

/// Sizes of the caps around a pilot.
constexpr int kCapSizes = 6;

}  // namespace

double DirectionProposal::extent(int size) {
    return 0.2 * std::pow(10.0, -size);
}

Vec3 DirectionProposal::sample(RandomStream& random) const {
    const Vec2 u = random.next2();
    const float choice = random.next();
    if (pilots_.empty() || choice < 0.5f) return square_to_uniform_sphere(u);
    const std::size_t caps = pilots_.size() * kCapSizes;
    const std::size_t cap = std::min(caps - 1, std::size_t((2 * choice - 1) * float(caps)));
    const double below = extent(int(cap % kCapSizes)) * double(u.x);  // 1 - cosine
    const double sine = std::sqrt(below * (2 - below));
    const float phi = 2 * kPi * u.y;
    const Vec3 local{float(sine) * std::cos(phi), float(sine) * std::sin(phi), float(1 - below)};
    return normalize(Frame(pilots_[cap / kCapSizes]).to_world(local));
}

double DirectionProposal::pdf(Vec3 direction) const {
    const double uniform = 0.25 / double(kPi);
    if (pilots_.empty()) return uniform;
    double density = 0;
    for (const Vec3 pilot : pilots_) {
        // 1 - cosine, exact also for close directions.
        const double below = 0.5 * double(length_squared(direction - pilot));
        for (int size = 0; size < kCapSizes; ++size) {
            if (below < extent(size)) density += 1 / extent(size);
        }
    }
    return 0.5 * uniform + 0.5 * density / (2 * double(kPi) * double(pilots_.size() * kCapSizes));
}

}  // namespace aips
