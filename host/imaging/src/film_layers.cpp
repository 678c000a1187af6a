// The layers that a film keeps beside its image because a user asked for them.
#include "film_layers.h"

#include "cryptomatte.h"
#include "film_bias.h"
#include "sum_to_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lxs {
namespace {

/// By ImagePart.
constexpr std::array<std::string_view, kImageParts> kParts{"direct", "caustics", "indirect"};
constexpr std::string_view kObjects = "CryptoObject", kMaterials = "CryptoMaterial";
constexpr std::string_view kAlbedo = "albedo", kNormal = "normal", kDepth = "depth";

/// By ImagePart.
std::array<bool, kImageParts> parts_of(const LayersWanted& wanted) {
    return {wanted.direct, wanted.caustics, wanted.indirect};
}

/// Number of the pixel of `size` that a place on the film is in, beyond its edge the nearest.
std::size_t pixel_along(float x, std::uint32_t size) {
    return static_cast<std::size_t>(std::clamp(std::floor(x), 0.0f, static_cast<float>(size - 1)));
}

}  // namespace

FilmLayers::FilmLayers(const LayersWanted& wanted, std::uint32_t width, std::uint32_t height,
                       const PixelFilter& filter)
    : wanted_(wanted), width_(width), height_(height) {
    if (wanted.parts()) parts_.emplace(width, height, kImageParts, filter);
    if (wanted.albedo) albedo_.emplace(width, height, 1, filter);
    if (wanted.normal) normal_.emplace(width, height, 1, filter);
    if (wanted.alpha) alpha_.emplace(width, height, 1, filter);
    if (wanted.objects || wanted.materials) cells_.emplace(width, height, 1);
    if (wanted.objects) objects_.emplace(Mattes{IdMattes(width, height, filter), {}});
    if (wanted.materials) materials_.emplace(Mattes{IdMattes(width, height, filter), {}});
    if (wanted.depth) depth_.assign(pixels(), kDepthOfNothing);
}

std::vector<std::string> FilmLayers::names(const LayersWanted& wanted) {
    std::vector<std::string> names;
    for (std::size_t part = 0; part < kImageParts; ++part) {
        if (parts_of(wanted)[part]) names.emplace_back(kParts[part]);
    }
    if (wanted.albedo) names.emplace_back(kAlbedo);
    if (wanted.normal) names.emplace_back(kNormal);
    if (wanted.depth) names.emplace_back(kDepth);
    if (wanted.bias) names.emplace_back(kBiasLayer);
    for (const char* number : {"00", "01", "02"}) {
        if (wanted.objects) names.push_back(std::string(kObjects) + number);
        if (wanted.materials) names.push_back(std::string(kMaterials) + number);
    }
    return names;
}

void FilmLayers::add_surfaces(std::span<const Vec2> positions,
                              std::span<const SeenSurface> surfaces) {
    const auto add = [&](FilmAccumulator& mean, const auto& value) {
        values_.resize(surfaces.size());
        std::transform(surfaces.begin(), surfaces.end(), values_.begin(), value);
        mean.add({.positions = positions, .radiance = values_});
    };
    if (albedo_) add(*albedo_, [](const SeenSurface& seen) { return seen.albedo; });
    if (normal_) {
        add(*normal_, [](const SeenSurface& seen) {
            return Rgb(0.5f + 0.5f * seen.normal.x, 0.5f + 0.5f * seen.normal.y,
                       0.5f + 0.5f * seen.normal.z);
        });
    }
    if (alpha_) {
        add(*alpha_,
            [](const SeenSurface& seen) { return Rgb(std::isfinite(seen.depth) ? 1.0f : 0.0f); });
    }
    told_of_surfaces_ = true;
    if (!depth_.empty()) add_depths(positions, surfaces);
    if (cells_) add_mattes(positions, surfaces);
}

void FilmLayers::set_names(std::span<const std::string> objects,
                           std::span<const std::string> materials) {
    const auto set = [](std::optional<Mattes>& masks, std::span<const std::string> names) {
        if (!masks) return;
        masks->names.assign(names.begin(), names.end());
        std::vector<std::uint32_t> ids(names.size());
        std::transform(names.begin(), names.end(), ids.begin(), &cryptomatte_id);
        masks->mattes.set_ids(std::move(ids));
    };
    set(objects_, objects);
    set(materials_, materials);
}

void FilmLayers::add_mattes(std::span<const Vec2> positions,
                            std::span<const SeenSurface> surfaces) {
    values_.assign(surfaces.size(), Rgb(0.0f));
    cells_->sort({.positions = positions, .radiance = values_});
    if (objects_)
        objects_->mattes.add(*cells_, positions, [&](std::size_t i) { return surfaces[i].object; });
    if (materials_)
        materials_->mattes.add(*cells_, positions,
                               [&](std::size_t i) { return surfaces[i].material; });
}

/// The least is the same in whatever order samples come.
void FilmLayers::add_depths(std::span<const Vec2> positions,
                            std::span<const SeenSurface> surfaces) {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Vec2& p = positions[i];
        const float depth = surfaces[i].depth;
        if (std::isnan(depth) || !std::isfinite(p.x) || !std::isfinite(p.y)) {
            ++refused_depths_;
            continue;
        }
        float& least = depth_[pixel_along(p.y, height_) * width_ + pixel_along(p.x, width_)];
        least = std::min(least, depth);
    }
}

void FilmLayers::clear() {
    if (parts_) parts_->clear();
    if (albedo_) albedo_->clear();
    if (normal_) normal_->clear();
    if (alpha_) alpha_->clear();
    for (std::optional<Mattes>* masks : {&objects_, &materials_}) {
        if (*masks) (*masks)->mattes.clear();
    }
    std::fill(depth_.begin(), depth_.end(), kDepthOfNothing);
}

void FilmLayers::set_wavelengths(const Wavelengths& wavelengths) {
    if (parts_) parts_->set_conversion(wavelengths.to_rgb, wavelengths.white);
    if (albedo_) albedo_->set_conversion(wavelengths.to_rgb, wavelengths.white);
}

std::vector<Rgb> FilmLayers::mean_normals() const {
    std::vector<Rgb> normals(pixels(), Rgb(0.0f));
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const PixelMeans means = normal_->means(i);
        if (means.weight[0] > 0) normals[i] = Rgb(means.value[0] * 2.0 - Imath::V3d(1.0));
    }
    return normals;
}

std::vector<float> FilmLayers::alpha() const {
    if (!alpha_) return {};
    std::vector<float> alpha(pixels(), 1.0f);
    if (!told_of_surfaces_) return alpha;
    for (std::size_t i = 0; i < alpha.size(); ++i)
        alpha[i] = static_cast<float>(std::clamp(alpha_->means(i).value[0].x, 0.0, 1.0));
    return alpha;
}

void FilmLayers::append_parts(std::vector<ColorLayer>& colors,
                              const std::function<void(std::span<Rgb>)>& to_film) const {
    std::vector<ColorLayer> parts;
    for (std::uint32_t part = 0; part < kImageParts; ++part) {
        std::vector<Rgb> values(pixels());
        parts_->resolve_group(part, values);
        to_film(values);
        parts.push_back({std::string(kParts[part]), std::move(values)});
    }
    sum_to_image(parts, colors.front().values);
    for (std::uint32_t part = 0; part < kImageParts; ++part) {
        if (parts_of(wanted_)[part]) colors.push_back(std::move(parts[part]));
    }
}

void FilmLayers::append_to(FileLayers& layers,
                           const std::function<void(std::span<Rgb>)>& to_film) const {
    std::vector<ColorLayer>& colors = layers.colors;
    if (parts_) append_parts(colors, to_film);
    if (albedo_) {
        std::vector<Rgb> values(pixels());
        albedo_->resolve_total(values);
        to_film(values);
        colors.push_back({std::string(kAlbedo), std::move(values)});
    }
    if (normal_) colors.push_back({std::string(kNormal), mean_normals(), {'X', 'Y', 'Z'}});
    if (!depth_.empty()) layers.floats.push_back({std::string(kDepth), depth_, 'Z'});
    if (alpha_) layers.floats.push_back({"", alpha(), 'A'});
    const auto append = [&](const std::string& layer, const std::optional<Mattes>& masks) {
        if (!masks) return;
        for (std::size_t rank = 0; rank < kMatteRanks; ++rank) {
            const std::string name = layer + "0" + std::to_string(rank / 2);
            for (const bool coverage : {false, true}) {
                layers.floats.push_back({name, masks->mattes.plane(rank, coverage),
                                         "RGBA"[2 * (rank % 2) + (coverage ? 1 : 0)]});
            }
        }
        add_cryptomatte_header(layer, masks->names, layers.metadata);
    };
    append(std::string(kObjects), objects_);
    append(std::string(kMaterials), materials_);
}

void FilmLayers::state(StateArchive& archive) {
    if (parts_) parts_->state(archive);
    if (albedo_) albedo_->state(archive);
    if (normal_) normal_->state(archive);
    if (alpha_) alpha_->state(archive);
    archive.value(told_of_surfaces_);
    for (std::optional<Mattes>* masks : {&objects_, &materials_}) {
        if (*masks) (*masks)->mattes.state(archive);
    }
    if (depth_.empty()) return;
    archive.fixed(std::span(depth_));
    archive.value(refused_depths_);
    if (std::any_of(depth_.begin(), depth_.end(), [](float d) { return !std::isfinite(d); }))
        throw StateError("a depth of the film is no finite number");
}

InvalidSampleList FilmLayers::invalid_samples() const {
    InvalidSampleList list;
    const auto add = [&](std::string_view name, std::uint64_t count) {
        if (count > 0) list.push_back({"layer \"" + std::string(name) + "\"", count});
    };
    if (parts_) {
        for (std::size_t part = 0; part < kImageParts; ++part)
            add(kParts[part], parts_->refused_by_group()[part]);
    }
    if (albedo_) add(kAlbedo, albedo_->refused_samples());
    if (normal_) add(kNormal, normal_->refused_samples());
    add(kDepth, refused_depths_);
    return list;
}

std::size_t FilmLayers::memory_bytes() const {
    return (parts_ ? parts_->memory_bytes() : 0) + (albedo_ ? albedo_->memory_bytes() : 0) +
           (normal_ ? normal_->memory_bytes() : 0) + (alpha_ ? alpha_->memory_bytes() : 0) +
           (objects_ ? objects_->mattes.memory_bytes() : 0) +
           (materials_ ? materials_->mattes.memory_bytes() : 0) +
           (cells_ ? cells_->memory_bytes() : 0) + depth_.capacity() * sizeof(float) +
           values_.capacity() * sizeof(Rgb);
}

}  // namespace lxs
