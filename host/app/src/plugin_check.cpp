// Whether what a module says of itself can be relied on.
#include "lxs/host/plugin_check.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "plugin_call.h"

namespace lxs {
namespace {

// Sizes that no module means: they tell of memory that holds something else.
constexpr std::size_t kMostIntegrators = 1000;
constexpr std::size_t kMostParameters = 10000;
constexpr std::size_t kMostChoices = 10000;
constexpr std::size_t kLongestName = 200;    // bytes
constexpr std::size_t kLongestText = 10000;  // bytes

bool printable(std::string_view text) {
    return std::none_of(text.begin(), text.end(),
                        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

/// What is said of one integrator, checked.
class IntegratorCheck {
  public:
    IntegratorCheck(const IntegratorPlugin& plugin, const std::filesystem::path& file)
        : plugin_(plugin), file_(file) {}

    void run() const {
        const std::string integrator = fmt::format("integrator \"{}\"", plugin_.name);
        if (plugin_.create == nullptr) fail_module(file_, integrator + " has no create function");
        check_text(plugin_.doc, integrator + ": its description");
        check_span(plugin_.parameters, kMostParameters, integrator + ": its list of parameters");
        std::set<std::string_view> names;
        for (const ParameterDeclaration& declared : plugin_.parameters) {
            if (!is_name(declared.name)) {
                fail_module(file_, integrator + " declares a parameter without a usable name");
            }
            if (!names.insert(declared.name).second) fail(declared, "is declared twice");
            check(declared);
        }
    }

    static bool is_name(std::string_view name) {
        return name.data() != nullptr && !name.empty() && name.size() <= kLongestName &&
               printable(name);
    }

  private:
    [[noreturn]] void fail(const ParameterDeclaration& declared, const std::string& what) const {
        fail_module(file_, fmt::format("integrator \"{}\": parameter \"{}\" {}", plugin_.name,
                                       declared.name, what));
    }
    void check_text(std::string_view text, const std::string& what) const {
        if ((text.data() == nullptr && !text.empty()) || text.size() > kLongestText) {
            fail_module(file_, fmt::format("{} has {} bytes", what, text.size()));
        }
    }
    template <class T>
    void check_span(std::span<const T> values, std::size_t most, const std::string& what) const {
        if ((values.data() == nullptr && !values.empty()) || values.size() > most) {
            fail_module(file_, fmt::format("{} has {} entries", what, values.size()));
        }
    }
    void check(const ParameterDeclaration& declared) const {
        const std::string what =
            fmt::format("integrator \"{}\": parameter \"{}\": its ", plugin_.name, declared.name);
        if (declared.type > ParameterType::FresnelTexture) fail(declared, "is of no known type");
        check_text(declared.doc, what + "description");
        check_text(declared.default_text, what + "default");
        check_span(declared.choices, kMostChoices, what + "list of choices");
        for (const std::string_view choice : declared.choices) {
            if (choice.data() == nullptr || choice.size() > kLongestName) {
                fail(declared, "has a choice without a usable name");
            }
        }
        if (!(declared.minimum <= declared.maximum)) {
            fail(declared, fmt::format("has no values: its range is from {} to {}",
                                       declared.minimum, declared.maximum));
        }
        check_default(declared);
    }
    void check_default(const ParameterDeclaration& declared) const;
    bool default_fits(const ParameterDeclaration& declared) const;

    const IntegratorPlugin& plugin_;
    const std::filesystem::path& file_;
};

bool is_number_within(std::string_view text, const ParameterDeclaration& declared) {
    double number = 0;
    const auto [rest, error] = std::from_chars(text.begin(), text.end(), number);
    return error == std::errc() && rest == text.end() && number >= declared.minimum &&
           number <= declared.maximum;
}

bool IntegratorCheck::default_fits(const ParameterDeclaration& declared) const {
    const std::string_view text = declared.default_text;
    switch (declared.type) {
        case ParameterType::Float:
        case ParameterType::Integer:
            return declared.array || is_number_within(text, declared);
        case ParameterType::Bool:
            return text == "true" || text == "false";
        case ParameterType::String:
            return declared.choices.empty() ||
                   std::find(declared.choices.begin(), declared.choices.end(), text) !=
                       declared.choices.end();
        default:
            return true;  // texts of several numbers, or names of textures: for docs alone
    }
}

void IntegratorCheck::check_default(const ParameterDeclaration& declared) const {
    if (declared.default_text.empty() || default_fits(declared)) return;
    fail(declared,
         fmt::format("has a default that it would not take: {}", in_quotes(declared.default_text)));
}

}  // namespace

void check_module(const PluginModule* module, const std::filesystem::path& file) {
    if (module == nullptr) fail_module(file, "its entry function returned nothing");
    if (module->abi_version != kAbiVersion) {
        fail_module(file, fmt::format("built for version {} of the plugin SDK, but this lxsrender "
                                      "has version {}; build the module again",
                                      module->abi_version, kAbiVersion));
    }
    if ((module->integrators.data() == nullptr && !module->integrators.empty()) ||
        module->integrators.size() > kMostIntegrators) {
        fail_module(file, fmt::format("its list of integrators has {} entries",
                                      module->integrators.size()));
    }
    std::set<std::string_view> names;
    for (const IntegratorPlugin& plugin : module->integrators) {
        if (!IntegratorCheck::is_name(plugin.name)) {
            fail_module(file, "offers an integrator without a usable name");
        }
        if (!names.insert(plugin.name).second) {
            fail_module(file, fmt::format("offers integrator \"{}\" twice", plugin.name));
        }
        IntegratorCheck(plugin, file).run();
    }
}

}  // namespace lxs
