// Photon part, photon density, and the views of the guides.
#include "layers/debug_layers.h"

#include <algorithm>
#include <limits>

#include "aips/core/sampling/sampling.h"
#include "base/film_pixel.h"

namespace aips {
DebugLayers::DebugLayers(Film& film, const Guide* guide) : film_(film) {
    const std::size_t pixels = std::size_t{film.width()} * film.height();
    densities_.resize(pixels);
    density_layer_.resize(pixels);
    if (guide) node_layers_.emplace(film, *guide);
}

void DebugLayers::add_pass(const EyeImage& image, const PhotonFlux& flux, const GatherRadii& radii,
                           const FilmPass& pass, const BounceStatistics* bounces) {
    find_pixels(image.positions);
    add_photon_part(pass);
    add_photon_density(image, flux, radii, pass.photon_weight);
    if (node_layers_) node_layers_->show(image, pixel_of_path_, *bounces);
}

void DebugLayers::add_tables(const EyeImage& image, const BounceTables& tables) {
    if (!table_layers_) table_layers_.emplace(film_);
    table_layers_->show(image, pixel_of_path_, tables);
}

void DebugLayers::find_pixels(std::span<const Vec2> positions) {
    pixel_of_path_.resize(positions.size());
    std::transform(positions.begin(), positions.end(), pixel_of_path_.begin(),
                   [&](Vec2 p) { return film_pixel(p, film_.width(), film_.height()); });
}

void DebugLayers::add_photon_part(const FilmPass& pass) {
    photon_part_.assign(pass.positions.size(), Rgb{});
    for (std::size_t i = 0; i < pass.photons.size(); ++i)
        photon_part_[i / pass.groups] += pass.photons[i];
    film_.add_layer_pass("photons", pass.positions, photon_part_, pass.photon_weight);
}

void DebugLayers::add_photon_density(const EyeImage& image, const PhotonFlux& flux,
                                     const GatherRadii& radii, double weight) {
    for (const std::uint32_t pixel : pixel_of_path_)
        densities_[pixel].weight += weight;
    for (std::size_t i = 0; i < image.visible_points.size() && radii.largest > 0; ++i) {
        // In double: r^2 leaves the range of float in tiny scenes.
        const double disk = double(kPi) * double(radii.of(i)) * double(radii.of(i));
        const std::uint32_t pixel = pixel_of_path_[image.visible_points[i].sample];
        densities_[pixel].sum += weight * double(flux.accepted[i]) / disk;
    }
    std::transform(densities_.begin(), densities_.end(), density_layer_.begin(),
                   [](const WeightedSum& density) {
                       const double mean = density.weight > 0 ? density.sum / density.weight : 0;
                       return float(std::min(mean, double(std::numeric_limits<float>::max())));
                   });
    film_.set_layer("photondensity", density_layer_);
}

void DebugLayers::state(StateArchive& archive) {
    for (WeightedSum& density : densities_) {
        archive.amount(density.weight);
        archive.amount(density.sum);
    }
    if (node_layers_) node_layers_->state(archive);
}

std::size_t DebugLayers::memory_bytes() const {
    return pixel_of_path_.capacity() * sizeof(std::uint32_t) +
           photon_part_.capacity() * sizeof(Rgb) + densities_.capacity() * sizeof(WeightedSum) +
           density_layer_.capacity() * sizeof(float) +
           (node_layers_ ? node_layers_->memory_bytes() : 0) +
           (table_layers_ ? table_layers_->memory_bytes() : 0);
}

std::size_t DebugLayers::memory_bound_bytes(std::size_t pixels, std::size_t eye_paths,
                                            std::uint32_t nodes) {
    const std::size_t paths = eye_paths * (sizeof(std::uint32_t) + sizeof(Rgb));
    const std::size_t layers = pixels * (sizeof(WeightedSum) + sizeof(float));
    const std::size_t guide =
        NodeLayers::memory_bound_bytes(pixels) + BounceStatistics::memory_bound_bytes(nodes);
    return paths + layers + (nodes ? guide : TableLayers::memory_bound_bytes(pixels));
}

}  // namespace aips
