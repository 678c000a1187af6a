// What a check of a host has found so far.
#include "findings.h"

#include <locale>
#include <sstream>

namespace aips {

std::string figure(double value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(3);
    out << value;
    return out.str();
}

std::string light_subject(const Scene& scene, LightIndex light) {
    std::string subject = "light " + std::to_string(light);
    const std::string name = light < scene.lights().size() ? scene.lights()[light]->name() : "";
    return name.empty() ? subject : subject + " \"" + name + '"';
}

std::string material_subject(const Scene& scene, std::uint32_t material) {
    const auto names = scene.material_names();
    std::string subject = "material " + std::to_string(material);
    return material < names.size() ? subject + " \"" + names[material] + '"' : subject;
}

std::string CheckStatistics::text() const {
    return example + " (" + std::to_string(wrong) + " of " + std::to_string(looked) + ")";
}

bool HostFindings::add_if_over(const CheckStatistics& statistics, double share,
                               const std::string& subject, const std::string& check,
                               const std::string& expected) {
    if (!statistics.over(share)) return false;
    add({subject, check, statistics.text(), expected});
    return true;
}

std::string to_string(const HostFinding& finding) {
    std::string text = finding.subject + ": " + finding.check + ": found " + finding.found +
                       ", expected " + finding.expected;
    if (finding.chance > 0) text += " (by chance: p < " + figure(finding.chance) + ")";
    return text;
}

}  // namespace aips
