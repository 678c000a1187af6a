// The paper's experiments as data: paper.json, with what is varied spelled out, at a scale.
#include "experiment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "study_file.h"

namespace bench {
namespace {

ExperimentKind read_kind(const std::string& name) {
    static const std::map<std::string, ExperimentKind> kinds{
        {"passes", ExperimentKind::Passes},
        {"convergence", ExperimentKind::Convergence},
        {"time", ExperimentKind::Time},
        {"distribution", ExperimentKind::Distribution}};
    const auto found = kinds.find(name);
    if (found == kinds.end()) throw StudyError(fmt::format("unknown kind \"{}\"", name));
    return found->second;
}

/// The guide's parameters as the paper sets them, for the methods that have that guide.
struct GuideSettings {
    std::vector<std::string> methods;
    Json values;

    bool has(const std::string& method) const {
        return std::find(methods.begin(), methods.end(), method) != methods.end();
    }
};

/// `parameter` (if it isn't empty) gets `value` instead of the paper's.
std::vector<std::string> guide_overrides(const GuideSettings& guide, const std::string& parameter,
                                         const Json& value) {
    std::vector<std::string> set;
    for (const auto& [name, own] : guide.values.items()) {
        const Json& chosen = name == parameter ? value : own;
        set.push_back(fmt::format("aips.{}={}", name, chosen.dump()));
    }
    return set;
}

PaperCase read_case(const Json& json, const std::string& baseline) {
    PaperCase found;
    found.name = json.at("name");
    found.label = json.at("label");
    found.method = json.at("method");
    found.set = json.value("set", std::vector<std::string>{});
    found.against = json.value("against", baseline);
    return found;
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

/// The case once for each value of what is varied.
std::vector<PaperCase> vary(const PaperCase& base, const Json& vary, const GuideSettings& guide) {
    const std::string parameter = vary.at("parameter");
    if (!guide.values.contains(parameter)) {
        throw StudyError(fmt::format("\"{}\" is no parameter of \"guide\"", parameter));
    }
    std::vector<PaperCase> cases;
    for (const Json& value : vary.at("values")) {
        PaperCase one = base;
        if (value != guide.values.at(parameter))
            one.name = fmt::format("{}-{}-{}", base.name, parameter, value.dump());
        one.label = fmt::format("{} {}", parameter, value.dump());
        append(one.set, guide_overrides(guide, parameter, value));
        cases.push_back(std::move(one));
    }
    return cases;
}

std::vector<PaperCase> read_cases(const Json& json, const GuideSettings& guide) {
    std::vector<PaperCase> cases;
    const Json varied = json.value("vary", Json());
    for (const Json& entry : json.at("cases")) {
        PaperCase one = read_case(entry, json.at("baseline"));
        if (!varied.is_null() && varied.at("case") == one.name) {
            const auto all = vary(one, varied, guide);
            cases.insert(cases.end(), all.begin(), all.end());
            continue;
        }
        if (guide.has(one.method)) append(one.set, guide_overrides(guide, "", {}));
        cases.push_back(std::move(one));
    }
    return cases;
}

Experiment read_experiment(const Json& json, const GuideSettings& guide) {
    Experiment experiment;
    experiment.figure = json.at("figure");
    experiment.title = json.at("title");
    experiment.kind = read_kind(json.at("kind"));
    experiment.study = json.at("study");
    experiment.part = json.value("part", "image");
    experiment.width_px = json.at("width_px");
    experiment.height_px = json.at("height_px");
    experiment.passes = json.value("passes", std::uint64_t{0});
    for (const Json& scene : json.at("scenes"))
        experiment.scenes.push_back({scene.at("name"), scene.value("seconds", 0.0)});
    experiment.cases = read_cases(json, guide);
    for (const PaperScene& scene : experiment.scenes) {
        if ((experiment.passes > 0) == (scene.seconds > 0)) {
            throw StudyError(fmt::format("figure {}, scene \"{}\": either passes or seconds",
                                         experiment.figure, scene.name));
        }
    }
    return experiment;
}

std::uint32_t scaled_side(std::uint32_t pixels, double scale) {
    return std::max(8u, std::uint32_t(std::lround(pixels * scale)));
}

}  // namespace

PaperTable read_paper_table(const std::filesystem::path& file) {
    const Json json = read_json(file);
    try {
        PaperTable table;
        table.photons_per_pass = json.at("photons_per_pass");
        const Json& guide = json.at("guide");
        const GuideSettings settings{guide.at("methods"), guide.at("set")};
        for (const Json& entry : json.at("experiments"))
            table.experiments.push_back(read_experiment(entry, settings));
        return table;
    } catch (const Json::exception& error) {
        throw StudyError(fmt::format("'{}': {}", file.string(), error.what()));
    } catch (const StudyError& error) {
        throw StudyError(fmt::format("'{}': {}", file.string(), error.what()));
    }
}

std::vector<Experiment> choose_experiments(const PaperTable& table,
                                           const std::vector<std::string>& figures) {
    if (figures.empty()) return table.experiments;
    std::vector<std::string> known;
    for (const Experiment& experiment : table.experiments)
        known.push_back(experiment.figure);
    std::vector<bool> chosen(known.size());
    for (const std::string& figure : figures) {
        bool found = false;
        for (std::size_t i = 0; i < known.size(); ++i) {
            if (!known[i].starts_with(figure)) continue;
            chosen[i] = found = true;
        }
        if (!found) {
            throw StudyError(
                fmt::format("unknown figure \"{}\"; known: {}", figure, fmt::join(known, ", ")));
        }
    }
    std::vector<Experiment> experiments;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (chosen[i]) experiments.push_back(table.experiments[i]);
    }
    return experiments;
}

Experiment scaled(Experiment experiment, double scale) {
    experiment.width_px = scaled_side(experiment.width_px, scale);
    experiment.height_px = scaled_side(experiment.height_px, scale);
    if (experiment.passes > 0) {
        experiment.passes =
            std::max<std::uint64_t>(2, std::uint64_t(std::llround(experiment.passes * scale)));
    }
    for (PaperScene& scene : experiment.scenes)
        scene.seconds *= scale;
    return experiment;
}

}  // namespace bench
