// Newton's method on the film.
#include "emitter_paths/emitter_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "aips/core/sampling/sampling.h"
#include "emitter_images/constants.h"
#include "emitter_paths/constants.h"
#include "emitter_paths/emitter_ellipse.h"
#include "emitter_paths/specular_chain.h"
#include "eye/constants.h"
#include "eye/eye_path.h"

namespace aips {
namespace {

/// First step by which derivatives are taken (pixels).
constexpr double kFirstDifference = 0.01;

/// Most steps of a search.
constexpr int kMostSearchSteps = 8;

/// Longest step (pixels).
constexpr double kLongestStep = 2;

/// Most that a step is tried, half as long each time.
constexpr int kMostHalvedSteps = 4;

/// A step counts if what it misses the emitter by has come down to this share.
constexpr double kNearerBy = 0.9;

/// Farthest that a search goes from where it started (pixels).
constexpr double kFarthestRoot = 6;

/// Farthest that the first derivative may tell an emitter to be (pixels).
constexpr double kFarthestStart = 3;

/// Most searches from one place, through different surfaces or for different emitters.
constexpr std::size_t kMostTries = 4;

/// Most emitters that one place is asked for.
constexpr std::size_t kMostEmittersOfPlace = 4;

/// An emitter is reached where its point is missed by less (radii of the emitter as seen from
/// there).
constexpr double kEmitterReached = 0.5;

/// What choices that show an image are widened by, as probabilities of ways differ over it
/// (probability).
constexpr float kChoiceMargin = 0.02f;

/// Paths that look through an image before it is taken.
constexpr unsigned kImageLooks = 4;

/// Numbers of paths that look through images: a sequence that no other paths have.
constexpr std::uint64_t kLookSequence = ~std::uint64_t{1};

/// An emitter looked for from the end of a part of a chain.
struct Target {
    unsigned length = 0;  ///< surfaces
    LightIndex light = 0;
    Vec2 u;           ///< names the emitter's point
    double area = 0;  ///< about, of its image, pixels
};

/// Chains from other places than a search's start; made only where that shows a specular surface.
struct OtherChains {
    ChainVertices right, below;  ///< where the first differences are taken
    ChainVertices last;          ///< of the last look
};

/// Where a chain's end looks, and where the emitter's point is.
struct Look {
    ChainVertex end;
    Vec3 to_emitter;
    double emitter_radius = 0;  ///< about, radians

    double miss() const { return double(length(end.direction - to_emitter)); }
    Plane miss_in(const Frame& frame) const { return difference(frame, end.direction, to_emitter); }
};

class Search {
  public:
    Search(const EyePassInput& input, const EmitterSearch& search, InvalidSampleFilter& filter,
           Arena& arena)
        : in_(input),
          search_(search),
          filter_(filter),
          arena_(arena),
          random_(input.settings.seed, search.round, search.number, RandomDomain::EmitterSearch),
          tracer_(input, search.time, filter, arena) {}

    void run(std::vector<EmitterImage>& images) {
        start_ = begin();
        chain_ = tracer_.explore(film(start_), random_, here_);
        for (const Target& target : targets()) {
            at_ = start_;
            if (!recall(target, here_, now_) || !approach(target)) continue;
            EmitterImage image = emitter_ellipse(in_, target.light, now_.end, derivative_,
                                                 Frame(now_.to_emitter), at_);
            set_choices(target, image);
            if (in_.emitters->suits(image) && seen(image)) images.push_back(image);
        }
    }

    std::uint64_t rays() const { return tracer_.rays() + rays_; }

  private:
    /// Anywhere on the film, or around an image that is known: others are near it.
    Plane begin() {
        const std::span<const EmitterImage> known = in_.emitters->all();
        const Vec2 u = random_.next2();
        if (known.empty() || random_.next() >= kNearKnown)
            return {double(u.x) * in_.width, double(u.y) * in_.height};
        const auto i =
            std::min(std::size_t(random_.next() * float(known.size())), known.size() - 1);
        const Vec2 step = square_to_concentric_disk(u), at = known[i].centre;
        return {double(at.x + kNearReach * step.x), double(at.y + kNearReach * step.y)};
    }

    static Vec2 film(Plane at) { return {float(at.x), float(at.y)}; }

    bool aim(const Target& target, const ChainVertex& end, Look& look) const {
        DirectSample sample;
        if (!sample_emitter(in_.scene, target.light, end.point, target.u, sample)) return false;
        look = {end, sample.wi, 1 / std::sqrt(double(kPi) * double(sample.pdf))};
        return true;
    }

    bool look(const Target& target, Plane at, Look& look) {
        return tracer_.follow(chain_, target.length, film(at), others_->last) == target.length &&
               aim(target, others_->last[target.length - 1], look);
    }

    /// look() from the start, or from where derivatives are taken there: the chain is known.
    bool recall(const Target& target, const ChainVertices& vertices, Look& look) {
        tracer_.recall(chain_, target.length, vertices);
        return aim(target, vertices[target.length - 1], look);
    }

    /// What the chain may look at from somewhere near, largest images first.
    std::vector<Target> targets() {
        std::vector<Target> targets;
        if (chain_.length == 0 || in_.direct_light.choice().empty()) return targets;
        others_.emplace();
        const double h = kFirstDifference;
        unsigned most =
            tracer_.follow(chain_, chain_.length, film({start_.x + h, start_.y}), others_->right);
        most = tracer_.follow(chain_, most, film({start_.x, start_.y + h}), others_->below);
        for (unsigned i = 0; i < most; ++i) {
            for (const LightIndex light : some_lights()) {
                Target target{i + 1, light, random_.next2(), 0};
                Look now, x, y;
                if (!aim(target, here_[i], now) || !aim(target, others_->right[i], x) ||
                    !aim(target, others_->below[i], y)) {
                    continue;
                }
                if (promises(now, derivative(now, x, y, h), target)) targets.push_back(target);
            }
        }
        std::ranges::stable_sort(targets, std::greater(), &Target::area);
        targets.resize(std::min(targets.size(), kMostTries));
        return targets;
    }

    /// All emitters, or some of them.
    std::vector<LightIndex> some_lights() {
        const auto& choice = in_.direct_light.choice();
        std::vector<LightIndex> lights;
        for (LightIndex i = 0; i < std::min(choice.size(), kMostEmittersOfPlace); ++i) {
            const bool all = choice.size() <= kMostEmittersOfPlace;
            const LightIndex light = all ? i : LightIndex(choice.sample(random_.next()).index);
            if (choice.pdf(light) > 0) lights.push_back(light);
        }
        return lights;
    }

    static Derivative derivative(const Look& now, const Look& right, const Look& below, double h) {
        const Frame frame(now.to_emitter);
        const Plane at = now.miss_in(frame);
        const Plane x = right.miss_in(frame), y = below.miss_in(frame);
        return {{(x.x - at.x) / h, (x.y - at.y) / h}, {(y.x - at.x) / h, (y.y - at.y) / h}};
    }

    static bool promises(const Look& now, const Derivative& derivative, Target& target) {
        const Plane miss = now.miss_in(Frame(now.to_emitter));
        const double step = derivative.step_for({-miss.x, -miss.y}).length();
        target.area = double(kPi) * now.emitter_radius * now.emitter_radius /
                      std::abs(derivative.determinant());
        return step < kFarthestStart && target.area < kLargestImage &&
               dot(now.end.direction, now.to_emitter) > 0;
    }

    /// Goes on until the chain looks at the emitter; derivative_ is that at the root.
    bool approach(const Target& target) {
        double h = kFirstDifference;
        for (int step = 0; step < kMostSearchSteps; ++step) {
            Look right, below;
            const bool there = step == 0 ? recall(target, others_->right, right) &&
                                               recall(target, others_->below, below)
                                         : look(target, {at_.x + h, at_.y}, right) &&
                                               look(target, {at_.x, at_.y + h}, below);
            if (!there) return false;
            derivative_ = derivative(now_, right, below, h);
            if (now_.miss() < kEmitterReached * now_.emitter_radius) return true;
            const Plane miss = now_.miss_in(Frame(now_.to_emitter));
            if (!go(target, derivative_.step_for({-miss.x, -miss.y}), h)) return false;
        }
        return false;
    }

    /// As much of a step as brings the path nearer.
    bool go(const Target& target, Plane step, double& h) {
        const double length = step.length();
        if (!(length > 0) || !std::isfinite(length)) return false;
        double share = std::min(1.0, kLongestStep / length);
        for (int halving = 0; halving < kMostHalvedSteps; ++halving, share *= 0.5) {
            const Plane next{at_.x + share * step.x, at_.y + share * step.y};
            if (std::hypot(next.x - start_.x, next.y - start_.y) > kFarthestRoot) continue;
            Look there;
            if (!look(target, next, there) || !(there.miss() < kNearerBy * now_.miss())) continue;
            at_ = next;
            now_ = there;
            h = std::clamp(0.1 * share * length, least_difference(in_), kFirstDifference);
            return true;
        }
        return false;
    }

    /// Choices that EyePath will take from the image's coordinates.
    void set_choices(const Target& target, EmitterImage& image) const {
        unsigned branches = in_.scene.media() ? kMostBranches : 0;
        std::size_t choice = 0;
        for (unsigned i = 0; i < target.length; ++i) {
            const SpecularChain::Link& link = chain_.links[i];
            if (!(link.first > 0)) continue;
            if (branches < kMostBranches) {
                ++branches;
            } else if (choice < image.low.size()) {
                float& end = link.takes_first ? image.high[choice] : image.low[choice];
                end = std::clamp(link.first + (link.takes_first ? kChoiceMargin : -kChoiceMargin),
                                 0.0f, 1.0f);
                ++choice;
            }
        }
    }

    /// Looks through it.
    bool seen(EmitterImage& image) {
        double sum = 0;
        std::vector<Rgb> emitters(in_.scene.light_groups());
        for (unsigned i = 0; i < kImageLooks; ++i) {
            const Vec2 disc = square_to_concentric_disk(random_.next2());
            const Vec2 a = random_.next2(), b = random_.next2();
            const EmitterDraw draw{image.film_at(disc), image.choices_at({a.x, a.y, b.x, b.y})};
            std::fill(emitters.begin(), emitters.end(), Rgb{});
            const EyeNumbers numbers(in_.settings.seed, kLookSequence,
                                     search_.number * std::uint64_t{kImageLooks} + i,
                                     search_.round);
            rays_ += trace_emitter_path(
                in_, in_.camera.generate({draw.film, {0.5f, 0.5f}}, search_.time),
                numbers.with(draw.choices), random_, filter_, arena_, emitters);
            sum += double(luminance_over_groups(emitters, 0, std::uint32_t(emitters.size())));
        }
        image.luminance = float(sum / kImageLooks);
        return image.luminance > 0;
    }

    const EyePassInput& in_;
    const EmitterSearch& search_;
    InvalidSampleFilter& filter_;
    Arena& arena_;
    RandomStream random_;
    ChainTracer tracer_;
    SpecularChain chain_;
    ChainVertices here_;  // of the start
    std::optional<OtherChains> others_;
    Plane start_, at_;
    Look now_;
    Derivative derivative_;
    std::uint64_t rays_ = 0;
};

}  // namespace

std::uint64_t search_emitters(const EyePassInput& input, const EmitterSearch& search,
                              InvalidSampleFilter& filter, Arena& arena,
                              std::vector<EmitterImage>& images) {
    Search s(input, search, filter, arena);
    s.run(images);
    return s.rays();
}

}  // namespace aips
