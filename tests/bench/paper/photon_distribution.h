// Fig. 6 and 7 of the paper: where photons land, over the passes, in numbers and pictures.
#pragma once

#include <filesystem>

#include "experiment.h"
#include "reference_store.h"

namespace bench {

/// What the numbers of a scene are made from: all of its runs have the debug layers.
struct DistributionInput {
    const Experiment& experiment;
    std::string scene;
    const Json& runs;
    unsigned seeds = 1;
    std::filesystem::path study;   ///< folder of the runs
    std::filesystem::path images;  ///< folder for the PNGs, made if it is missing
    const References& references;
};

/// An entry of "distribution" in paper.json (docs/reference/benchmark-files.md). Writes the photon
/// density of the passes between snapshots of each case with the first seed as CASE.passes-A-B.png,
/// all with one exposure. Throws StudyError if a layer is missing, lxs::OutputFailure.
Json photon_distribution(const DistributionInput& input);

}  // namespace bench
