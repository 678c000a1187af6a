// Refused contributions by material.
#include "refusals.h"

namespace aips {

Refusals::Refusals(std::span<const std::string> material_names)
    : names_(material_names.begin(), material_names.end()),
      counts_(std::make_unique<std::atomic<std::uint64_t>[]>(names_.size() + 1)) {
    names_.emplace_back("(light)");
}

void Refusals::count(std::uint32_t material) {
    const std::size_t index = std::min<std::size_t>(material, names_.size() - 1);
    counts_[index].fetch_add(1, std::memory_order_relaxed);
}

void Refusals::state(StateArchive& archive) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
        std::uint64_t count = counts_[i].load();
        archive.value(count);
        counts_[i].store(count);
    }
}

std::uint64_t Refusals::total() const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < names_.size(); ++i)
        sum += counts_[i].load();
    return sum;
}

std::vector<std::pair<std::string, std::uint64_t>> Refusals::by_material() const {
    std::vector<std::pair<std::string, std::uint64_t>> found;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (const std::uint64_t n = counts_[i].load()) found.emplace_back(names_[i], n);
    }
    return found;
}

}  // namespace aips
