// Layers of surfaces: random walks joined in the middle.
#include "layered_bsdf.h"

#include <algorithm>
#include <cmath>

#include "directions.h"

namespace lxs::shading {
namespace {

constexpr LobeMask kSpread = kDiffuse | kGlossy;
constexpr int kMaxSteps = 64;  // walks end by roulette long before
constexpr int kFirstRoulette = 3;

Transport adjoint(Transport transport) {
    return transport == Transport::Radiance ? Transport::Power : Transport::Radiance;
}

}  // namespace

float between_layers(float thickness, float cosine) {
    return std::exp(-thickness / std::max(std::abs(cosine), kMinCosine));
}

/// A walk about to meet a layer.
struct LayeredBsdf::Walk {
    int layer = 0;
    Vec3 out{0.0f};  ///< from the layer to where the walk comes from
    Rgb throughput{1.0f};
    bool straight = true;      ///< only passed undeviated so far
    bool spread = false;       ///< met a lobe that is no delta
    bool spread_back = false;  ///< was reflected by one
};

LayeredBsdf::LayeredBsdf(const Stack& stack, const Vec3& place, const Vec3& ng, const Vec3& ns)
    : stack_(stack), place_(place), ng_(ng), ns_(ns) {
    for (int i = 0; i < stack_.count; ++i) {
        if (stack_.layers[i]) lobes_ |= stack_.layers[i]->lobes();
    }
    if (stack_.count > 1 && (lobes_ & kSpread)) rest_ = lobes_ & kDiffuse ? kDiffuse : kGlossy;
}

bool LayeredBsdf::advance(Walk& walk, HashedNumbers& numbers, Transport transport,
                          LobeMask mask) const {
    const Bsdf* layer = stack_.layers[walk.layer];
    if (!layer) return false;
    BsdfSample sample;
    const Vec2 u = numbers.pair();
    if (!layer->sample(walk.out, u, numbers.next(), transport, mask, sample)) return false;
    walk.throughput *= sample.weight;
    if (is_black(walk.throughput)) return false;
    walk.straight = walk.straight && sample.straight;
    if (sample.lobe != kSpecular) {
        walk.spread = true;
        walk.spread_back = walk.spread_back || !sample.transmitted;
    }
    walk.out = -sample.wi;
    walk.layer += sample.wi.dot(ng_) > 0 ? -1 : 1;
    if (stack_.thickness > 0 && walk.layer >= 0 && walk.layer < stack_.count)
        walk.throughput *= between_layers(stack_.thickness, walk.out.dot(ns_));
    return true;
}

int LayeredBsdf::trace(const Vec3& w, HashedNumbers& numbers, Transport transport, bool backwards,
                       Walk* steps) const {
    Walk walk;
    walk.layer = entry(w);
    walk.out = w;
    int count = 0;
    while (count < kMaxSteps) {
        steps[count++] = walk;
        if (!advance(walk, numbers, transport, kAllLobes)) break;
        if (walk.layer < 0 || walk.layer >= stack_.count) break;
        if (backwards && walk.spread_back) break;  // would never be joined
        if (count < kFirstRoulette) continue;
        const float survival = std::min(0.95f, max_component(walk.throughput));
        if (!(numbers.next() < survival)) break;
        walk.throughput /= survival;
    }
    return count;
}

// A path is found by all pairs of walks that meet at one of its vertices; it is counted once, where
// it was last reflected by a lobe that is no delta, or, if none reflected it, where it last passed
// one. What comes after is drawn from the other end: rough interfaces are passed as they scatter.
Rgb LayeredBsdf::joined(const Walk& a, const Walk& b, Transport transport) const {
    if (a.layer != b.layer || !stack_.layers[a.layer]) return Rgb(0.0f);
    const bool reflects = same_side(a.out, b.out, ng_);
    if (reflects ? b.spread_back : a.spread_back || b.spread) return Rgb(0.0f);
    const Rgb f = stack_.layers[a.layer]->evaluate(a.out, b.out, transport, kSpread);
    return a.throughput * f * b.throughput;
}

Rgb LayeredBsdf::estimate_rest(const Vec3& wo, const Vec3& wi, Transport transport) const {
    HashedNumbers numbers;
    numbers.about(place_).about(wo).about(wi);
    std::array<Walk, kMaxSteps> forth, back;
    const int forth_count = trace(wo, numbers, transport, false, forth.data());
    const int back_count = trace(wi, numbers, adjoint(transport), true, back.data());
    const bool direct = entry(wo) == entry(wi);
    Rgb sum(0.0f);
    for (int i = 0; i < forth_count; ++i) {
        for (int j = 0; j < back_count; ++j) {
            if (i + j > 0 || !direct) sum += joined(forth[i], back[j], transport);
        }
    }
    return sum;
}

Rgb LayeredBsdf::evaluate(const Vec3& wo, const Vec3& wi, Transport transport,
                          LobeMask mask) const {
    Rgb sum(0.0f);
    const Bsdf* first = stack_.layers[entry(wo)];
    if (first && entry(wo) == entry(wi)) sum += first->evaluate(wo, wi, transport, mask);
    if (mask & rest_) sum += estimate_rest(wo, wi, transport);
    return sum;
}

LobeMask LayeredBsdf::drawn_lobes(int i, const Vec3& wo, LobeMask mask) const {
    const Bsdf* layer = stack_.layers[i];
    if (!layer) return 0;
    if (i == entry(wo)) return layer->lobes() & mask & kSpread;
    return mask & rest_ ? LobeMask(layer->lobes() & kSpread) : LobeMask(0);
}

LayeredBsdf::Choice LayeredBsdf::choose(const Vec3& wo, LobeMask mask) const {
    constexpr float kLeast = 0.1f, kCosine = 0.25f;  // keep all weights bounded
    Choice choice;
    float specular = 0, sum = 0;
    for (int i = 0; i < stack_.count; ++i) {
        if (const LobeMask drawn = drawn_lobes(i, wo, mask)) {
            choice.layer[i] = std::max(kLeast, max_component(stack_.layers[i]->albedo(wo, drawn)));
        }
        sum += choice.layer[i];
        if ((mask & lobes_ & kSpecular) && stack_.layers[i]) {
            const Rgb albedo = stack_.layers[i]->albedo(wo, kSpecular);
            specular = std::max({kLeast, specular, max_component(albedo)});
        }
    }
    if (mask & rest_) choice.cosine = kCosine * std::max(sum, kLeast);
    sum += choice.cosine;
    if (!(sum + specular > 0)) return choice;
    choice.specular = sum > 0 ? specular / (specular + sum) : 1.0f;
    for (float& share : choice.layer)
        share /= sum + specular;
    choice.cosine /= sum + specular;
    return choice;
}

float LayeredBsdf::cosine_density(const Vec3& wo, const Vec3& wi) const {
    const float side = stack_.transmits ? 0.5f : same_side(wo, wi, ng_) ? 1.0f : 0.0f;
    return side * std::abs(wi.dot(ns_)) * kInvPi;
}

bool LayeredBsdf::sample_cosine_lobe(const Vec3& wo, const Vec2& u, float u_side, Vec3& wi) const {
    const bool other_side = stack_.transmits && u_side < 0.5f;
    return sample_cosine(other_side ? -wo : wo, ng_, ns_, u, wi);
}

float LayeredBsdf::density(const Choice& choice, const Vec3& wo, const Vec3& wi,
                           LobeMask mask) const {
    float sum = choice.cosine > 0 ? choice.cosine * cosine_density(wo, wi) : 0;
    for (int i = 0; i < stack_.count; ++i) {
        if (choice.layer[i] > 0)
            sum += choice.layer[i] * stack_.layers[i]->pdf(wo, wi, drawn_lobes(i, wo, mask));
    }
    return sum;
}

float LayeredBsdf::pdf(const Vec3& wo, const Vec3& wi, LobeMask mask) const {
    return density(choose(wo, mask), wo, wi, mask);
}

bool LayeredBsdf::draw(const Choice& choice, const Vec3& wo, const Vec2& u, float u_lobe,
                       LobeMask mask, BsdfSample& sample) const {
    for (int i = 0; i < stack_.count; ++i) {
        const float share = choice.layer[i];
        if (u_lobe >= share) {
            u_lobe -= share;
            continue;
        }
        const LobeMask drawn = drawn_lobes(i, wo, mask);
        if (!stack_.layers[i]->sample(wo, u, clamp_to_unit(u_lobe / share), Transport::Power, drawn,
                                      sample))
            return false;
        if (i != entry(wo)) sample.lobe = rest_;
        return true;
    }
    if (!(choice.cosine > 0)) return false;
    sample.lobe = rest_;
    return sample_cosine_lobe(wo, u, u_lobe / choice.cosine, sample.wi);
}

bool LayeredBsdf::sample_specular(const Vec3& wo, HashedNumbers numbers, Transport transport,
                                  BsdfSample& sample) const {
    Walk walk;
    walk.layer = entry(wo);
    walk.out = wo;
    for (int i = 0; i < kMaxSteps; ++i) {
        if (!advance(walk, numbers, transport, kSpecular)) return false;
        if (walk.layer < 0 || walk.layer >= stack_.count) {
            const Vec3 wi = -walk.out;
            sample = {wi,           walk.throughput, 0, kSpecular, wo.dot(ng_) * wi.dot(ng_) < 0,
                      walk.straight};
            return true;
        }
    }
    return false;
}

bool LayeredBsdf::sample(const Vec3& wo, const Vec2& u, float u_lobe, Transport transport,
                         LobeMask mask, BsdfSample& sample) const {
    const Choice choice = choose(wo, mask);
    if (u_lobe < choice.specular) {
        HashedNumbers numbers;
        numbers.about(u.x).about(u.y).about(u_lobe);
        if (!sample_specular(wo, numbers, transport, sample)) return false;
        sample.weight /= choice.specular;
        return true;
    }
    BsdfSample drawn;
    if (!draw(choice, wo, u, u_lobe - choice.specular, mask, drawn)) return false;
    const float pdf = density(choice, wo, drawn.wi, mask);
    if (!(pdf > 0)) return false;
    const Rgb f = evaluate(wo, drawn.wi, transport, mask);
    sample = {drawn.wi,   f * (std::abs(drawn.wi.dot(ns_)) / pdf), pdf,
              drawn.lobe, wo.dot(ng_) * drawn.wi.dot(ng_) < 0,     false};
    return true;
}

Rgb LayeredBsdf::albedo(const Vec3& wo, LobeMask mask) const {
    Rgb sum(0.0f);
    for (int i = 0; i < stack_.count; ++i) {
        const LobeMask lobes = drawn_lobes(i, wo, mask) | (mask & kSpecular);
        if (stack_.layers[i]) sum += stack_.layers[i]->albedo(wo, lobes);
    }
    return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

}  // namespace lxs::shading
