// An integrator of a module whose exceptions say whose they are.
#include "guarded_integrator.h"

#include <exception>

#include "plugin_call.h"

namespace lxs {
namespace {

class GuardedIntegrator final : public Integrator {
  public:
    GuardedIntegrator(std::unique_ptr<Integrator> integrator, std::string name,
                      std::filesystem::path file)
        : integrator_(std::move(integrator)), name_(std::move(name)), file_(std::move(file)) {}

    void prepare(const RenderContext& context) override {
        call_as_agreed("prepare", [&] { integrator_->prepare(context); });
    }
    PassReport render_pass(std::uint64_t pass) override {
        return call_module(file_, at(fmt::format("pass {}", pass + 1)),
                           [&] { return integrator_->render_pass(pass); });
    }
    bool passes_stand_alone() const override {
        return call_module(file_, at("passes_stand_alone"),
                           [&] { return integrator_->passes_stand_alone(); });
    }
    bool shares_passes() const override {
        return call_module(file_, at("shares_passes"),
                           [&] { return integrator_->shares_passes(); });
    }
    Statistics statistics() const override {
        return call_module(file_, at("statistics"), [&] { return integrator_->statistics(); });
    }
    InvalidSampleList invalid_samples() const override {
        return call_module(file_, at("invalid_samples"),
                           [&] { return integrator_->invalid_samples(); });
    }
    TransportStatistics transport_statistics() const override {
        return call_module(file_, at("transport_statistics"),
                           [&] { return integrator_->transport_statistics(); });
    }
    void state(StateArchive& archive) override {
        call_as_agreed("state", [&] { integrator_->state(archive); });
    }
    void learned(StateArchive& archive) override {
        call_as_agreed("learned", [&] { integrator_->learned(archive); });
    }

  private:
    /// Lets those exceptions pass to which the contract gives a meaning.
    template <class Function>
    void call_as_agreed(std::string_view step, Function function) {
        std::exception_ptr agreed;
        call_module(file_, at(step), [&] {
            try {
                function();
            } catch (const InputError&) {
                throw;
            } catch (const std::runtime_error&) {
                agreed = std::current_exception();
            }
        });
        if (agreed) std::rethrow_exception(agreed);
    }
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
