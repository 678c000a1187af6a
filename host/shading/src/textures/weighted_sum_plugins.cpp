// Sums of textures: "add", "subtract" and "multimix"; and "band", a gradient of textures.
#include <algorithm>
#include <cmath>

#include "fresnel_arithmetic.h"
#include "texture_list.h"
#include "texture_parameters.h"
#include "texture_plugins.h"

namespace lxs::shading {
namespace {

/// Sum of weight * texture over at least one.
template <class T>
class WeightedSum final : public Texture<T> {
  public:
    explicit WeightedSum(TextureList<T> inputs, std::vector<float> weights)
        : inputs_(std::move(inputs)), weights_(std::move(weights)) {}
    T evaluate(const TexturePoint& point) const override {
        T sum = inputs_.front()->evaluate(point) * weights_.front();
        for (std::size_t i = 1; i < inputs_.size(); ++i)
            sum += inputs_[i]->evaluate(point) * weights_[i];
        return sum;
    }
    Vec2 mapped_slope(const TexturePoint& point) const override {
        Vec2 sum(0.0f);
        for (std::size_t i = 0; i < inputs_.size(); ++i)
            sum += inputs_[i]->mapped_slope(point) * weights_[i];
        return sum;
    }
    std::optional<T> constant() const override {
        return all_constant(inputs_) ? std::optional<T>(evaluate({})) : std::nullopt;
    }
    bool reads_image() const override { return any_reads_image(inputs_); }
    float cell_size() const override { return smallest_cell(inputs_); }

  private:
    TextureList<T> inputs_;
    std::vector<float> weights_;
};

/// tex1 + weight * tex2.
template <class T>
typename TextureKind<T>::Factory pair_plugin(float weight, std::string_view second_doc) {
    using Kind = TextureKind<T>;
    return {{{"tex1", Kind::kParameter, Kind::kWhite, "first term"},
             {"tex2", Kind::kParameter, Kind::kWhite, second_doc}},
            [weight](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                return std::make_shared<WeightedSum<T>>(
                    TextureList<T>{Kind::read(reader, assets, "tex1", 1),
                                   Kind::read(reader, assets, "tex2", 1)},
                    std::vector<float>{1, weight});
            }};
}

template <class T>
typename TextureKind<T>::Factory multimix_plugin() {
    ParameterDeclaration declared{"weights", ParameterType::Float, "",
                                  "weight of each texture: the value is their sum, not divided"};
    declared.array = true;
    return {declarations({{declared}, texture_list_parameters<T>("a term of the sum")}),
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                const std::vector<float> weights = read_list(reader, "weights");
                auto inputs = read_texture_list<T>(reader, assets, "weights", weights.size());
                return std::make_shared<WeightedSum<T>>(std::move(inputs), weights);
            }};
}

/// Linear between textures at rising places of `amount`.
template <class T>
class Band final : public Texture<T> {
  public:
    Band(std::shared_ptr<const FloatTexture> amount, std::vector<float> places,
         TextureList<T> inputs)
        : amount_(std::move(amount)), places_(std::move(places)), inputs_(std::move(inputs)) {}
    T evaluate(const TexturePoint& point) const override {
        const float amount = amount_->evaluate(point);
        const auto above = std::upper_bound(places_.begin(), places_.end(), amount);
        const auto i = static_cast<std::size_t>(above - places_.begin());
        if (i == 0 || std::isnan(amount)) return inputs_.front()->evaluate(point);
        if (above == places_.end()) return inputs_.back()->evaluate(point);
        const float share = (amount - places_[i - 1]) / (places_[i] - places_[i - 1]);
        return inputs_[i - 1]->evaluate(point) * (1 - share) + inputs_[i]->evaluate(point) * share;
    }
    std::optional<T> constant() const override {
        const bool constant = amount_->constant() && all_constant(inputs_);
        return constant ? std::optional<T>(evaluate({})) : std::nullopt;
    }
    bool reads_image() const override { return amount_->reads_image() || any_reads_image(inputs_); }
    float cell_size() const override {
        return smaller_cell(amount_->cell_size(), smallest_cell(inputs_));
    }

  private:
    std::shared_ptr<const FloatTexture> amount_;
    std::vector<float> places_;
    TextureList<T> inputs_;
};

template <class T>
typename TextureKind<T>::Factory band_plugin() {
    ParameterDeclaration offsets{"offsets", ParameterType::Float, "",
                                 "rising values of amount at which tex1, tex2, ... stand"};
    offsets.array = true;
    return {declarations({{{"amount", ParameterType::FloatTexture, "0",
                            "place in the gradient; before the first and after the last offset "
                            "their textures go on"},
                           offsets},
                          texture_list_parameters<T>("texture at an offset")}),
            [](const ParameterReader& reader, const AssetContext& assets, const Matrix&) {
                const std::vector<float> places = read_list(reader, "offsets");
                if (!std::is_sorted(places.begin(), places.end()))
                    reader.fail("offsets", "band: \"offsets\" must rise");
                auto inputs = read_texture_list<T>(reader, assets, "offsets", places.size());
                return std::make_shared<Band<T>>(read_float_texture(reader, assets, "amount", 0),
                                                 places, std::move(inputs));
            }};
}

}  // namespace

void register_sum_textures(Registry& registry) {
    registry.float_textures["add"] = pair_plugin<float>(1, "second term");
    registry.color_textures["add"] = pair_plugin<Rgb>(1, "second term");
    registry.float_textures["subtract"] = pair_plugin<float>(-1, "what is taken away");
    registry.color_textures["subtract"] = pair_plugin<Rgb>(-1, "what is taken away");
    registry.float_textures["multimix"] = multimix_plugin<float>();
    registry.color_textures["multimix"] = multimix_plugin<Rgb>();
    registry.fresnel_textures["multimix"] = multimix_plugin<FresnelValue>();
    registry.float_textures["band"] = band_plugin<float>();
    registry.color_textures["band"] = band_plugin<Rgb>();
    registry.fresnel_textures["band"] = band_plugin<FresnelValue>();
}

}  // namespace lxs::shading
