// The coating of "glossy" and "glossytranslucent": parameters.
#include "coating_parameters.h"

#include <limits>

namespace lxs::shading {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

}  // namespace

CoatingParameters::CoatingParameters(const ParameterReader& reader, const AssetContext& assets,
                                     const std::string& prefix, const Rgb& default_ks,
                                     bool multibounce)
    : ks_(read_reflectance(reader, assets, prefix + "Ks", default_ks)),
      ka_(read_positive_color(reader, assets, prefix + "Ka", Rgb(0.0f))),
      index_(read_limited(reader, assets, prefix + "index", 0, 0, kLargest)),
      depth_(read_limited(reader, assets, prefix + "d", 0, 0, kLargest)),
      surface_(reader, assets, 0.1f, prefix),
      multibounce_(multibounce) {}

Coating CoatingParameters::at(const TexturePoint& point) const {
    Coating coating;
    coating.reflectance = ks_.at(point);
    if (const float index = index_.at(point); index > 0) {
        const float root = (index - 1) / (index + 1);
        coating.reflectance = Rgb(root * root);
    }
    coating.optical_depth = limited(ka_.at(point) * depth_.at(point), 0, kLargest);
    coating.multibounce = multibounce_;
    return coating;
}

bool CoatingParameters::reads_image() const {
    return ks_.reads_image() || ka_.reads_image() || index_.reads_image() || depth_.reads_image() ||
           surface_.reads_image();
}

}  // namespace lxs::shading
