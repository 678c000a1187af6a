// Messages on what is left out.
#include "plan/skip_log.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace aips {
namespace {

/// Photon paths after which the log says what the adaptive guide prunes.
constexpr std::uint64_t kPruningPaths = 1'000'000;

/// Change of what eye paths carry of the light that both can that the log tells of.
constexpr double kSaidChange = 0.1;

std::string percent(double share) {
    return std::to_string(std::lround(100 * share)) + " %";
}

std::string two_decimals(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(2) << value;
    return text.str();
}

}  // namespace

void log_skipped(const Needs& needs, Log& log) {
    for (const std::string& skipped : needs.skipped)
        log.info("skipped " + skipped);
}

void SkipLog::say(const std::string& text) {
    log_->info(text);
    constexpr std::string_view kSkipped = "skipped ";
    constexpr std::size_t kMostSaid = 64;  // parts may go off and on for as long as a render lasts
    if (text.starts_with(kSkipped) && said_.size() < kMostSaid)
        said_.push_back(text.substr(kSkipped.size()));
}

void SkipLog::no_visible_points(bool for_good) {
    if (said_no_points_) return;
    said_no_points_ = true;
    say(for_good ? "skipped photon passes: no eye path met a surface that takes photons"
                 : "skipped photons of a pass: no eye path met a surface that takes them; "
                   "so in each pass where none does");
}

void SkipLog::left_out_guide(const SeenPaths& seen) {
    say("skipped the guide: " + percent(seen.near_share()) +
        " of the photon paths come near what is seen without it");
}

void SkipLog::explored(const Exploration& exploration) {
    const std::string paths = std::to_string(exploration.paths) + " photon paths ";
    say(exploration.starts.empty() ? "explored: none of " + paths + "is seen"
                                   : "explored: " + paths + "told where those start that are seen");
}

void SkipLog::say_switch(bool off, bool& was_off, const std::string& part, double gain) {
    if (off == was_off) return;
    was_off = off;
    say(off ? "skipped " + part + " for now: too little is gained, " + two_decimals(gain)
            : part + " is back: it gains " + two_decimals(gain));
}

void SkipLog::planned(const PassPlan& plan) {
    const double part = plan.going_on * plan.eye_share;
    if (std::abs(part - said_eye_part_) < kSaidChange) return;
    said_eye_part_ = part;
    say(describe(plan));
}

void SkipLog::after_pass(const AdaptiveGuide* guide, const PhotonCounts& photons) {
    if (!guide) return;
    const EmissionGuide& emission = guide->emission_guide();
    say_switch(emission.switched_off(), emission_off_, "guided emission", emission.gain());
    say_switch(guide->survival_switched_off(), survival_off_, "survival by score",
               guide->survival_gain());
    if (guide->seeding_given_up() && !said_no_seeds_) {
        said_no_seeds_ = true;
        say("skipped eye seeding from here on: no walk found where a light emits to it");
    }
    if (guide->disabled() != disabled_) {
        disabled_ = guide->disabled();
        if (disabled_) say("skipped the guide's learning, but for trials: no part of it pays");
    }
    if (photons.paths >= kPruningPaths && !said_pruned_) {
        said_pruned_ = true;
        say("pruned: " + percent(emission.starved_share(kPrunedDensity)) +
            " of what lights emit gets under a quarter of its photons, " +
            percent(double(photons.pruned) / double(photons.paths)) +
            " of the photon paths were ended by their score");
    }
}

void SkipLog::state(StateArchive& archive) {
    for (bool* said : {&said_no_points_, &said_no_seeds_, &said_pruned_, &emission_off_,
                       &survival_off_, &disabled_})
        archive.value(*said);
    archive.value(said_eye_part_);
    StateArchive::check(said_eye_part_ >= 0 && said_eye_part_ <= 1,
                        "a share of light that is none");
}

}  // namespace aips
