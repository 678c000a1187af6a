// Eye paths that are new in each pass, and those that are frozen.
#include "eye/eye_source.h"

#include <algorithm>
#include <limits>

#include "aips/core/sampling/random.h"
#include "eye/constants.h"

namespace aips {
namespace {

float moment(const EyePassInput& input, std::uint64_t pass) {
    RandomStream random(input.settings.seed, pass, 0, RandomDomain::Time);
    const float open = input.camera.shutter_open();
    return open + (input.camera.shutter_close() - open) * random.next();
}

class RenewedEyePaths : public EyeSource {
  public:
    explicit RenewedEyePaths(const EyePassInput& input) : input_(input) {}

    std::uint32_t look(std::uint64_t pass, InvalidSampleFilter& filter, EyeImage& image) override {
        trace_eye_pass(input_, pass, time(pass), filter, image);
        return input_.paths;
    }
    const EyePassInput& input() const override { return input_; }
    float time(std::uint64_t pass) const override { return moment(input_, pass); }
    void restore(std::uint64_t /*passes*/, EyeImage& /*image*/) override {}

  private:
    EyePassInput input_;
};

/// Frozen visible points stay where their surfaces were, so that all photons meet the scene of that
/// moment.
class FrozenEyePaths : public EyeSource {
  public:
    explicit FrozenEyePaths(const EyePassInput& input) : input_(input) {}

    std::uint32_t look(std::uint64_t /*pass*/, InvalidSampleFilter& filter,
                       EyeImage& image) override {
        if (traced_) return 0;
        trace(filter, image);
        return input_.paths;
    }
    const EyePassInput& input() const override { return input_; }
    float time(std::uint64_t /*pass*/) const override { return moment(input_, 0); }
    void restore(std::uint64_t passes, EyeImage& image) override {
        if (passes == 0) return;
        InvalidSampleFilter counted_before(input_.scene);
        trace(counted_before, image);
    }

  private:
    void trace(InvalidSampleFilter& filter, EyeImage& image) {
        trace_eye_pass(input_, 0, time(0), filter, image);
        traced_ = true;
    }

    EyePassInput input_;
    bool traced_ = false;
};

}  // namespace

std::unique_ptr<EyeSource> make_eye_source(const EyePassInput& input) {
    if (freezes_eye_pass(input.settings.mode)) return std::make_unique<FrozenEyePaths>(input);
    return std::make_unique<RenewedEyePaths>(input);
}

std::uint32_t eye_paths_per_pass(const Settings& settings, std::uint64_t pixels) {
    if (settings.hit_points_per_pass) return settings.hit_points_per_pass;
    const std::uint64_t paths =
        freezes_eye_pass(settings.mode) ? pixels * kFrozenPathsPerPixel : pixels;
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(paths, kMost));
}

}  // namespace aips
