// The estimated error of an image, for statistics files.
#pragma once

#include <nlohmann/json.hpp>

#include "lxs/imaging/error_estimate.h"

namespace lxs {

/// docs/reference/statistics.md says what the keys mean.
inline nlohmann::ordered_json error_json(const ErrorEstimate& error) {
    nlohmann::ordered_json json;
    json["relative"] = error.relative();
    json["relmse"] = error.relmse;
    json["relmse interval"] = {error.relmse_low, error.relmse_high};
    json["relmse of the whole"] = error.relmse_whole;
    json["relmse of bias"] = error.relmse_of_bias;
    json["rmse"] = error.rmse;
    json["rmse interval"] = {error.rmse_low, error.rmse_high};
    json["rmse of the whole"] = error.rmse_whole;
    json["rmse of bias"] = error.rmse_of_bias;
    return json;
}

}  // namespace lxs
