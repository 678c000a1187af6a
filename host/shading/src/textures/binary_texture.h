// Two textures combined into one.
#pragma once

#include <memory>
#include <type_traits>

#include "lxs/scene/texture.h"
#include "spectral_product.h"

namespace lxs::shading {

/// tex1 * tex2.
template <class T>
class ScaleTexture final : public Texture<T> {
  public:
    using Input = std::shared_ptr<const Texture<T>>;

    ScaleTexture(Input first, Input second) : first_(std::move(first)), second_(std::move(second)) {
        if constexpr (std::is_same_v<T, Rgb>) spectrum_ = spectral_product(*first_, *second_);
    }
    T evaluate(const TexturePoint& point) const override {
        return first_->evaluate(point) * second_->evaluate(point);
    }
    Vec2 mapped_slope(const TexturePoint& point) const override {
        if constexpr (std::is_same_v<T, float>) {
            return first_->mapped_slope(point) * second_->evaluate(point) +
                   second_->mapped_slope(point) * first_->evaluate(point);
        }
        return Vec2(0.0f);
    }
    std::optional<T> constant() const override {
        const std::optional<T> first = first_->constant(), second = second_->constant();
        if (!first || !second) return std::nullopt;
        return *first * *second;
    }
    CurvePointer spectrum() const override { return spectrum_; }
    bool reads_image() const override { return first_->reads_image() || second_->reads_image(); }
    float cell_size() const override {
        return smaller_cell(first_->cell_size(), second_->cell_size());
    }

  private:
    Input first_, second_;
    CurvePointer spectrum_;
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
    Vec2 mapped_slope(const TexturePoint& point) const override {
        const float amount = amount_->evaluate(point);
        return first_->mapped_slope(point) * (1 - amount) + second_->mapped_slope(point) * amount;
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
    float cell_size() const override {
        return smaller_cell(amount_->cell_size(),
                            smaller_cell(first_->cell_size(), second_->cell_size()));
    }

  private:
    static T blend(const T& first, const T& second, float amount) {
        return first * (1 - amount) + second * amount;
    }

    Input first_, second_;
    std::shared_ptr<const FloatTexture> amount_;
};

}  // namespace lxs::shading
