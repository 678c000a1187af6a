// Advice in plain words on what looks wrong with a render: found by rules, each a function.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lxs/host/image_verdict.h"
#include "lxs/host/render_session.h"

namespace lxs {

struct Advice {
    std::string_view rule;  ///< its name, as in the statistics file
    std::string text;       ///< what is wrong, and what to do; one or two sentences
};

/// Asks every rule (src/advice/advice_rules.h). Takes some ten thousand rays at most, once. What
/// the scene throws when asked ends the search: advice is never worth a render.
std::vector<Advice> advise(const RenderSession& session, const TransportStatistics& transport,
                           const ImageVerdict& image);

}  // namespace lxs
