// Saves and restores the film that writes image files.
#include <string>
#include <vector>

#include "flex_image.h"

namespace lxs {

void FlexImage::state(StateArchive& archive) {
    accumulator_.state(archive);
    color_layers_state(archive);
    float_layers_state(archive);
    bool has_error = error_.has_value();
    archive.value(has_error);
    if (has_error != error_.has_value())
        throw StateError(error_ ? "it was saved without an estimate of the error"
                                : "it was saved with an estimate of the error");
    if (error_) error_->state(archive);
    if (bias_) bias_->state(archive);
    if (asked_) asked_->state(archive);
    if (display_) display_->state(archive);
    bool denoises = denoise_.has_value();
    archive.value(denoises);
    if (denoises != denoise_.has_value())
        throw StateError(denoise_ ? "it was saved without what --denoise needs"
                                  : "it was saved by a render with --denoise");
    if (denoise_) denoise_->state(archive);
}

void FlexImage::color_layers_state(StateArchive& archive) {
    // A layer holds four sums a pixel: no layer is made that the archive hasn't the bytes for.
    const std::size_t layer_bytes = pixels() * 4 * sizeof(double);
    const std::size_t count = archive.count(color_layers_.size(), layer_bytes);
    if (!archive.restoring()) {
        for (auto& [name, layer] : color_layers_) {
            std::string saved = name;
            archive.text(saved);
            layer.state(archive);
        }
        return;
    }
    color_layers_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        std::string name;
        archive.text(name);
        if (archive.remaining() < layer_bytes) throw StateError("a layer of the film is cut off");
        color_layer(name).state(archive);
    }
}

void FlexImage::float_layers_state(StateArchive& archive) {
    const std::size_t layer_bytes = pixels() * sizeof(float);
    const std::size_t count = archive.count(layers_.size(), layer_bytes);
    if (!archive.restoring()) {
        for (auto& [name, values] : layers_) {
            std::string saved = name;
            archive.text(saved);
            archive.values(values);
        }
        return;
    }
    layers_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        std::string name;
        std::vector<float> values;
        archive.text(name);
        archive.values(values);
        if (values.size() != pixels()) throw StateError("a layer of the film has another size");
        set_layer(name, values);
    }
}

}  // namespace lxs
