// Joins renders of one scene that differ in their seeds.
#include "lxs/merge/merger.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "lxs/imaging/error_figures.h"
#include "lxs/imaging/image_header.h"

namespace lxs {
namespace {

namespace header = image_header;

/// What all images must have alike, and what differs if they do not.
constexpr std::array<std::pair<const char*, const char*>, 4> kAlike = {{
    {header::kSceneText, "the text of the scene"},
    {header::kSceneFiles, "a mesh, texture or other file that the scene names"},
    {header::kIntegrator, "the integrator"},
    {header::kSettings, "a setting, or the size of the image"},
}};

/// How a channel of several renders becomes one.
enum class Rule : std::uint8_t { Mean, Error, Least };

Rule rule_of(const std::string& channel) {
    if (channel.starts_with("error.")) return Rule::Error;
    return channel == "depth.Z" ? Rule::Least : Rule::Mean;
}

constexpr double kFarthest = std::numeric_limits<double>::infinity();

float joined(Rule rule, double sum, double weight) {
    if (rule == Rule::Least) return static_cast<float>(sum);
    return static_cast<float>((rule == Rule::Error ? std::sqrt(sum) : sum) / weight);
}

const std::string& text_of(const ExrImage& image, const char* key, const std::string& name) {
    const auto found = image.metadata.find(key);
    if (found == image.metadata.end()) {
        throw MergeRefusal(
            fmt::format("'{}' does not say its {}; only images that lxsrender has "
                        "written can be merged",
                        name, key));
    }
    return found->second;
}

template <class Number>
Number number_of(const ExrImage& image, const char* key, const std::string& name) {
    const std::string& text = text_of(image, key, name);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || !(value > Number{0}) || !std::isfinite(static_cast<double>(value)))
        throw MergeRefusal(fmt::format("'{}' says '{}' of its {}", name, text, key));
    return value;
}

/// 0 where the image says nothing of it.
double of_bias(const ExrImage& image, const char* key, const std::string& name) {
    const auto found = image.metadata.find(key);
    if (found == image.metadata.end() || found->second == "0") return 0;
    return number_of<double>(image, key, name);
}

/// Numbers between single spaces; empty if that is not what it is.
std::vector<std::uint64_t> seeds_in(const std::string& text) {
    std::vector<std::uint64_t> seeds;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
        std::uint64_t seed = 0;
        const auto [next, error] = std::from_chars(at, end, seed);
        if (error != std::errc()) return {};
        seeds.push_back(seed);
        if (next == end) break;
        if (*next != ' ') return {};
        at = next + 1;
    }
    return seeds;
}

void check_values(const ExrImage& image, const std::string& name) {
    // The ids of a cryptomatte are no numbers, but none has the bits of a NaN or an infinity.
    for (const auto& [channel, values] : image.channels) {
        if (std::ranges::all_of(values, [](float value) { return std::isfinite(value); })) continue;
        throw MergeRefusal(
            fmt::format("'{}' holds a value in '{}' that is no number", name, channel));
    }
}

bool same(const FilmFrame& a, const FilmFrame& b) {
    return a.x_resolution == b.x_resolution && a.y_resolution == b.y_resolution && a.x == b.x &&
           a.y == b.y && a.width == b.width && a.height == b.height;
}

}  // namespace

struct Merger::Told {
    std::uint64_t passes = 0;
    double samples = 0;  // per pixel
    double freedom = 0;
    double relmse_of_bias = 0, rmse_of_bias = 0;
    std::vector<std::uint64_t> seeds;

    Told(const ExrImage& image, const std::string& name)
        : passes(number_of<std::uint64_t>(image, header::kPasses, name)),
          samples(number_of<double>(image, header::kSamples, name)) {
        const auto seed = image.metadata.find(header::kSeed);
        if (seed != image.metadata.end()) seeds = seeds_in(seed->second);
        if (seeds.empty()) throw MergeRefusal(fmt::format("'{}' does not say its seed", name));
        if (image.channels.contains("error.R"))
            freedom = number_of<double>(image, header::kErrorFreedom, name);
        relmse_of_bias = of_bias(image, header::kRelMseOfBias, name);
        rmse_of_bias = of_bias(image, header::kRmseOfBias, name);
    }
};

void Merger::check_layers(const ExrImage& image, const std::string& name) const {
    const auto lacks = [](const std::string& who, const std::string& channel,
                          const std::string& other) {
        throw MergeRefusal(
            fmt::format("'{}' has no channel '{}', which '{}' has", who, channel, other));
    };
    for (const auto& [channel, values] : image.channels)
        if (!sums_.contains(channel)) lacks(first_, channel, name);
    for (const auto& [channel, sums] : sums_)
        if (!image.channels.contains(channel)) lacks(name, channel, first_);
}

void Merger::check_seeds(const Told& told, const std::string& name) const {
    for (const std::uint64_t seed : told.seeds) {
        const auto known = seeds_.find(seed);
        if (known == seeds_.end()) continue;
        throw MergeRefusal(fmt::format(
            "'{}' and '{}' both hold seed {}: the same paths would count twice; render with "
            "another --seed",
            known->second, name, seed));
    }
}

void Merger::check(const ExrImage& image, const Told& told, const std::string& name) const {
    for (const auto& [key, what] : kAlike) {
        const std::string& said = text_of(image, key, name);
        if (images_ > 0 && said != common_.at(key)) {
            throw MergeRefusal(fmt::format("'{}' and '{}' are not renders of the same: {} differs",
                                           first_, name, what));
        }
    }
    check_seeds(told, name);
    if (images_ > 0 && !same(frame_, image.frame))
        throw MergeRefusal(fmt::format("'{}' and '{}' differ in size or window", first_, name));
    if (images_ > 0) check_layers(image, name);
    check_values(image, name);
}

void Merger::add_channel(const std::string& channel, const std::vector<float>& values,
                         double weight) {
    const Rule rule = rule_of(channel);
    std::vector<double>& sums = sums_[channel];
    if (sums.empty()) sums.assign(values.size(), rule == Rule::Least ? kFarthest : 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value{values[i]};
        switch (rule) {
            case Rule::Mean:
                sums[i] += weight * value;
                break;
            case Rule::Error:
                sums[i] += weight * weight * value * value;
                break;
            case Rule::Least:
                sums[i] = std::min(sums[i], value);
                break;
        }
    }
}

void Merger::add(const ExrImage& image, const std::string& name) {
    const Told told(image, name);
    check(image, told, name);
    if (images_ == 0) {
        first_ = name;
        frame_ = image.frame;
        common_ = image.metadata;
    }
    for (const auto& [channel, values] : image.channels)
        add_channel(channel, values, told.samples);
    for (const std::string& matte : MatteSums::names_in(image.metadata))
        mattes_[matte].add(image, matte, told.samples);
    for (const std::uint64_t seed : told.seeds)
        seeds_.emplace(seed, name);
    // Only what all say alike is true of them together.
    std::erase_if(common_, [&](const auto& entry) {
        const auto said = image.metadata.find(entry.first);
        return said == image.metadata.end() || said->second != entry.second;
    });
    weight_ += told.samples;
    freedom_ += told.freedom;
    relmse_of_bias_ += told.samples * told.relmse_of_bias;
    mse_of_bias_ += told.samples * told.rmse_of_bias * told.rmse_of_bias;
    passes_ += told.passes;
    ++images_;
}

std::vector<std::uint64_t> Merger::seeds() const {
    std::vector<std::uint64_t> seeds;
    for (const auto& [seed, name] : seeds_)
        seeds.push_back(seed);
    return seeds;
}

ExrImage Merger::merged() const {
    ExrImage image{frame_, {}, common_};
    for (const auto& [channel, sums] : sums_) {
        const Rule rule = rule_of(channel);
        std::vector<float>& values = image.channels[channel];
        values.reserve(sums.size());
        for (const double sum : sums)
            values.push_back(joined(rule, sum, weight_));
    }
    for (const auto& [name, matte] : mattes_)
        matte.write(image, name, weight_);
    image.metadata[header::kPasses] = fmt::to_string(passes_);
    image.metadata[header::kSamples] = fmt::to_string(weight_);
    image.metadata[header::kSeed] = fmt::format("{}", fmt::join(seeds(), " "));
    return image;
}

std::optional<ErrorEstimate> Merger::error() const {
    for (const char* needed : {"R", "G", "B", "error.R", "error.G", "error.B"})
        if (!sums_.contains(needed)) return std::nullopt;
    UncertainImage image{.width = frame_.width, .height = frame_.height};
    const std::size_t pixels = std::size_t{frame_.width} * frame_.height;
    image.value.resize(pixels);
    image.variance.resize(pixels);
    for (const auto& [name, c] : {std::pair{"R", 0}, {"G", 1}, {"B", 2}}) {
        const std::vector<double>& values = sums_.at(name);
        const std::vector<double>& squares = sums_.at(std::string("error.") + name);
        for (std::size_t i = 0; i < pixels; ++i) {
            image.value[i][c] = static_cast<float>(values[i] / weight_);
            image.variance[i][c] = static_cast<float>(squares[i] / (weight_ * weight_));
        }
    }
    image.degrees_of_freedom = freedom_;
    image.relmse_of_bias = relmse_of_bias_ / weight_;
    image.mse_of_bias = mse_of_bias_ / weight_;
    ErrorEstimate estimate = estimate_error(image);
    estimate.passes = passes_;
    return estimate;
}

}  // namespace lxs
