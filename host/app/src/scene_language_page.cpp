// The reference page of the scene language, from the declarations: what plugins share is stated
// once, and what has no effect stands in one table.
#include "lxs/host/scene_language_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "lxs/imaging/imaging.h"
#include "lxs/language/read_scene.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/registry.h"

namespace lxs {
namespace {

using Declarations = std::optional<std::vector<ParameterDeclaration>>;

/// Rendered plugins by statement and name.
class Rendered {
  public:
    Rendered() {
        register_shapes(registry_);
        register_shading(registry_);
    }

    /// Declared parameters of what is rendered.
    Declarations of(const std::string& statement, const std::string& name) const;
    /// Names that only this renderer knows.
    std::set<std::string> names(const std::string& statement) const;

  private:
    template <class Visit>
    void visit(const std::string& statement, const Visit& visit) const;

    Registry registry_;
};

template <class Visit>
void Rendered::visit(const std::string& statement, const Visit& visit) const {
    if (statement == "Shape") visit(registry_.shapes);
    if (statement == "Material") visit(registry_.materials);
    if (statement == "MakeNamedVolume") visit(registry_.media);
    if (statement == "Texture float") visit(registry_.float_textures);
    if (statement == "Texture color") visit(registry_.color_textures);
    if (statement == "Texture fresnel") visit(registry_.fresnel_textures);
}

Declarations Rendered::of(const std::string& statement, const std::string& name) const {
    Declarations found;
    visit(statement, [&](const auto& factories) {
        const auto factory = factories.find(name);
        if (factory != factories.end()) found = factory->second.parameters;
    });
    if (statement == "LightSource") {
        for (const LightPlugin& light : light_plugins())
            if (light.name == name) found = light.parameters;
    }
    if (statement == "AreaLightSource") {
        const auto parameters = area_light_parameters();
        found.emplace(parameters.begin(), parameters.end());
    }
    auto options = option_parameters(statement, name);
    if (!options.empty()) found = std::move(options);
    return found;
}

std::set<std::string> Rendered::names(const std::string& statement) const {
    std::set<std::string> names;
    visit(statement, [&](const auto& factories) {
        for (const auto& [name, factory] : factories)
            names.insert(name);
    });
    return names;
}

/// What is used in place of a plugin that is not rendered; a located warning says it too.
std::string stand_in(const std::string& statement) {
    if (statement == "Material") return "matte with its Kd, or grey";
    if (statement == "Shape") return "nothing: it is left out";
    if (statement == "MakeNamedVolume") return "a clear volume with its index";
    if (statement == "Texture float") return "the constant 1";
    if (statement == "Texture color") return "a grey of 0.5";
    if (statement == "Texture fresnel") return "the index 1.5";
    return {};
}

/// Statements whose plugins are chosen by the program itself: no parameters to list.
bool is_listed(const std::string& statement) {
    return statement != "Accelerator" && statement != "PixelSampler" && statement != "Renderer" &&
           statement != "SurfaceIntegrator" && statement != "ToneMap" && statement != "Volume" &&
           statement != "VolumeIntegrator";
}

/// What is written of one plugin: where it stands among its statement's, and its rows.
struct Plugin {
    std::string name, kind;  ///< kind: "color", "float" or "fresnel" of a texture, else empty
    std::vector<std::string> rows;
};

/// A parameter that a scene may give and that changes nothing.
struct WithoutEffect {
    std::string statement, name, note;
    std::vector<const Plugin*> of;
};

bool has_effect(const ParameterDeclaration& declaration) {
    return !declaration.no_effect && !declaration.doc.starts_with("Ignored");
}

/// "| name | type | ... |" of one parameter.
std::string row_of(const ParameterDeclaration& declaration) {
    std::string table = describe_markdown({&declaration, 1});
    table.pop_back();
    return table.substr(table.rfind('\n') + 1);
}

std::string name_in(const std::string& row) {
    return row.substr(2, row.find(' ', 2) - 2);
}

/// Rows of one kind that are numbered, tex1, tex2, ..., as one: tex1 ... tex32.
std::vector<std::string> folded(const std::vector<std::string>& rows) {
    struct Family {
        std::size_t first = 0;
        std::string last;
        int members = 0;
    };
    const auto stem_of = [](const std::string& row) {
        const std::string name = name_in(row);
        const std::string stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
        const std::string number = name.substr(stem.size());
        std::string text = row.substr(2 + name.size());
        for (std::size_t at = 0; !number.empty() && (at = text.find(number, at)) < text.size();)
            text.replace(at, number.size(), "N");
        return number.empty() ? std::string() : stem + text;
    };
    std::map<std::string, Family> families;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string stem = stem_of(rows[i]);
        Family& family = families[stem.empty() ? rows[i] : stem];
        if (family.members++ == 0) family.first = i;
        family.last = name_in(rows[i]);
    }
    std::vector<std::string> result;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string stem = stem_of(rows[i]);
        const Family& family = families[stem.empty() ? rows[i] : stem];
        if (family.members < 3) {
            result.push_back(rows[i]);
        } else if (family.first == i) {
            const std::string name = name_in(rows[i]);
            result.push_back("| " + name + " ... " + family.last + rows[i].substr(2 + name.size()));
        }
    }
    return result;
}

/// The parameters of a statement's plugins: what several share stands once, by who shares it.
class Section {
  public:
    explicit Section(std::string statement) : statement_(std::move(statement)) {}

    void add(const std::string& kind, const std::string& name,
             const std::vector<ParameterDeclaration>& declared, std::vector<WithoutEffect>& idle);
    void add_missing(const std::string& name, const std::string& instead) {
        missing_[instead].push_back(name);
    }
    std::string text() const;

    /// "all", "all but a and b", or their names; of textures their kinds where a name has others.
    std::string names_of(const std::vector<const Plugin*>& plugins) const;

  private:
    std::string shared(const std::map<std::string, std::vector<const Plugin*>>& users) const;

    std::string statement_;
    std::deque<Plugin> plugins_;  // never moved: others point at them
    std::map<std::string, std::vector<std::string>> missing_;
};

constexpr std::string_view kTableHead =
    "| name | type | default | allowed | meaning |\n| --- | --- | --- | --- | --- |\n";

void Section::add(const std::string& kind, const std::string& name,
                  const std::vector<ParameterDeclaration>& declared,
                  std::vector<WithoutEffect>& idle) {
    Plugin& plugin = plugins_.emplace_back(Plugin{name, kind, {}});
    std::vector<std::string> rows;
    for (const ParameterDeclaration& declaration : declared) {
        if (has_effect(declaration)) {
            rows.push_back(row_of(declaration));
            continue;
        }
        std::string note(declaration.doc);
        for (const std::string_view prefix : {"Ignored: ", "Ignored."})
            if (note.starts_with(prefix)) note.erase(0, prefix.size());
        const auto same = std::find_if(idle.begin(), idle.end(), [&](const WithoutEffect& known) {
            return known.statement == statement_ && known.name == declaration.name &&
                   known.note == note;
        });
        if (same == idle.end()) {
            idle.push_back({statement_, std::string(declaration.name), note, {&plugin}});
        } else {
            same->of.push_back(&plugin);
        }
    }
    plugin.rows = folded(rows);
}

std::string Section::names_of(const std::vector<const Plugin*>& plugins) const {
    if (plugins.size() == plugins_.size()) return plugins_.size() == 1 ? plugins_[0].name : "all";
    const bool most = 2 * plugins.size() > plugins_.size();
    std::map<std::string, std::set<std::string>> named;  // kinds by name
    for (const Plugin& plugin : plugins_) {
        const bool there = std::find(plugins.begin(), plugins.end(), &plugin) != plugins.end();
        if (there != most) named[plugin.name].insert(plugin.kind);
    }
    std::vector<std::string> names;
    for (const auto& [name, kinds] : named) {
        const auto of_name = std::count_if(plugins_.begin(), plugins_.end(),
                                           [&](const Plugin& p) { return p.name == name; });
        names.push_back(kinds.size() == std::size_t(of_name)
                            ? name
                            : fmt::format("{} ({})", name, fmt::join(kinds, ", ")));
    }
    return fmt::format("{}{}", most ? "all but " : "", fmt::join(names, ", "));
}

/// Tables of the rows that more than one plugin has, one for each set of plugins.
std::string Section::shared(const std::map<std::string, std::vector<const Plugin*>>& users) const {
    std::map<std::vector<const Plugin*>, std::vector<std::string>> tables;
    std::vector<std::vector<const Plugin*>> order;
    for (const Plugin& plugin : plugins_) {
        for (const std::string& row : plugin.rows) {
            const std::vector<const Plugin*>& of = users.at(row);
            if (of.size() < 2 || of.front() != &plugin) continue;
            if (tables[of].empty()) order.push_back(of);
            tables[of].push_back(row);
        }
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    std::string text;
    for (const auto& of : order) {
        text += fmt::format("Of {}:\n\n{}{}\n\n", names_of(of), kTableHead,
                            fmt::join(tables[of], "\n"));
    }
    return text;
}

std::string Section::text() const {
    std::map<std::string, std::vector<const Plugin*>> users;
    for (const Plugin& plugin : plugins_)
        for (const std::string& row : plugin.rows)
            users[row].push_back(&plugin);
    std::string text = fmt::format("## {}\n\n{}", statement_, shared(users));
    std::vector<const Plugin*> nothing_more;
    for (const Plugin& plugin : plugins_) {
        std::vector<std::string> own;
        for (const std::string& row : plugin.rows)
            if (users.at(row).size() == 1) own.push_back(row);
        if (own.empty()) {
            nothing_more.push_back(&plugin);
            continue;
        }
        const std::string kind = plugin.kind.empty() ? "" : " " + plugin.kind;
        text += fmt::format("### {}{} \"{}\"\n\n{}{}\n\n", statement_, kind, plugin.name,
                            kTableHead, fmt::join(own, "\n"));
    }
    if (!nothing_more.empty() && nothing_more.size() < plugins_.size()) {
        text += fmt::format("No parameters but those above: {}.\n\n", names_of(nothing_more));
    }
    for (const auto& [instead, names] : missing_) {
        text += fmt::format("Not rendered, with a located warning: {}. In their place: {}.\n\n",
                            fmt::join(names, ", "), instead);
    }
    return text;
}

/// All that changes nothing, in one table: a row for each statement and note.
std::string without_effect(const std::vector<WithoutEffect>& idle,
                           const std::map<std::string, Section>& sections) {
    std::vector<std::array<std::string, 3>> keys;  // statement, plugins, note
    std::map<std::array<std::string, 3>, std::vector<std::string>> names;
    for (const WithoutEffect& parameter : idle) {
        const std::array<std::string, 3> key{
            parameter.statement, sections.at(parameter.statement).names_of(parameter.of),
            parameter.note};
        if (names[key].empty()) keys.push_back(key);
        names[key].push_back(parameter.name);
    }
    std::string text =
        "## Without effect\n\nThese are read, and change nothing; a warning says so where a scene "
        "sets them.\n\n| statement | of | parameters | note |\n| --- | --- | --- | --- |\n";
    for (const auto& key : keys) {
        text += fmt::format("| {} | {} | {} | {} |\n", key[0], key[1], fmt::join(names[key], ", "),
                            key[2]);
    }
    return text;
}

}  // namespace

std::string scene_language_page() {
    const Rendered rendered;
    std::vector<std::string> order;
    std::map<std::string, Section> sections;
    std::vector<WithoutEffect> idle;
    for (const auto& [statement, known] : known_plugin_names()) {
        if (!is_listed(statement)) continue;
        const std::size_t space = statement.find(' ');  // of "Texture color"
        const std::string shown = statement.substr(0, space);
        const std::string kind =
            space == std::string::npos ? std::string() : statement.substr(space + 1);
        if (!sections.contains(shown)) order.push_back(shown);
        Section& section = sections.try_emplace(shown, shown).first->second;
        std::set<std::string> names = rendered.names(statement);
        names.insert(known.begin(), known.end());
        for (const std::string& name : names) {
            if (const Declarations declared = rendered.of(statement, name)) {
                section.add(kind, name, *declared, idle);
            } else {
                section.add_missing(kind.empty() ? name : kind + " " + name, stand_in(statement));
            }
        }
    }
    std::string text;
    for (const std::string& statement : order)
        text += sections.at(statement).text();
    return text + without_effect(idle, sections);
}

}  // namespace lxs
