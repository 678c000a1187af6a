// Statistics files of several renders of one scene, summed up.
#include "lxs/merge/statistics_sums.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "lxs/merge/merger.h"

namespace lxs {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSamples = "samples per pixel";
/// Objects within objects that a statistics file has, with some to spare: what is deeper is
/// dropped.
constexpr int kDeepest = 8;

constexpr const char* kMemory = "peak memory bytes";

/// What of a file is summed; all else is of one render alone.
constexpr const char* kSummed[] = {"seconds", "render CPU seconds",   kMemory,
                                   "counts",  "refused film samples", "refused",
                                   "account"};

[[noreturn]] void refuse(const std::string& name) {
    throw MergeRefusal(
        fmt::format("'{}' is no statistics file of a render of lxsrender or lxsmerge", name));
}

bool is_luminance(const std::string& key) {
    return key.starts_with("luminance ");
}

/// Scales the means within, so that sums of them are means again.
void scale_means(Json& json, double factor) {
    for (auto& [key, value] : json.items()) {
        if (value.is_structured())
            scale_means(value, factor);
        else if (value.is_number() && json.is_object() && is_luminance(key))
            value = value.get<double>() * factor;
    }
}

void add_number(Json& sum, const Json& value, const std::string& key) {
    if (key == kMemory)
        sum = std::max(sum.get<double>(), value.get<double>());
    else if (sum.is_number_unsigned() && value.is_number_unsigned())
        sum = sum.get<std::uint64_t>() + value.get<std::uint64_t>();
    else
        sum = sum.get<double>() + value.get<double>();
}

bool same_kind(const Json& a, const Json& b) {
    return (a.is_number() && b.is_number()) || a.type() == b.type();
}

/// Objects by key, lists of objects by place; of texts the first is kept, of lists of them all.
void add(Json& sum, const Json& value, const std::string& key, const std::string& name) {
    if (sum.is_null()) {
        sum = value;
        return;
    }
    if (!same_kind(sum, value)) refuse(name);
    if (value.is_number()) return add_number(sum, value, key);
    if (value.is_object()) {
        for (const auto& [inner, of_inner] : value.items())
            add(sum[inner], of_inner, inner, name);
    } else if (value.is_array() && key == "lights") {
        if (sum.size() != value.size())
            throw MergeRefusal(fmt::format("'{}' tells of another number of lights", name));
        for (std::size_t i = 0; i < value.size(); ++i)
            add(sum[i], value[i], {}, name);
    } else if (value.is_array()) {
        for (const Json& entry : value)
            if (std::ranges::find(sum, entry) == sum.end()) sum.push_back(entry);
    }
}

std::vector<std::uint64_t> seeds_of(const Json& file, const std::string& name) {
    const Json* const seeds = file.contains("seeds") ? &file["seeds"] : nullptr;
    std::vector<std::uint64_t> all;
    if (seeds && seeds->is_array()) {
        for (const Json& seed : *seeds)
            if (seed.is_number_unsigned()) all.push_back(seed.get<std::uint64_t>());
    } else if (file.contains("settings") && file["settings"].is_object()) {
        const Json seed = file["settings"].value("seed", Json());
        if (seed.is_number_unsigned()) all.push_back(seed.get<std::uint64_t>());
    }
    if (all.empty()) refuse(name);
    return all;
}

/// What a file says of the renders that it is of.
Json told_in(std::string_view text, const std::string& name) {
    const auto shallow = [](int depth, Json::parse_event_t, const Json&) {
        return depth <= kDeepest;
    };
    Json file = Json::parse(text, shallow, false);
    if (!file.is_object()) refuse(name);
    if (file.contains("renders") && file["renders"].is_object()) file = Json(file["renders"]);
    const bool counts = file.contains("counts") && file["counts"].is_object();
    const Json samples = counts ? file["counts"].value(kSamples, Json()) : Json();
    if (!samples.is_number() || !(samples.get<double>() > 0)) refuse(name);
    return file;
}

/// A second of wall time means nothing where renders may have run at one time.
void add_rates(Json& json) {
    const Json told = json.value("render CPU seconds", Json());
    const double seconds = told.is_number() ? told.get<double>() : 0;
    for (const char* what : {"photon paths", "rays"}) {
        Json& counts = json["counts"];
        if (seconds > 0 && counts.contains(what) && counts[what].is_number())
            counts[fmt::format("{} per CPU second", what)] = counts[what].get<double>() / seconds;
    }
}

}  // namespace

void StatisticsSums::add(std::string_view text, const std::string& name,
                         const std::vector<std::uint64_t>& seeds_of_images) {
    const Json file = told_in(text, name);
    const std::vector<std::uint64_t> seeds = seeds_of(file, name);
    for (const std::uint64_t seed : seeds) {
        if (std::ranges::find(seeds_of_images, seed) == seeds_of_images.end())
            throw MergeRefusal(
                fmt::format("'{}' is of seed {}, which none of the images holds", name, seed));
        const auto known = seeds_.find(seed);
        if (known != seeds_.end())
            throw MergeRefusal(
                fmt::format("'{}' and '{}' are both of seed {}", known->second, name, seed));
    }
    Json told = Json::object();
    for (const char* key : kSummed)
        if (file.contains(key)) told[key] = file[key];
    Json& counts = told["counts"];
    for (const char* what : {"photon paths", "rays"})
        for (const char* second : {"second", "CPU second"})
            counts.erase(fmt::format("{} per {}", what, second));
    scale_means(told, counts[kSamples].get<double>());
    Json sums = sums_;
    lxs::add(sums, told, {}, name);
    sums_ = std::move(sums);
    for (const std::uint64_t seed : seeds)
        seeds_.emplace(seed, name);
}

Json StatisticsSums::merged() const {
    Json json;
    for (const auto& [seed, name] : seeds_)
        json["seeds"].push_back(seed);
    json.update(sums_);
    scale_means(json, 1 / json["counts"][kSamples].get<double>());
    add_rates(json);
    return json;
}

}  // namespace lxs
