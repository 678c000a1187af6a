// A texture with one value everywhere: what scene files give as a number, and stand-ins.
#pragma once

#include "lxs/scene/texture.h"

namespace lxs {

template <class T>
class ConstantTexture final : public Texture<T> {
  public:
    explicit ConstantTexture(const T& value) : value_(value) {}
    T evaluate(const TexturePoint& /*point*/) const override { return value_; }
    std::optional<T> constant() const override { return value_; }

  private:
    T value_;
};

}  // namespace lxs
