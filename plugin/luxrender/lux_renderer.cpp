// LuxRender's Renderer and SurfaceIntegrator "aips".
#include "lux_renderer.h"

#include <chrono>
#include <thread>

#include "context.h"
#include "error.h"
#include "integrators/emission.h"
#include "integrators/none.h"
#include "paramset.h"
#include "randomgen.h"
#include "volumes/heterogeneous.h"

namespace aips::luxrender {
namespace {

/// A volume that varies may scatter anywhere: none is taken for one that only absorbs.
bool scatters(const lux::Volume* volume) {
    if (!volume) return false;
    if (dynamic_cast<const lux::HeterogeneousVolume*>(volume)) return true;
    luxrays::SpectrumWavelengths wavelengths;
    wavelengths.Sample(0.5f);
    lux::DifferentialGeometry anywhere;
    return !volume->SigmaS(wavelengths, anywhere).Black();
}

/// Whether LuxRender would let volumes scatter light, and there are such.
bool has_scattering(const lux::Scene& scene) {
    const lux::VolumeIntegrator* const integrator = scene.volumeIntegrator;
    if (dynamic_cast<const lux::EmissionIntegrator*>(integrator) ||
        dynamic_cast<const lux::NoneScattering*>(integrator)) {
        return false;
    }
    if (scatters(scene.camera()->GetVolume())) return true;
    for (const auto& light : scene.lights)
        if (scatters(light->GetVolume())) return true;
    for (const auto& primitive : scene.primitives)
        if (scatters(primitive->GetExterior()) || scatters(primitive->GetInterior())) return true;
    return false;
}

std::vector<GivenParameter> parameters_of(const lux::ParamSet& set) {
    using Type = GivenParameter::Type;
    std::vector<GivenParameter> given;
    for (const KnownParameter& known : known_parameters()) {
        GivenParameter found{known.type, known.name, 0, {}};
        u_int count = 0;
        const auto take = [&](const auto* values) {
            if (!values || count == 0) return false;
            found.number = double(values[0]);
            return true;
        };
        bool is_given = false;
        if (known.type == Type::Float) is_given = take(set.FindFloat(known.name, &count));
        if (known.type == Type::Integer) is_given = take(set.FindInt(known.name, &count));
        if (known.type == Type::Bool) is_given = take(set.FindBool(known.name, &count));
        if (known.type == Type::String) {
            const std::string* text = set.FindString(known.name, &count);
            is_given = text && count > 0;
            if (is_given) found.text = *text;
        }
        if (is_given) given.push_back(found);
    }
    return given;
}

/// Writes the image and ends the render: LuxRender would ask its nodes for their samples first, and
/// wait for ever for one that doesn't know aips.
void leave_nodes(lux::Film& film) {
    LOG(LUX_SEVERE, LUX_CONSISTENCY)
        << "\"aips\" renders on one machine: the render ends as network nodes join";
    film.WriteImage(lux::ImageType(lux::IMAGE_FINAL | lux::IMAGE_ALL));
    lux::Context::GetActive()->Abort();
}

}  // namespace

void LuxIntegrator::Preprocess(const lux::RandomGenerator&, const lux::Scene&) {
    LOG(LUX_SEVERE, LUX_CONSISTENCY)
        << "SurfaceIntegrator \"aips\" needs Renderer \"aips\" beside it: nothing is rendered";
    // The renderer that calls this holds a lock that ending it takes.
    std::thread([] { lux::Context::GetActive()->Abort(); }).detach();
}

lux::SurfaceIntegrator* LuxIntegrator::CreateSurfaceIntegrator(const lux::ParamSet& parameters) {
    return new LuxIntegrator(parameters_of(parameters));
}

/// The processors of this machine, as LuxRender adds and removes its threads.
class LuxRenderer::Device final : public lux::RendererDeviceDescription {
  public:
    explicit Device(LuxStatistics& statistics) : statistics_(statistics) {}
    const std::string& GetName() const override { return name_; }
    unsigned GetAvailableUnitsCount() const override {
        return std::max(std::thread::hardware_concurrency(), 1u);
    }
    unsigned GetUsedUnitsCount() const override { return statistics_.threads; }
    void SetUsedUnitsCount(const unsigned units) override {
        statistics_.threads = std::max(units, 1u);
    }

  private:
    std::string name_ = "CPUs";
    LuxStatistics& statistics_;
};

class LuxRenderer::Machine final : public lux::RendererHostDescription {
  public:
    explicit Machine(LuxStatistics& statistics) : device_(statistics), devices_{&device_} {}
    const std::string& GetName() const override { return name_; }
    std::vector<lux::RendererDeviceDescription*>& GetDeviceDescs() override { return devices_; }

  private:
    std::string name_ = "Localhost";
    Device device_;
    std::vector<lux::RendererDeviceDescription*> devices_;
};

LuxRenderer::LuxRenderer()
    : statistics_(std::make_unique<LuxStatistics>()),
      machine_(std::make_unique<Machine>(*statistics_)),
      hosts_{machine_.get()} {
    rendererStatistics = statistics_.get();
    AddStringConstant(*this, "name", "Name of current renderer", "aips");
}

LuxRenderer::~LuxRenderer() = default;

lux::Renderer* LuxRenderer::CreateRenderer(const lux::ParamSet&) {
    return new LuxRenderer;
}

std::string LuxRenderer::refusal(lux::Scene& scene) const {
    if (!dynamic_cast<LuxIntegrator*>(scene.surfaceIntegrator))
        return "Renderer \"aips\" needs SurfaceIntegrator \"aips\" beside it";
    if (scene.lights.empty()) return "the scene has no light";
    if (statistics_->has_slave_nodes())
        return "\"aips\" renders on one machine; leave out the network's nodes";
    if (scene.volumeRegion || has_scattering(scene))
        return "\"aips\" does not render volumes that scatter or are heterogeneous; "
               "VolumeIntegrator \"emission\" takes them for absorbing, volume regions have to go";
    return {};
}

void LuxRenderer::refuse(lux::Scene& scene, const std::string& why) {
    LOG(LUX_SEVERE, LUX_CONSISTENCY) << why << ": nothing is rendered";
    // The console waits for a scene that is ready, and writes no image of one that was aborted.
    lux::Context::GetActive()->Abort();
    state_ = TERMINATE;
    scene.SetReady();
}

void LuxRenderer::Render(lux::Scene* scene) {
    if (scene->IsFilmOnly()) {
        state_ = TERMINATE;
        return;
    }
    if (const std::string why = refusal(*scene); !why.empty()) return refuse(*scene, why);
    lux::Film& film = *scene->camera()->film;
    const FilmBuffers buffers{
        film.RequestBuffer(lux::BUF_TYPE_PER_PIXEL, lux::BUF_FRAMEBUFFER, "eye"),
        film.RequestBuffer(lux::BUF_TYPE_PER_PIXEL, lux::BUF_FRAMEBUFFER, "photons"),
        film.RequestBuffer(lux::BUF_TYPE_PER_SCREEN, lux::BUF_FRAMEBUFFER, "splats")};
    film.CreateBuffers();
    lux::RandomGenerator generator(scene->seedBase - 1);
    scene->volumeIntegrator->Preprocess(generator, *scene);
    scene->camera()->AutoFocus(*scene);
    SceneView view(*scene, buffers);
    std::unique_ptr<EngineRun> run;
    const double before =
        film.GetBufferGroup(0).numberOfSamples / (double(view.film_width()) * view.film_height());
    try {
        run = start_engine(view, static_cast<LuxIntegrator*>(scene->surfaceIntegrator)->given(),
                           static_cast<std::uint64_t>(before + 0.5));
    } catch (const std::exception& error) {
        return refuse(*scene, error.what());
    }
    render_passes(*scene, *run);
    for (const std::string& line : run->refused())
        view.warning("values that are not finite or negative were left out: " + line);
    film.contribPool->Flush();
    film.contribPool->Delete();
    if (statistics_->has_slave_nodes()) leave_nodes(film);
}

void LuxRenderer::render_passes(lux::Scene& scene, EngineRun& run) {
    lux::Film& film = *scene.camera()->film;
    change_state(INIT, RUN);
    statistics_->reset();
    statistics_->start();
    scene.SetReady();
    while (goes_on()) {
        try {
            run.render_pass(statistics_->threads);
        } catch (const std::exception& error) {
            LOG(LUX_SEVERE, LUX_SYSTEM)
                << "the render ends after " << statistics_->passes << " passes: " << error.what();
            break;
        }
        ++statistics_->passes;
        statistics_->photon_paths = run.photon_paths();
        film.CheckWriteOuputInterval();
        if (statistics_->has_slave_nodes()) break;
        if (!film.enoughSamplesPerPixel) continue;
        if (!suspend_when_done_) break;
        Pause();
    }
    state_ = TERMINATE;
    statistics_->stop();
}

bool LuxRenderer::goes_on() {
    while (state_ == PAUSE)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return state_ != TERMINATE;
}

bool LuxRenderer::change_state(RendererState from, RendererState to) {
    return state_.compare_exchange_strong(from, to);
}

void LuxRenderer::Pause() {
    if (change_state(RUN, PAUSE)) statistics_->stop();
}

void LuxRenderer::Resume() {
    if (change_state(PAUSE, RUN)) statistics_->start();
}

}  // namespace aips::luxrender
