// The film of a rank that helps: it is asked for its size, and drops what it is given.
#pragma once

#include "lxs/sdk/film.h"

namespace lxs {

class SilentFilm final : public Film {
  public:
    /// `film`, whose questions are answered as it would answer them, outlives this.
    explicit SilentFilm(const Film& film) : film_(film) {}
    std::uint32_t width() const override { return film_.width(); }
    std::uint32_t height() const override { return film_.height(); }
    std::uint32_t light_groups() const override { return film_.light_groups(); }
    LayersWanted layers_wanted() const override { return film_.layers_wanted(); }
    void add_pass(const PassSamples& /*samples*/) override {}
    void add_splats(const PassSplats& /*samples*/) override {}
    void add_layer_pass(std::string_view /*name*/, const PassSamples& /*samples*/) override {}
    void clear() override {}
    void set_layer(std::string_view /*name*/, std::span<const float> /*values*/) override {}

  private:
    const Film& film_;
};

}  // namespace lxs
