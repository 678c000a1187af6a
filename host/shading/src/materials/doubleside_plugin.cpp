// Material "doubleside": one named material for each side of a surface.
#include "bsdfs/double_side_bsdf.h"
#include "bsdfs/place_bsdf.h"
#include "common_parameters.h"
#include "material_plugins.h"

namespace lxs::shading {
namespace {

using MaterialPointer = std::shared_ptr<const Material>;

class DoubleSideMaterial final : public Material {
  public:
    /// `flip_front`: the front material shows its own back to the front; likewise `flip_back`.
    DoubleSideMaterial(MaterialPointer front, MaterialPointer back, bool flip_front, bool flip_back)
        : front_(std::move(front)),
          back_(std::move(back)),
          flip_front_(flip_front),
          flip_back_(flip_back),
          transmits_(front_->facts().transmits || back_->facts().transmits) {}

    const Bsdf* scatter(const ShadingPoint& point,
                        std::pmr::memory_resource& memory) const override;
    MaterialFacts facts() const override;
    Rgb straight_transmittance(const ShadingPoint& point, const Vec3& direction) const override;

  private:
    /// The point as a material sees it that is turned over.
    static ShadingPoint turned(const ShadingPoint& point, bool turn);

    MaterialPointer front_, back_;
    bool flip_front_, flip_back_, transmits_;
};

ShadingPoint DoubleSideMaterial::turned(const ShadingPoint& point, bool turn) {
    if (!turn) return point;
    ShadingPoint other = point;
    other.ng = -point.ng;
    other.ns = -point.ns;
    std::swap(other.interior, other.exterior);
    return other;
}

const Bsdf* DoubleSideMaterial::scatter(const ShadingPoint& point,
                                        std::pmr::memory_resource& memory) const {
    const Bsdf* front = front_->scatter(turned(point, flip_front_), memory);
    const Bsdf* back = back_->scatter(turned(point, flip_back_), memory);
    if (!front && !back) return nullptr;
    return place_bsdf<DoubleSideBsdf>(memory, front, back, transmits_, point.ng, point.ns);
}

MaterialFacts DoubleSideMaterial::facts() const {
    const MaterialFacts front = front_->facts(), back = back_->facts();
    MaterialFacts facts;
    facts.lobes = front.lobes | back.lobes;
    facts.transmits = front.transmits || back.transmits;
    facts.straight = front.straight || back.straight;
    facts.reads_image = front.reads_image || back.reads_image;
    facts.bends = front.bends || back.bends;
    facts.reads_dpdv = front.reads_dpdv || back.reads_dpdv;
    facts.disperses = front.disperses || back.disperses;
    facts.add_spectra_of(front);
    facts.add_spectra_of(back);
    facts.max_bsdf_bytes = front.max_bsdf_bytes + back.max_bsdf_bytes + kBsdfBytes<DoubleSideBsdf>;
    return facts;
}

Rgb DoubleSideMaterial::straight_transmittance(const ShadingPoint& point,
                                               const Vec3& direction) const {
    // A shadow ray goes on along `direction`: it came from the other side, as wo tells it.
    const bool on_front = direction.dot(point.ng) <= 0;
    return on_front ? front_->straight_transmittance(turned(point, flip_front_), direction)
                    : back_->straight_transmittance(turned(point, flip_back_), direction);
}

MaterialPointer create_doubleside(const ParameterReader& reader, const AssetContext& assets,
                                  const Matrix&) {
    warn_of_common_parameters(reader);
    const MaterialPointer front = read_named_material(reader, assets, "frontnamedmaterial");
    const MaterialPointer back = reader.given("backnamedmaterial")
                                     ? read_named_material(reader, assets, "backnamedmaterial")
                                     : front;
    return std::make_shared<DoubleSideMaterial>(front, back,
                                                !reader.boolean("usefrontforfront", true),
                                                reader.boolean("usefrontforback", true));
}

}  // namespace

MaterialFactory doubleside_plugin() {
    using enum ParameterType;
    return {with_common_parameters(
                {{"frontnamedmaterial", String, "", "name of the material of the front"},
                 {"backnamedmaterial", String, "",
                  "name of the material of the back; the front's by default"},
                 {"usefrontforfront", Bool, "true",
                  "the front shows its material's front side, else its back side"},
                 {"usefrontforback", Bool, "true",
                  "the back shows its material's front side, else its back side"}}),
            &create_doubleside};
}

}  // namespace lxs::shading
