// Invalid samples of a path by origin.
#include "path/path_sample_filter.h"

#include <fmt/format.h>

#include <algorithm>

namespace lxs {

PathSampleFilter::PathSampleFilter(const Scene& scene)
    : scene_(scene),
      materials_(scene.material_names().size()),
      lights_(scene.lights().size()),
      counts_(std::make_unique<std::atomic<std::uint64_t>[]>(materials_ + lights_ + 1)) {}

bool PathSampleFilter::accept(bool usable, std::size_t index) {
    if (!usable) counts_[index].fetch_add(1, std::memory_order_relaxed);
    return usable;
}

bool PathSampleFilter::accept_of_material(bool usable, std::uint32_t material) {
    return accept(usable, std::min<std::size_t>(material, materials_ + lights_));
}

bool PathSampleFilter::accept_of_light(bool usable, const Light& light) {
    if (usable) return true;
    const auto lights = scene_.lights();
    const auto index = std::find(lights.begin(), lights.end(), &light) - lights.begin();
    return accept(false, materials_ + static_cast<std::size_t>(index));
}

bool PathSampleFilter::accept_of_passage(bool usable) {
    return accept(usable, materials_ + lights_);
}

std::uint64_t PathSampleFilter::total() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i <= materials_ + lights_; ++i)
        sum += counts_[i].load(std::memory_order_relaxed);
    return sum;
}

InvalidSampleList PathSampleFilter::list() const {
    InvalidSampleList list;
    for (std::size_t i = 0; i <= materials_ + lights_; ++i) {
        const std::uint64_t count = counts_[i].load(std::memory_order_relaxed);
        if (count == 0) continue;
        if (i < materials_) {
            list.push_back({fmt::format("material \"{}\"", scene_.material_names()[i]), count});
        } else if (i < materials_ + lights_) {
            const std::size_t light = i - materials_;
            list.push_back(
                {fmt::format("light {} ({})", light, scene_.lights()[light]->kind()), count});
        } else {
            list.push_back({"media or surfaces that light passes straight", count});
        }
    }
    return list;
}

void PathSampleFilter::state(StateArchive& archive) {
    for (std::size_t i = 0; i <= materials_ + lights_; ++i) {
        std::uint64_t count = counts_[i].load(std::memory_order_relaxed);
        archive.value(count);
        counts_[i].store(count, std::memory_order_relaxed);
    }
}

}  // namespace lxs
