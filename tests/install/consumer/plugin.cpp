// A plugin module for lxsrender, built outside of the project against the installed SDK: an
// integrator that shows the colours of the surfaces. docs/build-on/plugins.md walks through it.
#include <lxs/sdk/plugin.h>

#include <memory_resource>
#include <optional>
#include <vector>

namespace {

constexpr lxs::ParameterDeclaration kParameters[] = {
    {"brightness", lxs::ParameterType::Float, "1", "Factor of the colours shown.", 0, 1000}};

class ColourIntegrator final : public lxs::Integrator {
  public:
    explicit ColourIntegrator(const lxs::ParameterReader& parameters)
        : brightness_(float(parameters.number("brightness", 1))) {}

    void prepare(const lxs::RenderContext& context) override { context_.emplace(context); }
    lxs::PassReport render_pass(std::uint64_t pass) override;
    void state(lxs::StateArchive& /*archive*/) override {
    }  // no pass leaves anything for later ones

  private:
    lxs::Rgb seen(const lxs::CameraSample& sample) const;

    float brightness_;
    std::optional<lxs::RenderContext> context_;
};

/// The colour of what one camera ray meets: black where it meets nothing, or what scatters nothing.
lxs::Rgb ColourIntegrator::seen(const lxs::CameraSample& sample) const {
    const lxs::Ray ray = context_->camera.generate(sample, context_->camera.shutter_open()).ray;
    std::pmr::monotonic_buffer_resource memory;  // in which the scene builds the Bsdf
    lxs::SurfaceHit hit;
    if (!context_->scene.intersect(ray, hit, memory) || !hit.bsdf) return lxs::Rgb(0.0f);
    return hit.bsdf->albedo(-ray.direction, lxs::kAllLobes) * brightness_;
}

lxs::PassReport ColourIntegrator::render_pass(std::uint64_t pass) {
    lxs::Film& film = context_->film;
    std::vector<lxs::Vec2> positions;
    std::vector<lxs::Rgb> radiance;
    for (std::uint32_t y = 0; y < film.height(); ++y) {
        for (std::uint32_t x = 0; x < film.width(); ++x) {
            const lxs::CameraSample sample = context_->sampler.camera_sample(pass, x, y);
            positions.push_back(sample.film);
            radiance.push_back(seen(sample));
        }
    }
    film.add_pass({positions, radiance});
    return {.rays = positions.size()};
}

std::unique_ptr<lxs::Integrator> create(const lxs::ParameterReader& parameters) {
    return std::make_unique<ColourIntegrator>(parameters);
}

const lxs::IntegratorPlugin kPlugins[] = {
    {"consumer", "Shows the colours of surfaces, unlit.", kParameters, &create}};

}  // namespace

LXS_PLUGIN_MODULE("consumer", kPlugins)
