// Materials of the mock host.
#include "mock_bsdf.h"

#include <algorithm>
#include <new>

#include "aips/core/sampling/sampling.h"
#include "aips/parts/smooth_bsdfs.h"

namespace mock {
namespace {

using namespace aips;

/// A Lambert lobe that may hide what it is, or lie about its densities.
class Lambert final : public Bsdf {
  public:
    Lambert(Vec3 ng, Vec3 ns, Rgb kd, bool hide, std::optional<float> claimed_pdf = {})
        : lambert_(ng, ns, kd), hide_(hide), claimed_pdf_(claimed_pdf) {}

    LobeMask lobes() const override { return kDiffuse; }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const override {
        return lambert_.evaluate(wo, wi, transport, mask);
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        const float pdf = lambert_.pdf(wo, wi, mask);
        return pdf > 0 && claimed_pdf_ ? *claimed_pdf_ : pdf;
    }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& s) const override {
        if (!lambert_.sample(wo, u, u_lobe, transport, mask, s)) return false;
        s.pdf = pdf(wo, s.wi, mask);
        return true;
    }
    Rgb albedo(Vec3 wo, LobeMask mask) const override { return lambert_.albedo(wo, mask); }
    bool lambertian(Rgb& kd) const override { return lambert_.lambertian(kd) && !hide_; }

  private:
    LambertBsdf lambert_;
    bool hide_;
    std::optional<float> claimed_pdf_;
};

/// Passes light straight on.
class Null final : public Bsdf {
  public:
    LobeMask lobes() const override { return kSpecular; }
    Rgb evaluate(Vec3, Vec3, Transport, LobeMask) const override { return {}; }
    float pdf(Vec3, Vec3, LobeMask) const override { return 0; }
    bool sample(Vec3 wo, Vec2, float, Transport, LobeMask mask, BsdfSample& s) const override {
        s = {-wo, kWhite, 0, kSpecular, true};
        return mask & kSpecular;
    }
    Rgb albedo(Vec3, LobeMask mask) const override { return mask & kSpecular ? kWhite : Rgb{}; }
};

/// Modified Phong lobe, normalised so that its albedo is at most `ks`.
class Phong final : public OrientedBsdf {
  public:
    Phong(Vec3 ng, Vec3 ns, Rgb ks, float n) : OrientedBsdf(ng, ns), ks_(ks), n_(n) {}

    LobeMask lobes() const override { return kGlossy; }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport, LobeMask mask) const override {
        if (!(mask & kGlossy) || !same_side(wo, wi)) return {};
        const float c = std::max(0.0f, dot(reflect(wo), wi));
        return ks_ * ((n_ + 2) / (2 * kPi) * std::pow(c, n_));
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        if (!(mask & kGlossy) || !same_side(wo, wi)) return 0;
        return (n_ + 1) / (2 * kPi) * std::pow(std::max(0.0f, dot(reflect(wo), wi)), n_);
    }
    bool sample(Vec3 wo, Vec2 u, float, Transport t, LobeMask mask, BsdfSample& s) const override {
        if (!(mask & kGlossy)) return false;
        const float c = std::pow(u.x, 1 / (n_ + 1));
        const float r = std::sqrt(std::max(0.0f, 1 - c * c));
        const float phi = 2 * kPi * u.y;
        s.wi = Frame(reflect(wo)).to_world({r * std::cos(phi), r * std::sin(phi), c});
        s.pdf = pdf(wo, s.wi, mask);
        if (!(s.pdf > 0)) return false;
        s.weight = evaluate(wo, s.wi, t, mask) * (abs_dot(s.wi, ns_) / s.pdf);
        s.lobe = kGlossy;
        s.straight = false;
        return true;
    }
    Rgb albedo(Vec3, LobeMask mask) const override { return mask & kGlossy ? ks_ : Rgb{}; }

  private:
    Rgb ks_;
    float n_;
};

/// Diffuse paint under a perfect mirror film: the lobes that one eye path must choose between.
class LambertAndMirror final : public OrientedBsdf {
  public:
    LambertAndMirror(Vec3 ng, Vec3 ns, Rgb kd, Rgb kr)
        : OrientedBsdf(ng, ns), diffuse_(ng, ns, kd, true), mirror_(ng, ns, kr) {}

    LobeMask lobes() const override { return kDiffuse | kSpecular; }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport t, LobeMask mask) const override {
        return diffuse_.evaluate(wo, wi, t, mask);
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        return diffuse_probability(mask) * diffuse_.pdf(wo, wi, mask);
    }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport t, LobeMask mask,
                BsdfSample& s) const override {
        const float p = diffuse_probability(mask);
        const bool chosen = u_lobe < p;
        const bool ok =
            chosen ? diffuse_.sample(wo, u, 0, t, mask, s) : mirror_.sample(wo, u, 0, t, mask, s);
        const float choice = chosen ? p : 1 - p;
        s.weight = s.weight / choice;
        s.pdf *= choice;
        return ok;
    }
    Rgb albedo(Vec3 wo, LobeMask mask) const override {
        return diffuse_.albedo(wo, mask) + mirror_.albedo(wo, mask);
    }

  private:
    static float diffuse_probability(LobeMask mask) {
        if (!(mask & kDiffuse)) return 0;
        return mask & kSpecular ? 0.5f : 1.0f;
    }
    Lambert diffuse_;
    MirrorBsdf mirror_;
};

/// A sheet that is diffuse before and behind it, with a glossy lobe and a mirror unless they are
/// black. Each lobe that is asked for is drawn as often as the others; densities are those of all.
class Sheet final : public OrientedBsdf {
  public:
    Sheet(Vec3 ng, Vec3 ns, const Material& m)
        : OrientedBsdf(ng, ns),
          before_(ng, ns, m.reflectance, true),
          gloss_(ng, ns, m.glossy, m.exponent),
          mirror_(ng, ns, m.specular),
          behind_(m.transmittance),
          lobes_(LobeMask(kDiffuse | (is_black(m.glossy) ? 0 : kGlossy) |
                          (is_black(m.specular) ? 0 : kSpecular))) {}

    LobeMask lobes() const override { return lobes_; }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport t, LobeMask mask) const override {
        mask &= lobes_;
        if (!same_side(wo, wi)) return mask & kDiffuse ? behind_ * kInvPi : Rgb{};
        return before_.evaluate(wo, wi, t, mask) + gloss_.evaluate(wo, wi, t, mask);
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        mask &= lobes_;
        if (same_side(wo, wi))
            return (before_.pdf(wo, wi, mask) + gloss_.pdf(wo, wi, mask)) / count(mask);
        if (!(mask & kDiffuse)) return 0;
        return std::max(0.0f, -dot(wi, normal_towards(wo))) * kInvPi / count(mask);
    }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport t, LobeMask mask,
                BsdfSample& s) const override {
        mask &= lobes_;
        auto lobe = static_cast<int>(u_lobe * count(mask));
        if (!(mask & kDiffuse)) lobe += 2;
        if (lobe == 2 && !(mask & kGlossy)) ++lobe;
        if (lobe == 3) {
            const bool reflected = mirror_.sample(wo, u, 0, t, mask, s);
            s.weight = s.weight * count(mask);
            return reflected;
        }
        if (lobe == 0 && !before_.sample(wo, u, 0, t, mask, s)) return false;
        if (lobe == 2 && !gloss_.sample(wo, u, 0, t, mask, s)) return false;
        if (lobe == 1) s.wi = Frame(-normal_towards(wo)).to_world(square_to_cosine_hemisphere(u));
        if (same_side(wo, s.wi) != (lobe != 1)) return false;
        s.pdf = pdf(wo, s.wi, mask);
        s.weight = evaluate(wo, s.wi, t, mask) * (abs_dot(s.wi, ns_) / s.pdf);
        s.lobe = lobe == 2 ? kGlossy : kDiffuse;
        s.straight = false;
        return s.pdf > 0;
    }
    Rgb albedo(Vec3 wo, LobeMask mask) const override {
        return before_.albedo(wo, mask) + gloss_.albedo(wo, mask) + mirror_.albedo(wo, mask) +
               (mask & kDiffuse ? behind_ : Rgb{});
    }

  private:
    float count(LobeMask mask) const {
        mask &= lobes_;
        return float((mask & kDiffuse ? 2 : 0) + (mask & kGlossy ? 1 : 0) +
                     (mask & kSpecular ? 1 : 0));
    }
    Lambert before_;
    Phong gloss_;
    MirrorBsdf mirror_;
    Rgb behind_;
    LobeMask lobes_;
};

template <class T, class... Args>
const Bsdf* place(std::pmr::memory_resource& memory, Args... args) {
    return new (memory.allocate(sizeof(T), alignof(T))) T(args...);
}

}  // namespace

const aips::Bsdf* make_bsdf(const Material& m, aips::Vec3 ng, aips::Vec3 ns,
                            std::pmr::memory_resource& memory) {
    switch (m.kind) {
        case Material::Kind::Lambert:
            return place<Lambert>(memory, ng, ns, m.reflectance, m.hide_lambert, m.claimed_pdf);
        case Material::Kind::Mirror:
            return place<MirrorBsdf>(memory, ng, ns, m.reflectance);
        case Material::Kind::Glass:
            return place<GlassBsdf>(memory, ng, ns, m.index);
        case Material::Kind::Null:
            return place<Null>(memory);
        case Material::Kind::Phong:
            return place<Phong>(memory, ng, ns, m.reflectance, m.exponent);
        case Material::Kind::LambertAndMirror:
            return place<LambertAndMirror>(memory, ng, ns, m.reflectance, m.specular);
        case Material::Kind::Sheet:
            return place<Sheet>(memory, ng, ns, m);
    }
    return nullptr;
}

std::size_t max_bsdf_bytes() {
    return std::max(sizeof(LambertAndMirror), sizeof(Sheet)) + alignof(std::max_align_t);
}

}  // namespace mock
