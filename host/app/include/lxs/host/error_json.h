// The estimated error of an image, for statistics files.
#pragma once

#include <nlohmann/json.hpp>

#include "lxs/imaging/error_estimate.h"

namespace lxs {

/// docs/reference/statistics-file.md says what the keys mean.
inline nlohmann::ordered_json error_json(const ErrorEstimate& error) {
    nlohmann::ordered_json json;
    json["relative"] = error.relative();
    json["relmse"] = error.relmse;
    json["relmse interval"] = {error.relmse_low, error.relmse_high};
    json["relmse of the whole"] = error.relmse_whole;
    json["rmse"] = error.rmse;
    json["rmse interval"] = {error.rmse_low, error.rmse_high};
    return json;
}

}  // namespace lxs
