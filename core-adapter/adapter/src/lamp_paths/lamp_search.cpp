// Newton's method on the film.
#include "lamp_paths/lamp_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "aips/core/sampling/sampling.h"
#include "eye/constants.h"
#include "eye/eye_path.h"
#include "lamp_paths/constants.h"
#include "lamp_paths/lamp_ellipse.h"
#include "lamp_paths/smooth_chain.h"
#include "lamps/constants.h"

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

/// A step counts if what it misses the lamp by has come down to this share.
constexpr double kNearerBy = 0.9;

/// Farthest that a search goes from where it started (pixels).
constexpr double kFarthestRoot = 6;

/// Farthest that the first derivative may tell a lamp to be (pixels).
constexpr double kFarthestStart = 3;

/// Most searches from one place, through different surfaces or for different lamps.
constexpr std::size_t kMostTries = 4;

/// Most lamps that one place is asked for.
constexpr std::size_t kMostLampsOfPlace = 4;

/// A lamp is reached where its point is missed by less (radii of the lamp as seen from there).
constexpr double kLampReached = 0.5;

/// What choices that show an image are widened by, as probabilities of ways differ over it
/// (probability).
constexpr float kChoiceMargin = 0.02f;

/// Paths that look through an image before it is taken.
constexpr unsigned kImageLooks = 4;

/// Numbers of paths that look through images: a sequence that no other paths have.
constexpr std::uint64_t kLookSequence = ~std::uint64_t{1};

/// A lamp looked for from the end of a part of a chain.
struct Target {
    unsigned length = 0;  ///< surfaces
    LightIndex light = 0;
    Vec2 u;           ///< names the lamp's point
    double area = 0;  ///< about, of its image, pixels
};

/// Chains from other places than a search's start; made only where that shows a smooth surface.
struct OtherChains {
    ChainVertices right, below;  ///< where the first differences are taken
    ChainVertices last;          ///< of the last look
};

/// Where a chain's end looks, and where the lamp's point is.
struct Look {
    ChainVertex end;
    Vec3 to_lamp;
    double lamp_radius = 0;  ///< about, radians

    double miss() const { return double(length(end.direction - to_lamp)); }
    Plane miss_in(const Frame& frame) const { return difference(frame, end.direction, to_lamp); }
};

class Search {
  public:
    Search(const EyePassInput& input, const LampSearch& search, Refusals& refusals, Arena& arena)
        : in_(input),
          search_(search),
          refusals_(refusals),
          arena_(arena),
          random_(input.settings.seed, search.round, search.number, RandomDomain::LampSearch),
          tracer_(input, search.time, refusals, arena) {}

    void run(std::vector<LampImage>& images) {
        start_ = begin();
        chain_ = tracer_.explore(film(start_), random_, here_);
        for (const Target& target : targets()) {
            at_ = start_;
            if (!recall(target, here_, now_) || !approach(target)) continue;
            LampImage image =
                lamp_ellipse(in_, target.light, now_.end, derivative_, Frame(now_.to_lamp), at_);
            set_choices(target, image);
            if (in_.lamps->suits(image) && seen(image)) images.push_back(image);
        }
    }

    std::uint64_t rays() const { return tracer_.rays() + rays_; }

  private:
    /// Anywhere on the film, or around an image that is known: others are near it.
    Plane begin() {
        const std::span<const LampImage> known = in_.lamps->all();
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
        if (!sample_lamp(in_.scene, target.light, end.point, target.u, sample)) return false;
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

    /// All lamps, or some of them.
    std::vector<LightIndex> some_lights() {
        const auto& choice = in_.direct_light.choice();
        std::vector<LightIndex> lights;
        for (LightIndex i = 0; i < std::min(choice.size(), kMostLampsOfPlace); ++i) {
            const bool all = choice.size() <= kMostLampsOfPlace;
            const LightIndex light = all ? i : LightIndex(choice.sample(random_.next()).index);
            if (choice.pdf(light) > 0) lights.push_back(light);
        }
        return lights;
    }

    static Derivative derivative(const Look& now, const Look& right, const Look& below, double h) {
        const Frame frame(now.to_lamp);
        const Plane at = now.miss_in(frame);
        const Plane x = right.miss_in(frame), y = below.miss_in(frame);
        return {{(x.x - at.x) / h, (x.y - at.y) / h}, {(y.x - at.x) / h, (y.y - at.y) / h}};
    }

    static bool promises(const Look& now, const Derivative& derivative, Target& target) {
        const Plane miss = now.miss_in(Frame(now.to_lamp));
        const double step = derivative.step_for({-miss.x, -miss.y}).length();
        target.area =
            double(kPi) * now.lamp_radius * now.lamp_radius / std::abs(derivative.determinant());
        return step < kFarthestStart && target.area < kLargestImage &&
               dot(now.end.direction, now.to_lamp) > 0;
    }

    /// Goes on until the chain looks at the lamp; derivative_ is that at the root.
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
            if (now_.miss() < kLampReached * now_.lamp_radius) return true;
            const Plane miss = now_.miss_in(Frame(now_.to_lamp));
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
    void set_choices(const Target& target, LampImage& image) const {
        unsigned branches = in_.scene.media() ? kMostBranches : 0;
        std::size_t choice = 0;
        for (unsigned i = 0; i < target.length; ++i) {
            const SmoothChain::Link& link = chain_.links[i];
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
    bool seen(LampImage& image) {
        double sum = 0;
        std::vector<Rgb> lamps(in_.scene.light_groups());
        for (unsigned i = 0; i < kImageLooks; ++i) {
            const Vec2 disc = square_to_concentric_disk(random_.next2());
            const Vec2 a = random_.next2(), b = random_.next2();
            const LampDraw draw{image.film_at(disc), image.choices_at({a.x, a.y, b.x, b.y})};
            std::fill(lamps.begin(), lamps.end(), Rgb{});
            const EyeNumbers numbers(in_.settings.seed, kLookSequence,
                                     search_.number * std::uint64_t{kImageLooks} + i,
                                     search_.round);
            rays_ +=
                trace_lamp_path(in_, in_.camera.generate({draw.film, {0.5f, 0.5f}}, search_.time),
                                numbers.with(draw.choices), random_, refusals_, arena_, lamps);
            sum += double(luminance_over_groups(lamps, 0, std::uint32_t(lamps.size())));
        }
        image.luminance = float(sum / kImageLooks);
        return image.luminance > 0;
    }

    const EyePassInput& in_;
    const LampSearch& search_;
    Refusals& refusals_;
    Arena& arena_;
    RandomStream random_;
    ChainTracer tracer_;
    SmoothChain chain_;
    ChainVertices here_;  // of the start
    std::optional<OtherChains> others_;
    Plane start_, at_;
    Look now_;
    Derivative derivative_;
    std::uint64_t rays_ = 0;
};

}  // namespace

std::uint64_t search_lamps(const EyePassInput& input, const LampSearch& search, Refusals& refusals,
                           Arena& arena, std::vector<LampImage>& images) {
    Search s(input, search, refusals, arena);
    s.run(images);
    return s.rays();
}

}  // namespace aips
