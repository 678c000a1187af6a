// Cryptomattes of several renders, joined. The format: Friedman and Jones, "Fully automatic ID
// mattes with support for motion blur and transparency", 2015; specification 1.2.
#include "lxs/merge/matte_sums.h"

#include <algorithm>
#include <bit>
#include <span>

namespace lxs {
namespace {

/// Of each rank the channel of its id, and that of its coverage behind it: R and G, then B and A.
std::vector<std::pair<std::string, std::string>> ranks_of(const ExrImage& image,
                                                          const std::string& name) {
    std::vector<std::pair<std::string, std::string>> ranks;
    for (const auto& [channel, values] : image.channels) {
        if (!MatteSums::has_channel(name, channel)) continue;
        const char last = channel.back();
        if (last != 'R' && last != 'B') continue;
        std::string coverage = channel;
        coverage.back() = last == 'R' ? 'G' : 'A';
        if (image.channels.contains(coverage)) ranks.emplace_back(channel, coverage);
    }
    // By layer, and R before B there.
    std::ranges::sort(ranks, [](const auto& a, const auto& b) {
        const auto key = [](const std::string& channel) {
            return std::pair(channel.substr(0, channel.size() - 1), channel.back() == 'B');
        };
        return key(a.first) < key(b.first);
    });
    return ranks;
}

}  // namespace

std::vector<std::string> MatteSums::names_in(const ImageMetadata& metadata) {
    std::vector<std::string> names;
    for (const auto& [key, value] : metadata)
        if (key.starts_with("cryptomatte/") && key.ends_with("/name")) names.push_back(value);
    return names;
}

bool MatteSums::has_channel(const std::string& name, const std::string& channel) {
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t end = name.size();
    return channel.size() == end + 4 && channel.starts_with(name) && digit(channel[end]) &&
           digit(channel[end + 1]) && channel[end + 2] == '.';
}

void MatteSums::add(const ExrImage& image, const std::string& name, double weight) {
    pixels_.resize(std::size_t{image.frame.width} * image.frame.height);
    for (const auto& [id_channel, coverage_channel] : ranks_of(image, name)) {
        const std::vector<float>& ids = image.channels.at(id_channel);
        const std::vector<float>& coverages = image.channels.at(coverage_channel);
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            if (!(coverages[i] > 0)) continue;
            const auto id = std::bit_cast<std::uint32_t>(ids[i]);
            const double share = weight * double{coverages[i]};
            const auto known = std::ranges::find(pixels_[i], id, &Share::first);
            if (known == pixels_[i].end()) {
                pixels_[i].emplace_back(id, share);
            } else {
                known->second += share;
            }
        }
    }
}

void MatteSums::write(ExrImage& image, const std::string& name, double all_weight) const {
    const auto ranks = ranks_of(image, name);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        std::vector<Share> shares = pixels_[i];
        std::ranges::sort(shares, [](const Share& a, const Share& b) {
            return a.second != b.second ? a.second > b.second : a.first < b.first;
        });
        shares.resize(ranks.size());  // beyond what was met: no id, no coverage
        for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
            const auto& [id, share] = shares[rank];
            image.channels[ranks[rank].first][i] = std::bit_cast<float>(id);
            image.channels[ranks[rank].second][i] = static_cast<float>(share / all_weight);
        }
    }
}

}  // namespace lxs
