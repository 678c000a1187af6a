// An integrator that shows the surfaces' colours and, in one step of its life, does harm: throws,
// takes a file away, hands the film what it must not have.
#include <sys/stat.h>
#include <tbb/parallel_for.h>

#include <filesystem>
#include <limits>
#include <memory_resource>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lxs/sdk/plugin.h"

namespace {

constexpr lxs::ParameterDeclaration kParameters[] = {
    {"deed", lxs::ParameterType::String, "none", "the harm"},
    {"pass", lxs::ParameterType::Integer, "1", "pass, from 0, at whose start it happens", 0},
    {"victim", lxs::ParameterType::String, "", "file or folder that suffers"},
};

struct NoStandardException {
    int number = 7;
};

void throw_in_tasks(bool standard) {
    tbb::parallel_for(0, 1000, [&](int i) {
        if (i % 10 != 3) return;
        if (standard) throw std::runtime_error("a task gave up");
        throw NoStandardException{};
    });
}

class Saboteur final : public lxs::Integrator {
  public:
    explicit Saboteur(const lxs::ParameterReader& parameters)
        : deed_(parameters.string("deed", "none")),
          victim_(parameters.string("victim", "")),
          pass_(static_cast<std::uint64_t>(parameters.integer("pass", 1))) {
        if (deed_ == "foreign exception in create") throw NoStandardException{};
    }
    void prepare(const lxs::RenderContext& context) override {
        context_.emplace(context);
        if (deed_ == "logic error in prepare") throw std::logic_error("off by one");
        if (deed_ == "foreign exception in prepare") throw NoStandardException{};
        if (deed_ == "no memory in prepare") throw std::bad_alloc();
    }
    lxs::PassReport render_pass(std::uint64_t pass) override;
    bool passes_stand_alone() const override {
        if (deed_ == "throw in passes_stand_alone") throw std::runtime_error("do they?");
        return true;
    }
    lxs::Statistics statistics() const override {
        if (deed_ == "throw in statistics") throw std::runtime_error("lost count");
        return {{"bytes that are no UTF-8: \xff\xfe", std::string("\xc3(")},
                {"not a number", std::numeric_limits<double>::quiet_NaN()}};
    }

  private:
    const lxs::RenderContext& context() const { return *context_; }
    void do_harm();
    void harm_files() const;
    void harm_film();
    lxs::Rgb seen(const lxs::CameraSample& sample) const;

    std::string deed_, victim_;
    std::uint64_t pass_;
    std::optional<lxs::RenderContext> context_;
    std::vector<lxs::Vec2> positions_;
    std::vector<lxs::Rgb> radiance_;
};

void Saboteur::harm_files() const {
    namespace fs = std::filesystem;
    if (deed_ == "remove") fs::remove_all(victim_);
    if (deed_ == "make read-only") ::chmod(victim_.c_str(), 0555);
    if (deed_ == "truncate") fs::resize_file(victim_, 200);
    if (deed_ == "put a folder in its place") {
        fs::remove(victim_);
        fs::create_directory(victim_);
    }
}

void Saboteur::harm_film() {
    lxs::Film& film = context().film;
    const lxs::Rgb nan(std::numeric_limits<float>::quiet_NaN());
    if (deed_ == "NaN") radiance_.assign(radiance_.size(), nan);
    if (deed_ == "too few values") radiance_.pop_back();
    if (deed_ == "positions nowhere") {
        positions_.assign(positions_.size(), lxs::Vec2(1e30f, -std::numeric_limits<float>::max()));
    }
    if (deed_ == "wrong layer size") film.set_layer("mine", std::vector<float>(3));
    if (deed_ == "layer without end") film.set_layer(std::string(100000, 'x'), {});
    if (deed_ == "layer name with a zero byte") {
        film.set_layer(std::string("a\0b", 3), std::vector<float>(positions_.size()));
    }
}

void Saboteur::do_harm() {
    if (deed_ == "throw") throw std::runtime_error("no more paint");
    if (deed_ == "foreign exception") throw NoStandardException{};
    if (deed_ == "throw in tasks") throw_in_tasks(true);
    if (deed_ == "foreign exception in tasks") throw_in_tasks(false);
    if (deed_ == "no memory") throw std::bad_alloc();
    if (deed_ == "all memory") {
        const std::vector<char> all(std::size_t{1} << 60);
        throw std::logic_error("memory without end");
    }
    harm_film();
}

lxs::Rgb Saboteur::seen(const lxs::CameraSample& sample) const {
    std::pmr::monotonic_buffer_resource memory;
    lxs::SurfaceHit hit;
    const lxs::Ray ray = context().camera.generate(sample, 0).ray;
    if (!context().scene.intersect(ray, hit, memory) || hit.bsdf == nullptr) return lxs::Rgb(0.0f);
    return hit.bsdf->albedo(-ray.direction, lxs::kAllLobes);
}

lxs::PassReport Saboteur::render_pass(std::uint64_t pass) {
    const std::uint32_t width = context().film.width(), height = context().film.height();
    positions_.assign(std::size_t{width} * height, lxs::Vec2(0.0f));
    radiance_.assign(positions_.size(), lxs::Rgb(0.0f));
    if (pass == pass_) harm_files();
    tbb::parallel_for(0u, height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const lxs::CameraSample sample = context().sampler.camera_sample(pass, x, y);
            positions_[std::size_t{y} * width + x] = sample.film;
            radiance_[std::size_t{y} * width + x] = seen(sample);
        }
    });
    if (pass == pass_) do_harm();
    const std::uint32_t groups = pass == pass_ && deed_ == "too many groups" ? 1000 : 1;
    const double weight = pass == pass_ && deed_ == "weight of 0" ? 0 : 1;
    context().film.add_pass({positions_, radiance_, groups, weight});
    return {};
}

std::unique_ptr<lxs::Integrator> create(const lxs::ParameterReader& parameters) {
    return std::make_unique<Saboteur>(parameters);
}

const lxs::IntegratorPlugin kPlugins[] = {
    {"saboteur", "Shows colours, and does harm.", kParameters, &create}};

}  // namespace

LXS_PLUGIN_MODULE("saboteur", kPlugins)
