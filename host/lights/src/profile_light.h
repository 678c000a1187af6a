// Light at a point whose intensity depends on direction by an image.
#pragma once

#include "emission_profile.h"
#include "lxs/lights/lights.h"

namespace lxs {

class ProfileLight final : public PlacedLight {
  public:
    /// `kind` must outlive the light (a literal); `intensity` in W/sr where the profile is 1.
    ProfileLight(const LightPlacement& placement, std::string_view kind, const Vec3& position,
                 const Rgb& intensity, std::unique_ptr<const EmissionProfile> profile);

    std::string_view kind() const override { return kind_; }
    float power() const override { return power_; }
    bool is_delta() const override { return true; }
    bool sample_emission(const PrimaryPoint& u, EmissionSample& sample) const override;
    bool sample_direct(const Vec3& p, const Vec3& n, const Vec2& u,
                       DirectSample& sample) const override;
    float pdf_direct(const Vec3&, const Vec3&, const Vec3&, const Vec3&, const Vec3&,
                     std::uint32_t) const override {
        return 0;
    }
    bool emission_coordinates(const Vec3& p, const DirectSample& sample,
                              PrimaryPoint& u) const override;

  private:
    std::string_view kind_;
    Vec3 position_;
    Rgb intensity_;
    std::unique_ptr<const EmissionProfile> profile_;
    float power_ = 0;
};

}  // namespace lxs
