// A texture with one value everywhere.
#pragma once

#include "lxs/scene/texture.h"

namespace lxs::shading {

template <class T>
class ConstantTexture final : public Texture<T> {
  public:
    explicit ConstantTexture(const T& value) : value_(value) {}
    T evaluate(const TexturePoint&) const override { return value_; }
    std::optional<T> constant() const override { return value_; }

  private:
    T value_;
};

}  // namespace lxs::shading
