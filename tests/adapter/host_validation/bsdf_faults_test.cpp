// Faults of Bsdfs: each is planted in the floor's material and found alone, with its name.
#include <gtest/gtest.h>

#include "aips/core/sampling/sampling.h"
#include "faulty_scene.h"

namespace aips::bsdf_faults_test {
namespace {

enum class Fault {
    None,
    PdfTwice,         // pdf() is twice the density, sample() says the right one
    DensityUniform,   // both densities are said to be uniform, directions are not
    WeightHalf,       // sample() brings half of what evaluate() does
    NoSuchLobe,       // lobes() lacks what sample() returns
    LobeNeverComes,   // sample() leaves out a lobe that evaluate() has
    LobeUnasked,      // sample() returns a lobe that it was not asked for
    TooBright,        // more light leaves than comes
    AlbedoAboveOne,   // albedo() is no albedo
    AlbedoDark,       // albedo() is 0 where light is scattered
    NotLambertian,    // lambertian() says another Kd
    NotFinite,        // evaluate() brings NaN
    DeltaWithDensity  // a mirror's samples carry a pdf
};

/// A Lambert lobe beside a mirror, spoilt.
class FaultyBsdf final : public Bsdf {
  public:
    FaultyBsdf(const Bsdf& bsdf, Fault fault) : bsdf_(bsdf), fault_(fault) {}

    LobeMask lobes() const override {
        return fault_ == Fault::NoSuchLobe ? LobeMask(kDiffuse) : bsdf_.lobes();
    }
    Rgb evaluate(Vec3 wo, Vec3 wi, Transport transport, LobeMask mask) const override {
        const Rgb f = bsdf_.evaluate(wo, wi, transport, mask);
        if (fault_ == Fault::NotFinite && wi.x > 0.9f) return f / 0.0f - f / 0.0f;
        return fault_ == Fault::TooBright ? f * 4 : f;
    }
    float pdf(Vec3 wo, Vec3 wi, LobeMask mask) const override {
        const float pdf = bsdf_.pdf(wo, wi, mask);
        if (fault_ == Fault::LobeNeverComes) return 0;
        if (fault_ == Fault::DensityUniform) return pdf > 0 ? 0.25f / kPi * share(mask) : 0;
        return fault_ == Fault::PdfTwice ? 2 * pdf : pdf;
    }
    bool sample(Vec3 wo, Vec2 u, float u_lobe, Transport transport, LobeMask mask,
                BsdfSample& s) const override {
        if (fault_ == Fault::LobeUnasked) mask = kAllLobes;
        if (!bsdf_.sample(wo, u, u_lobe, transport, mask, s)) return false;
        if (fault_ == Fault::LobeNeverComes) return s.lobe != kDiffuse;
        if (fault_ == Fault::WeightHalf && s.lobe == kDiffuse) s.weight *= 0.5f;
        if (fault_ == Fault::TooBright && s.lobe == kDiffuse) s.weight *= 4.0f;
        if (fault_ == Fault::DensityUniform && s.lobe == kDiffuse) {
            s.pdf = 0.25f / kPi * share(mask);
        }
        if (fault_ == Fault::DeltaWithDensity && s.lobe == kSpecular) s.pdf = 1;
        return true;
    }
    Rgb albedo(Vec3 wo, LobeMask mask) const override {
        const Rgb albedo = bsdf_.albedo(wo, mask);
        if (fault_ == Fault::AlbedoDark && mask == kDiffuse) return {};
        return fault_ == Fault::AlbedoAboveOne ? albedo * 3 : albedo;
    }
    bool lambertian(Rgb& kd) const override {
        kd = {0.9f, 0.9f, 0.9f};
        return fault_ == Fault::NotLambertian;
    }

  private:
    static float share(LobeMask mask) { return mask & kSpecular ? 0.5f : 1.0f; }

    const Bsdf& bsdf_;
    Fault fault_;
};

std::vector<HostFinding> find(Fault fault) {
    const mock::Scene scene = mock::lamp_box(mock::half_mirror(), {});
    mock::Spoils spoils;
    spoils.point = [fault](SurfacePoint& point, std::pmr::memory_resource& memory) {
        if (point.material != 0 || fault == Fault::None) return;
        void* const place = memory.allocate(sizeof(FaultyBsdf), alignof(FaultyBsdf));
        point.bsdf = new (place) FaultyBsdf(*point.bsdf, fault);
    };
    spoils.facts = [](SceneFacts& facts) {
        facts.max_bsdf_bytes += sizeof(FaultyBsdf) + alignof(FaultyBsdf);
    };
    return validate_host(mock::FaultyScene(scene, spoils), mock::quick_check());
}

struct Case {
    const char* name;
    Fault fault;
    const char* check;
};

class BsdfFaults : public testing::TestWithParam<Case> {};

TEST_P(BsdfFaults, AreNamed) {
    const auto findings = find(GetParam().fault);
    ASSERT_EQ(findings.size(), 1u) << mock::lines(findings);
    EXPECT_EQ(findings[0].subject, "material 0 \"surface 0\"");
    EXPECT_EQ(findings[0].check, GetParam().check) << mock::lines(findings);
}

INSTANTIATE_TEST_SUITE_P(
    Each, BsdfFaults,
    testing::Values(Case{"PdfTwice", Fault::PdfTwice, "pdf"},
                    Case{"DensityUniform", Fault::DensityUniform, "density"},
                    Case{"WeightHalf", Fault::WeightHalf, "weight"},
                    Case{"NoSuchLobe", Fault::NoSuchLobe, "lobes"},
                    Case{"LobeNeverComes", Fault::LobeNeverComes, "lobes"},
                    Case{"LobeUnasked", Fault::LobeUnasked, "lobe of a sample"},
                    Case{"TooBright", Fault::TooBright, "energy"},
                    Case{"AlbedoAboveOne", Fault::AlbedoAboveOne, "albedo"},
                    Case{"AlbedoDark", Fault::AlbedoDark, "albedo"},
                    Case{"NotLambertian", Fault::NotLambertian, "lambertian"},
                    Case{"NotFinite", Fault::NotFinite, "values"},
                    Case{"DeltaWithDensity", Fault::DeltaWithDensity, "delta"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(BsdfFaults, NoneInTheSoundOne) {
    const auto findings = find(Fault::None);
    EXPECT_TRUE(findings.empty()) << mock::lines(findings);
}

}  // namespace
}  // namespace aips::bsdf_faults_test
