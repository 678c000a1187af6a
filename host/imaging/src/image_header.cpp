// What the header of an image file says of its error.
#include "lxs/imaging/image_header.h"

#include <fmt/format.h>

namespace lxs {

void describe(const ErrorEstimate& error, ImageMetadata& metadata) {
    metadata["relMSE"] = fmt::format("{:.3g}", error.relmse);
    metadata["relMSEInterval"] =
        fmt::format("{:.3g} to {:.3g}", error.relmse_low, error.relmse_high);
    metadata["relMSEWhole"] = fmt::format("{:.3g}", error.relmse_whole);
    metadata[image_header::kRelMseOfBias] = fmt::format("{:.3g}", error.relmse_of_bias);
    metadata["RMSE"] = fmt::format("{:.3g}", error.rmse);
    metadata["RMSEInterval"] = fmt::format("{:.3g} to {:.3g}", error.rmse_low, error.rmse_high);
    metadata["RMSEWhole"] = fmt::format("{:.3g}", error.rmse_whole);
    metadata[image_header::kRmseOfBias] = fmt::format("{:.3g}", error.rmse_of_bias);
    metadata[image_header::kErrorFreedom] = fmt::format("{:.3g}", error.degrees_of_freedom);
}

}  // namespace lxs
