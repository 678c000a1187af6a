// The engine on LuxRender's scene: settings from its parameters, and the passes.
#include "engine_run.h"

#include <tbb/task_arena.h>

#include <stdexcept>

#include "aips/adapter/engine.h"
#include "aips/parts/sobol_sampler.h"
#include "film_shim.h"
#include "parameters.h"
#include "pass_wavelengths.h"
#include "scene_shim.h"

namespace aips::luxrender {
namespace {

using Type = GivenParameter::Type;

/// LuxRender's reader gives no places: messages name the parameter alone.
class ViewDiagnostics final : public lxs::Diagnostics {
  public:
    explicit ViewDiagnostics(LuxView& view) : view_(view) {}
    void warning(const lxs::SourceLocation&, const std::string& message) override {
        view_.warning(message);
    }
    void unknown_parameter(const lxs::SourceLocation&, const std::string& message) override {
        view_.warning(message);
    }

  private:
    LuxView& view_;
};

Type type_of(lxs::ParameterType type) {
    switch (type) {
        case lxs::ParameterType::Integer:
            return Type::Integer;
        case lxs::ParameterType::Bool:
            return Type::Bool;
        case lxs::ParameterType::String:
            return Type::String;
        default:
            return Type::Float;
    }
}

lxs::ParameterValue value_of(const GivenParameter& given) {
    lxs::ParameterValue value;
    value.name = given.name;
    switch (given.type) {
        case Type::Float:
            value.type = "float";
            value.values = std::vector<double>{given.number};
            break;
        case Type::Integer:
            value.type = "integer";
            value.values = std::vector<double>{given.number};
            break;
        case Type::Bool:
            value.type = "bool";
            value.values = std::vector<bool>{given.number != 0};
            break;
        case Type::String:
            value.type = "string";
            value.values = std::vector<std::string>{given.text};
            break;
    }
    return value;
}

Settings settings_of(LuxView& view, const std::vector<GivenParameter>& given) {
    lxs::ParameterSet set;
    set.plugin = "aips";
    for (const GivenParameter& parameter : given)
        set.values.push_back(value_of(parameter));
    ViewDiagnostics diagnostics(view);
    const lxs::ParameterReader reader(set, parameter_declarations(PluginKind::Aips), diagnostics);
    Settings settings = read_settings(PluginKind::Aips, reader);
    validate(settings);
    if (freezes_eye_pass(settings.mode)) {
        throw std::invalid_argument(
            "mode \"photonmap\" does not go with LuxRender, whose passes have wavelengths of "
            "their own; leave \"progressive\"");
    }
    return settings;
}

class Run final : public EngineRun {
  public:
    /// Wavelengths go by the seed given, as those of a resumed film go on.
    Run(LuxView& view, const Settings& settings, std::uint64_t seed_given,
        std::uint64_t passes_before)
        : view_(view),
          passes_before_(passes_before),
          wavelengths_(view, seed_given),
          scene_(view, wavelengths_),
          camera_(view),
          sampler_(settings.seed),
          film_(view),
          log_(view),
          engine_({scene_, camera_, sampler_, film_, log_}, settings) {}

    void render_pass(unsigned threads) override {
        const PassWavelengths::Drawn drawn = wavelengths_.of_pass(passes_before_ + pass_);
        view_.set_wavelengths(drawn.nanometres, drawn.per_density);
        tbb::task_arena arena(static_cast<int>(threads));
        arena.execute([&] { engine_.render_pass(pass_); });
        ++pass_;
    }
    std::uint64_t photon_paths() const override { return engine_.statistics().photon_paths; }
    std::vector<std::string> refused() const override {
        std::vector<std::string> lines;
        for (const auto& [origin, count] : engine_.statistics().refused)
            lines.push_back(std::to_string(count) + " from " + origin);
        return lines;
    }

  private:
    LuxView& view_;
    std::uint64_t passes_before_, pass_ = 0;
    PassWavelengths wavelengths_;
    SceneShim scene_;
    CameraShim camera_;
    /// LuxRender's samplers go their own way through the film.
    SobolSampler sampler_;
    FilmShim film_;
    LogShim log_;
    Engine engine_;
};

}  // namespace

std::vector<KnownParameter> known_parameters() {
    std::vector<KnownParameter> known;
    for (const lxs::ParameterDeclaration& p : parameter_declarations(PluginKind::Aips))
        known.push_back({type_of(p.type), std::string(p.name)});
    return known;
}

std::unique_ptr<EngineRun> start_engine(LuxView& view, const std::vector<GivenParameter>& given,
                                        std::uint64_t passes_before) {
    Settings settings = settings_of(view, given);
    const std::uint64_t seed_given = settings.seed;
    // What a resumed film has came from other numbers than what is added.
    settings.seed += passes_before * 0x9E3779B97F4A7C15u;
    return std::make_unique<Run>(view, settings, seed_given, passes_before);
}

}  // namespace aips::luxrender
