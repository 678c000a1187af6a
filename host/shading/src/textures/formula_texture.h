// Textures that are a formula of the surface point.
#pragma once

#include <memory>
#include <utility>

#include "lxs/scene/texture.h"

namespace lxs::shading {

/// Formula: T(const TexturePoint&).
template <class T, class Formula>
class FormulaTexture final : public Texture<T> {
  public:
    FormulaTexture(Formula formula, bool reads_image, float cell_size)
        : formula_(std::move(formula)), reads_image_(reads_image), cell_size_(cell_size) {}
    T evaluate(const TexturePoint& point) const override { return formula_(point); }
    bool reads_image() const override { return reads_image_; }
    float cell_size() const override { return cell_size_; }

  private:
    Formula formula_;
    bool reads_image_;
    float cell_size_;
};

/// `reads_image`: one of the textures that the formula asks does. `cell_size`: as of Texture.
template <class T, class Formula>
std::shared_ptr<const Texture<T>> formula_texture(Formula formula, bool reads_image = false,
                                                  float cell_size = 0) {
    return std::make_shared<FormulaTexture<T, Formula>>(std::move(formula), reads_image, cell_size);
}

}  // namespace lxs::shading
