// The table of a run: for people at a terminal, or as Markdown.
#pragma once

#include <string>
#include <vector>

#include "scene_set.h"
#include "settled_render.h"

namespace conformance {

/// What became of one scene with one integrator.
struct Row {
    std::string scene;
    std::string integrator;
    Spread limit;
    Comparison found;
    Spread noise;
    std::size_t passes = 0;
    double seconds = 0;
    bool settled = true;
    std::size_t refused = 0;  ///< negative or non-finite numbers in our image: none is allowed
    std::size_t reference_negatives = 0;
    std::vector<std::string> warnings;  ///< that the renderer gave
    std::string failure;                ///< why there is no image, or nothing

    /// Within the limits, every number finite and not negative.
    bool passes_limits() const;
};

enum class TableForm { Text, Markdown };

std::string table_head(TableForm form);
/// One line, ended.
std::string table_line(const Row& row, TableForm form);
/// How many passed, and notes on what the table can't show: images that did not settle, numbers
/// refused, warnings.
std::string table_notes(const std::vector<Row>& rows);

}  // namespace conformance
