// Refused contributions by origin.
#include "sample_filter/invalid_sample_filter.h"

#include <algorithm>

namespace aips {

InvalidSampleFilter::InvalidSampleFilter()
    : counts_(std::make_unique<std::atomic<std::uint64_t>[]>(2)) {}

InvalidSampleFilter::InvalidSampleFilter(const Scene& scene)
    : scene_(&scene),
      materials_(static_cast<std::uint32_t>(scene.material_names().size())),
      lights_(static_cast<std::uint32_t>(scene.lights().size())),
      counts_(std::make_unique<std::atomic<std::uint64_t>[]>(materials_ + lights_ + 1)) {}

void InvalidSampleFilter::count(Origin origin, std::uint64_t times) {
    const std::uint32_t index = std::min(origin, materials_ + lights_);
    counts_[index].fetch_add(times, std::memory_order_relaxed);
}

std::vector<std::uint64_t> InvalidSampleFilter::counts() const {
    std::vector<std::uint64_t> counts(materials_ + lights_ + 1);
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] = counts_[i].load();
    return counts;
}

void InvalidSampleFilter::state(StateArchive& archive) {
    for (std::size_t i = 0; i <= materials_ + lights_; ++i) {
        std::uint64_t count = counts_[i].load();
        archive.value(count);
        counts_[i].store(count);
    }
}

std::uint64_t InvalidSampleFilter::total() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i <= materials_ + lights_; ++i)
        sum += counts_[i].load();
    return sum;
}

std::string InvalidSampleFilter::name_of(std::size_t index) const {
    if (index == materials_ + lights_) return "media or surfaces that light passes straight";
    if (!scene_) return "a material";
    if (index < materials_) return "material \"" + scene_->material_names()[index] + '"';
    const std::size_t light = index - materials_;
    const std::string name = scene_->lights()[light]->name();
    return "light " + std::to_string(light) + (name.empty() ? "" : " (" + name + ')');
}

std::vector<std::pair<std::string, std::uint64_t>> InvalidSampleFilter::by_origin() const {
    std::vector<std::pair<std::string, std::uint64_t>> found;
    for (std::size_t i = 0; i <= materials_ + lights_; ++i) {
        if (const std::uint64_t n = counts_[i].load()) found.emplace_back(name_of(i), n);
    }
    return found;
}

}  // namespace aips
