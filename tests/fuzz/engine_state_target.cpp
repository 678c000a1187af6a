// Fuzz target: the engine's saved state. The first byte chooses a render (mode, guide, radius,
// sampler, media), the rest damages the state that it has saved after two passes; what is not
// refused must go on within the memory bound and with an image that is one.
#include <cstdlib>
#include <map>
#include <memory>

#include "damaged_bytes.h"
#include "fuzz_target.h"
#include "input_files.h"
#include "resumable_render.h"

namespace {

using mock::ResumableCase;
using mock::ResumableRender;

struct SavedRender {
    ResumableCase what;
    mock::Bytes state;
    mock::Film film;
};

SavedRender after_two_passes(const ResumableCase& what) {
    ResumableRender render(what);
    render.render_to(2);
    return {what, render.save(), render.film()};
}

/// Small ones, with a number of photons per pass that no state can raise: a pass of 2^22 is
/// allowed, and takes seconds.
const std::vector<SavedRender>& saved_renders() {
    static const auto all = [] {
        std::vector<SavedRender> made;
        for (ResumableCase& what : mock::resumable_cases()) {
            what.width = 4;
            what.height = 3;
            what.settings.max_nodes = 32;
            what.settings.cdf_resolution = 4;
            if (what.settings.photons_per_pass == 0) continue;
            what.settings.photons_per_pass = 64;
            made.push_back(after_two_passes(what));
        }
        return made;
    }();
    return all;
}

void go_on(ResumableRender& render) {
    render.render_pass();
    for (const aips::Rgb& pixel : render.film().image()) {
        if (!is_valid_radiance(pixel)) std::abort();
    }
    const aips::EngineStatistics statistics = render.statistics();
    if (statistics.memory_bytes > statistics.memory_bound_bytes) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::InputBytes input(data, size);
    const SavedRender& saved = saved_renders()[input.below(saved_renders().size())];
    const bool whole = input.empty();
    try {
        ResumableRender render(saved.what, damaged_bytes(saved.state, input), saved.film);
        go_on(render);
    } catch (const aips::StateError& refusal) {
        if (whole) std::abort();
        fuzz::check_refusal(refusal);
    }
    return 0;
}
