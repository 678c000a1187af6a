// Renders small scenes with `path`, for tests.
#include "path_render.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lxs/imaging/imaging.h"
#include "lxs/language/read_scene.h"
#include "lxs/tracing/trace_scene.h"
#include "path/path_integrator.h"

namespace lxs::test {
namespace {

/// Tests have healthy scenes: any warning fails them.
class NoWarnings : public Diagnostics, public Log {
  public:
    void warning(const SourceLocation& where, const std::string& message) override {
        ADD_FAILURE() << format_message(where, "warning", message);
    }
    void unknown_parameter(const SourceLocation& where, const std::string& message) override {
        warning(where, message);
    }
    void info(std::string_view /*message*/) override {}
    void warning(std::string_view message) override { ADD_FAILURE() << message; }
    void debug(std::string_view /*message*/) override {}
};

/// What is told of the scene's own language matters to other tests.
class NoErrors final : public NoWarnings {
  public:
    void warning(const SourceLocation& /*where*/, const std::string& /*message*/) override {}
    using NoWarnings::warning;
    void fallback(const SourceLocation& /*where*/, const std::string& /*message*/,
                  const std::string& /*instead*/) override {}
    void error(const InputError& error) override { ADD_FAILURE() << error.what(); }
};

using ReadScene = std::function<SceneContents(const Registry&, Diagnostics&)>;

/// Reads a scene of LuxRender whose film the test gives.
ReadScene reader_of(const std::string& text) {
    return [=](const Registry& registry, Diagnostics& messages) {
        const std::string film =
            "Film \"fleximage\" \"integer xresolution\" [8] \"integer yresolution\" [8]\n"
            // The scene's own colours.
            "\"float colorspace_red\" [0.64 0.33] \"float colorspace_green\" [0.30 0.60] "
            "\"float colorspace_blue\" [0.15 0.06] "
            "\"float colorspace_white\" [0.313334 0.329235]\n"
            "PixelFilter \"box\" \"float xwidth\" [0.5] \"float ywidth\" [0.5]\n";
        return read_scene_text(film + text, "test", ".", registry, messages);
    };
}

/// A scene with all that a render of it needs.
class Render {
  public:
    Render(const ReadScene& read, const PathSettings& settings, std::uint64_t seed,
           std::unique_ptr<NoWarnings> messages = std::make_unique<NoWarnings>(),
           const AssetResolver& resolve = {})
        : messages_(std::move(messages)), integrator_(settings) {
        Registry registry;
        register_shapes(registry);
        register_shading(registry);
        SceneContents contents = read(registry, *messages_);
        film_ = make_film(contents, *messages_);
        camera_ = make_camera(contents, *film_, *messages_);
        sampler_ = make_sampler(contents, seed, *messages_, true);
        scene_ = make_trace_scene(std::move(contents), resolve, *messages_);
        camera_->set_media(scene_->camera_media());
        integrator_.prepare({*scene_, *camera_, *sampler_, *film_, *messages_, {0, seed}});
    }

    std::vector<Rgb> image(int passes) {
        for (int i = 0; i < passes; ++i)
            integrator_.render_pass(next_pass_++);
        return film_->image();
    }
    void clear() { film_->clear(); }
    Statistics statistics() const { return integrator_.statistics(); }

  private:
    std::unique_ptr<NoWarnings> messages_;
    std::unique_ptr<FileFilm> film_;
    std::unique_ptr<SceneCamera> camera_;
    std::unique_ptr<Sampler> sampler_;
    std::unique_ptr<TraceScene> scene_;
    PathIntegrator integrator_;
    std::uint64_t next_pass_ = 0;
};

Rgb mean_of(const std::vector<Rgb>& values) {
    Imath::V3d sum(0.0);
    for (const Rgb& value : values)
        sum += Imath::V3d(value.x, value.y, value.z);
    sum /= static_cast<double>(values.size());
    return Rgb(static_cast<float>(sum.x), static_cast<float>(sum.y), static_cast<float>(sum.z));
}

}  // namespace

std::string camera_above(double height, double field_of_view) {
    return fmt::format(
        "LookAt 0 0 {}  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [{}]\nWorldBegin\n",
        height, field_of_view);
}

std::string square(double z, double half_side, bool down) {
    return fmt::format(
        "Shape \"trianglemesh\" \"integer indices\" [{2}]\n"
        "  \"point P\" [-{1} -{1} {0}  {1} -{1} {0}  {1} {1} {0}  -{1} {1} {0}]\n",
        z, half_side, down ? "0 2 1 0 3 2" : "0 1 2 0 2 3");
}

MeanRadiance render_mean(const std::string& text, const PathSettings& settings, int passes,
                         std::uint64_t seed) {
    constexpr int kBatches = 16;
    Render render(reader_of(text), settings, seed);
    std::vector<Rgb> batches;
    for (int i = 0; i < kBatches; ++i) {
        render.clear();
        batches.push_back(mean_of(render.image(std::max(1, passes / kBatches))));
    }
    MeanRadiance result;
    result.mean = mean_of(batches);
    for (int c = 0; c < 3; ++c) {
        double squares = 0;
        for (const Rgb& batch : batches)
            squares += std::pow(batch[c] - result.mean[c], 2);
        result.standard_error[c] =
            static_cast<float>(std::sqrt(squares / (kBatches * (kBatches - 1))));
    }
    return result;
}

std::vector<Rgb> render_image(const std::string& text, const PathSettings& settings, int passes,
                              Statistics* statistics, std::uint64_t seed) {
    Render render(reader_of(text), settings, seed);
    std::vector<Rgb> image = render.image(passes);
    if (statistics != nullptr) *statistics = render.statistics();
    return image;
}

std::vector<Rgb> render_image(const ReadScene& read, const PathSettings& settings, int passes,
                              const std::string& folder) {
    const auto in_folder = [&](const std::string& name, const SourceLocation& /*where*/) {
        return folder + "/" + name;
    };
    return Render(read, settings, 1, std::make_unique<NoErrors>(), in_folder).image(passes);
}

double z_score(const MeanRadiance& a, const MeanRadiance& b) {
    double largest = 0;
    for (int c = 0; c < 3; ++c) {
        // Rounding of float sums sets a floor where an estimate has no variance.
        const double error = std::hypot(a.standard_error[c], b.standard_error[c]) +
                             1e-5 * std::max(std::abs(a.mean[c]), std::abs(b.mean[c]));
        largest = std::max(largest, std::abs(double{a.mean[c]} - b.mean[c]) / (error + 1e-12));
    }
    return largest;
}

}  // namespace lxs::test
