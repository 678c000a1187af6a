// Two textures combined into one.
#pragma once

#include <memory>

#include "lxs/scene/texture.h"

namespace lxs::shading {

/// tex1 * tex2.
template <class T>
class ScaleTexture final : public Texture<T> {
  public:
    using Input = std::shared_ptr<const Texture<T>>;

    ScaleTexture(Input first, Input second)
        : first_(std::move(first)), second_(std::move(second)) {}
    T evaluate(const TexturePoint& point) const override {
        return first_->evaluate(point) * second_->evaluate(point);
    }
    std::optional<T> constant() const override {
        const std::optional<T> first = first_->constant(), second = second_->constant();
        if (!first || !second) return std::nullopt;
        return *first * *second;
    }
    bool reads_image() const override { return first_->reads_image() || second_->reads_image(); }

  private:
    Input first_, second_;
};

/// (1 - amount) * tex1 + amount * tex2.
template <class T>
class MixTexture final : public Texture<T> {
  public:
    using Input = std::shared_ptr<const Texture<T>>;

    MixTexture(Input first, Input second, std::shared_ptr<const FloatTexture> amount)
        : first_(std::move(first)), second_(std::move(second)), amount_(std::move(amount)) {}
    T evaluate(const TexturePoint& point) const override {
        return blend(first_->evaluate(point), second_->evaluate(point), amount_->evaluate(point));
    }
    std::optional<T> constant() const override {
        const std::optional<T> first = first_->constant(), second = second_->constant();
        const std::optional<float> amount = amount_->constant();
        if (!first || !second || !amount) return std::nullopt;
        return blend(*first, *second, *amount);
    }
    bool reads_image() const override {
        return first_->reads_image() || second_->reads_image() || amount_->reads_image();
    }

  private:
    static T blend(const T& first, const T& second, float amount) {
        return first * (1 - amount) + second * amount;
    }

    Input first_, second_;
    std::shared_ptr<const FloatTexture> amount_;
};

}  // namespace lxs::shading
