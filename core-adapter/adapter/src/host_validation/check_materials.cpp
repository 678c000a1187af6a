// Every material that rays met, at some places from both sides.
#include "check_materials.h"

#include "bsdf_statistics.h"

namespace aips {
namespace {

constexpr std::array<const char*, 3> kNames{"diffuse", "glossy", "specular"};

class MaterialCheck {
  public:
    MaterialCheck(std::string subject, const BsdfStatistics& statistics, HostFindings& findings)
        : subject_(std::move(subject)), statistics_(statistics), findings_(findings) {}

    /// What follows from another fault is not reported beside it.
    void report() {
        if (any(statistics_.values, 0, "values", "finite values, none negative") ||
            any(statistics_.directions, 0, "directions", "unit directions")) {
            return;
        }
        const bool masks =
            any(statistics_.masks, 0, "lobe of a sample", "one of the lobes asked for");
        const bool delta =
            any(statistics_.deltas, 0, "delta", "pdf 0 for specular lobes, and for these alone");
        const bool lobes = report_lobes();
        if (!delta && !masks) report_densities(lobes);
        report_energy();
        report_albedo();
        any(statistics_.lambert, kRare, "lambertian", "Kd / pi on wo's side, 0 on the other");
        any(statistics_.choices, 0, "first_specular",
            "one direction where u_lobe is below it, one above");
    }

  private:
    bool any(const CheckStatistics& statistics, double share, const char* check,
             const char* expected) {
        return findings_.add_if_over(statistics, share, subject_, check, expected);
    }

    bool report_lobes() {
        if (any(statistics_.lobes, 0, "lobes", "no lobe that lobes() lacks")) return true;
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            const bool claimed = statistics_.claimed & (1u << i);
            if (!claimed || statistics_.drawn & (1u << i) || statistics_.albedo_of[i] < 0.01)
                continue;
            findings_.add({subject_, "lobes",
                           std::string("no sample of its ") + kNames[i] + " lobe, of albedo " +
                               figure(statistics_.albedo_of[i]),
                           "samples of every lobe in lobes()"});
            return true;
        }
        return false;
    }

    void report_densities(bool lobes_reported) {
        if (any(statistics_.pdfs, kRare, "pdf", "the same density from both")) return;
        for (const DensityStatistics& d : statistics_.densities) {
            for (std::size_t i = 0; i < d.by_samples.size(); ++i) {
                const Estimate &drawn = d.by_samples[i], &told = d.by_density[i];
                if (!differ(drawn, told, 0.01, 1)) continue;
                findings_.add({subject_, "density",
                               "samples (lobes " + std::to_string(d.mask) + ") that bring " +
                                   figure(drawn.mean()) + " where pdf() tells " +
                                   figure(told.mean()),
                               "directions drawn as densely as pdf() says", kChanceOfFinding});
                return;
            }
        }
        if (!lobes_reported && any(statistics_.unreachable, kRare, "missing directions",
                                   "samples wherever evaluate() is not black")) {
            return;
        }
        any(statistics_.weights, kRare, "weight", "evaluate() times cosine over pdf");
    }

    void report_energy() {
        if (statistics_.most_energy <= 1.05) return;
        findings_.add({subject_, "energy",
                       figure(statistics_.most_energy) + " times the arriving light scattered",
                       "at most 1", kChanceOfFinding});
    }

    void report_albedo() {
        if (any(statistics_.albedos, 0, "albedo", "albedos in [0, 1]")) return;
        for (std::size_t i = 0; i < kNames.size(); ++i) {
            if (!statistics_.dark_albedo[i]) continue;
            findings_.add({subject_, "albedo",
                           std::string("albedo 0 of its ") + kNames[i] + " lobe, which scatters",
                           "above 0: what has none is never chosen"});
            return;
        }
    }

    std::string subject_;
    const BsdfStatistics& statistics_;
    HostFindings& findings_;
};

}  // namespace

void check_materials(const Scene& scene, const HostValidationSettings& settings,
                     const MetSurfaces& surfaces, HostFindings& findings) {
    const std::size_t step =
        1 + (surfaces.materials().size() - 1) / std::max(1u, settings.most_materials);
    std::size_t number = 0;
    for (const auto& [material, places] : surfaces.materials()) {
        if (number++ % step != 0) continue;
        RandomStream random = check_stream(settings, CheckStream::Materials, material);
        BsdfStatistics statistics;
        for (const auto* rays : {&places.front, &places.back}) {
            for (const Ray& ray : *rays) {
                Arena arena;
                SurfacePoint point;
                if (!scene.intersect(ray, point, arena) || !point.bsdf) continue;
                ask_bsdf({*point.bsdf, -ray.direction, point.geometric_normal, point.shading_normal,
                          settings.samples},
                         random, statistics);
            }
        }
        MaterialCheck(material_subject(scene, material), statistics, findings).report();
    }
}

}  // namespace aips
