// A Bsdf that is elsewhere.
#include "ranks/foreign_bsdf.h"

#include <stdexcept>

namespace aips {
namespace {

[[noreturn]] void refuse() {
    throw std::logic_error("a visible point of another rank was asked how it scatters");
}

class ForeignBsdf final : public Bsdf {
  public:
    LobeMask lobes() const override { refuse(); }
    Rgb evaluate(Vec3 /*wo*/, Vec3 /*wi*/, Transport /*transport*/,
                 LobeMask /*mask*/) const override {
        refuse();
    }
    float pdf(Vec3 /*wo*/, Vec3 /*wi*/, LobeMask /*mask*/) const override { refuse(); }
    bool sample(Vec3 /*wo*/, Vec2 /*u*/, float /*u_lobe*/, Transport /*transport*/,
                LobeMask /*mask*/, BsdfSample& /*sample*/) const override {
        refuse();
    }
    Rgb albedo(Vec3 /*wo*/, LobeMask /*mask*/) const override { refuse(); }
};

}  // namespace

const Bsdf* foreign_bsdf() {
    static const ForeignBsdf bsdf;
    return &bsdf;
}

}  // namespace aips
