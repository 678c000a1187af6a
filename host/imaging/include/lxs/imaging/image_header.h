// Names of what the header of an image file says of its render.
#pragma once

#include "lxs/imaging/error_estimate.h"
#include "lxs/imaging/exr_image.h"

namespace lxs::image_header {

inline constexpr const char* kIntegrator = "integrator";
inline constexpr const char* kPasses = "passes";
inline constexpr const char* kSamples = "samplesPerPixel";
inline constexpr const char* kScene = "scene";  ///< file name, without its folder
inline constexpr const char* kSeed = "seed";    ///< of a merged image all of them, with spaces
inline constexpr const char* kSoftware = "software";
inline constexpr const char* kErrorFreedom = "errorDegreesOfFreedom";
inline constexpr const char* kRelMseOfBias = "relMSEOfBias";
inline constexpr const char* kRmseOfBias = "RMSEOfBias";
/// Checksums, 16 hexadecimal digits each, of what the image depends on beside its seed.
inline constexpr const char* kSceneText = "sceneChecksum";
inline constexpr const char* kSceneFiles = "sceneFilesChecksum";
inline constexpr const char* kSettings = "settingsChecksum";

}  // namespace lxs::image_header

namespace lxs {

/// Writes the error's figures into the header.
void describe(const ErrorEstimate& error, ImageMetadata& metadata);

}  // namespace lxs
