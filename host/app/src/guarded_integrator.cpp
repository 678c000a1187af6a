// An integrator of a module whose exceptions say whose they are.
#include "guarded_integrator.h"

#include <optional>

#include "plugin_call.h"

namespace lxs {
namespace {

class GuardedIntegrator final : public Integrator {
  public:
    GuardedIntegrator(std::unique_ptr<Integrator> integrator, std::string name,
                      std::filesystem::path file)
        : integrator_(std::move(integrator)), name_(std::move(name)), file_(std::move(file)) {}

    void prepare(const RenderContext& context) override {
        // Outside of the guard: the contract gives this exception a meaning here.
        std::optional<std::string> refused;
        call_module(file_, at("prepare"), [&] {
            try {
                integrator_->prepare(context);
            } catch (const InputError&) {
                throw;
            } catch (const std::runtime_error& error) {
                refused = error.what();
            }
        });
        if (refused) throw std::runtime_error(*refused);
    }
    PassReport render_pass(std::uint64_t pass) override {
        return call_module(file_, at(fmt::format("pass {}", pass + 1)),
                           [&] { return integrator_->render_pass(pass); });
    }
    bool passes_stand_alone() const override {
        return call_module(file_, at("passes_stand_alone"),
                           [&] { return integrator_->passes_stand_alone(); });
    }
    Statistics statistics() const override {
        return call_module(file_, at("statistics"), [&] { return integrator_->statistics(); });
    }

  private:
    std::string at(std::string_view step) const {
        return fmt::format("integrator \"{}\", {},", name_, step);
    }

    std::unique_ptr<Integrator> integrator_;
    std::string name_;
    std::filesystem::path file_;
};

}  // namespace

std::unique_ptr<Integrator> guarded(std::unique_ptr<Integrator> integrator, std::string name,
                                    std::filesystem::path file) {
    return std::make_unique<GuardedIntegrator>(std::move(integrator), std::move(name),
                                               std::move(file));
}

}  // namespace lxs
