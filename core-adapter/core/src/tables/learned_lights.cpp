// When tables of lights are made anew.
#include "aips/core/tables/learned_lights.h"

#include <utility>

namespace aips {

LearnedLights::LearnedLights(const Bounds& scene, const DiscreteDistribution& plain)
    : lights_(plain.size()), tables_(scene, plain, light_table_settings(plain.size())) {}

void LearnedLights::learn(std::span<const LightSample> samples, std::uint64_t due,
                          std::uint64_t passes) {
    if (!learns()) return;
    waiting_.insert(waiting_.end(), samples.begin(), samples.end());
    due_ += due;
    if (due_ < due_at_most()) return;
    for (const LightSample& sample : waiting_)
        tables_.add(sample);
    tables_.update(waiting_.size());
    learned_ += std::exchange(due_, 0);
    passes_before_ = passes;
    waiting_.clear();
    if (!learns()) waiting_.shrink_to_fit();
}

std::uint64_t LearnedLights::due_at_most() const {
    return learns() ? std::clamp(learned_ / 2, kFewestNewRays, kMostNewRays) : 1;
}

void LearnedLights::state(StateArchive& archive) {
    tables_.state(archive);
    archive.value(learned_);
    archive.value(passes_before_);
    archive.value(due_);
    StateArchive::check(due_ < due_at_most(), "shadow rays that would have been learned from");
    const std::size_t waiting = archive.count(waiting_.size(), 9 * sizeof(float));
    StateArchive::check(waiting <= due_, "more shadow rays than were to tell");
    waiting_.resize(waiting);
    for (LightSample& s : waiting_) {
        for (Vec3* v : {&s.position, &s.normal}) {
            for (float* x : {&v->x, &v->y, &v->z})
                archive.value(*x);
        }
        archive.value(s.light);
        archive.value(s.pdf);
        archive.value(s.value);
    }
}

void LearnedLights::learned(LearnedParts& parts) {
    parts.part("lights", lights_, [&](StateArchive& archive) {
        state(archive);
        if (archive.restoring()) begin_anew();
    });
}

void LearnedLights::begin_anew() {
    tables_.fade(double(kRememberedRays));
    learned_ = std::min(learned_, kRememberedRays);
    passes_before_ = due_ = 0;
    waiting_.clear();
}

std::size_t LearnedLights::memory_bytes() const {
    return tables_.memory_bytes() + waiting_.capacity() * sizeof(LightSample);
}

std::size_t LearnedLights::memory_bound_bytes(std::size_t lights) {
    return LightTables::memory_bound_bytes(light_table_settings(lights), lights);
}

}  // namespace aips
