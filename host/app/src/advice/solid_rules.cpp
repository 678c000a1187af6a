// Advice on what stands inside a closed solid, and on solids that are inside out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "advice/advice_rules.h"
#include "lxs/host/explanation.h"
#include "lxs/sdk/rays.h"
#include "lxs/sdk/warp.h"

namespace lxs {
namespace {

constexpr std::size_t kMostLamps = 16;  ///< that are looked at: those of most power
constexpr int kWalks = 96;              ///< of light from each
constexpr int kWalkSurfaces = 8;        ///< on each walk
constexpr std::size_t kMostLines = 64;  ///< that look for solids that are inside out
constexpr int kLeastLines = 8;
constexpr double kInsideOutShare = 0.9;
constexpr std::size_t kFlatDirections = 8;  ///< of normals: a box has six, a prism few more

std::string name_of_material(const AdviceFacts& facts, std::uint32_t material) {
    const auto names = facts.session.scene->material_names();
    return material < names.size() ? in_quotes(names[material]) : "\"\"";
}

/// Numbers of the lights within the scene, those of most power first.
std::vector<std::size_t> strongest_lamps(const Scene& scene) {
    std::vector<std::size_t> lamps;
    const auto lights = scene.lights();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!lights[i]->at_infinity() && lights[i]->power() > 0) lamps.push_back(i);
    }
    const std::size_t most = std::min(kMostLamps, lamps.size());
    std::partial_sort(lamps.begin(), lamps.begin() + static_cast<std::ptrdiff_t>(most), lamps.end(),
                      [&](auto a, auto b) { return lights[a]->power() > lights[b]->power(); });
    lamps.resize(most);
    return lamps;
}

/// Where the light of one lamp goes.
struct LampSurroundings {
    int rays = 0;  ///< that it sent
    int own = 0;   ///< met the lamp itself first
    bool gets_out = false;
    std::set<std::uint32_t> materials;  ///< that its rays met first
};

/// One walk of light; true if it leaves the scene or comes where the eye sees it.
bool gets_out(SceneProbe& probe, MetSurface met, ProbeNumbers& numbers) {
    for (int i = 0; i < kWalkSurfaces; ++i) {
        if (probe.sees_eye(met)) return true;
        BsdfSample sample;
        const Vec2 u = numbers.next2();
        if (!met.hit.bsdf || !met.hit.bsdf->sample(-met.ray.direction, u, numbers.next(),
                                                   Transport::Power, kAllLobes, sample))
            return false;
        const auto next = probe.meet(continue_ray(met.hit, sample, met.ray));
        if (!next) return true;
        met = *next;
    }
    return false;
}

LampSurroundings look_around(SceneProbe& probe, const Light& lamp) {
    LampSurroundings found;
    ProbeNumbers numbers(1);
    for (int i = 0; i < kWalks && !found.gets_out; ++i) {
        const PrimaryPoint u{numbers.next(), numbers.next(), numbers.next(), numbers.next()};
        EmissionSample emission;
        if (!lamp.sample_emission(u, emission) || is_black(emission.power)) continue;
        emission.ray.time = probe.time();
        ++found.rays;
        const auto met = probe.meet(emission.ray);
        found.gets_out = !met;
        if (!met) continue;
        found.own += met->hit.light == &lamp;
        found.materials.insert(met->hit.material);
        found.gets_out = gets_out(probe, *met, numbers);
    }
    return found;
}

/// How often lines from outside come to a material's surfaces from behind first.
struct FirstMeetings {
    int front = 0, back = 0;
};

/// Along a line through `through` that begins outside of the scene: which side of the material it
/// comes to first, unless it is within another thing of glass then.
void count_first(SceneProbe& probe, const Vec3& through, const Vec3& direction,
                 std::uint32_t material, FirstMeetings& meetings) {
    const Bounds bounds = probe.scene().bounds();
    Ray ray;
    ray.direction = direction;
    ray.origin = through - direction * (2 * bounds.size().length());
    ray.time = probe.time();
    int others = 0;
    probe.pass_through(ray, [&](const MetSurface& met) {
        if (met.hit.material != material) {
            others += specular_surface(met).refracts;
            return true;
        }
        if (others % 2 == 0) ++(from_behind(met.ray, met.hit) ? meetings.back : meetings.front);
        return false;
    });
}

}  // namespace

AdviceText camera_is_inside_glass(const AdviceFacts& facts) {
    const auto& seen = facts.probe.seen();
    const bool bent = !seen.empty() && std::all_of(seen.begin(), seen.end(), [](const auto& met) {
        return from_behind(met.ray, met.hit) && specular_surface(met).refracts;
    });
    if (!bent) return {};
    const auto solid = facts.probe.solid_around(facts.probe.eye());
    if (!solid) return {};
    return fmt::format(
        "the camera stands inside a solid of {}: it sees all through that surface. Move the camera "
        "or the solid, or, if it is meant so, leave it.",
        name_of_material(facts, *solid));
}

AdviceText lamp_is_inside_a_solid(const AdviceFacts& facts) {
    for (const std::size_t lamp : strongest_lamps(facts.probe.scene())) {
        const LampSurroundings found =
            look_around(facts.probe, *facts.probe.scene().lights()[lamp]);
        if (found.rays == 0 || found.gets_out || found.materials.size() != 1) continue;
        if (found.own == found.rays) {
            return fmt::format(
                "{} shines into its own shape, and nothing of it gets out: the shape is inside "
                "out. Put ReverseOrientation before it.",
                light_name(facts.session, lamp));
        }
        return fmt::format(
            "{} stands inside a closed solid of {}: none of its light gets out. Move the lamp or "
            "the solid, or make that of glass.",
            light_name(facts.session, lamp), name_of_material(facts, *found.materials.begin()));
    }
    return {};
}

AdviceText glass_is_inside_out(const AdviceFacts& facts) {
    std::map<std::uint32_t, FirstMeetings> by_material;
    const auto& specular = facts.probe.specular();
    const std::size_t step = specular.size() / kMostLines + 1;
    for (std::size_t i = 0; i < specular.size(); i += step) {
        if (!specular_surface(specular[i]).refracts) continue;
        const std::uint32_t material = specular[i].hit.material;
        count_first(facts.probe, specular[i].hit.p,
                    direction_on_sphere(static_cast<int>(i / step), static_cast<int>(kMostLines)),
                    material, by_material[material]);
    }
    for (const auto& [material, meetings] : by_material) {
        const int all = meetings.front + meetings.back;
        if (all < kLeastLines || meetings.back < kInsideOutShare * all) continue;
        return fmt::format(
            "what is made of {} is inside out: rays from outside meet its back, so that glass and "
            "air change places. Put ReverseOrientation before its shape, or turn the mesh's faces "
            "and normals.",
            name_of_material(facts, material));
    }
    return {};
}

AdviceText architectural_glass_is_curved(const AdviceFacts& facts) {
    std::map<std::uint32_t, std::set<std::tuple<int, int, int>>> normals;
    std::map<std::uint32_t, const MetSurface*> example;
    for (const MetSurface& met : facts.probe.specular()) {
        const SpecularSurface surface = specular_surface(met);
        if (!surface.passes_straight || !surface.reflects) continue;
        constexpr float kSteps = 8;
        const auto step = [](float x) { return static_cast<int>(std::lround(kSteps * x)); };
        normals[met.hit.material].insert(
            {step(met.hit.ng.x), step(met.hit.ng.y), step(met.hit.ng.z)});
        if (!from_behind(met.ray, met.hit)) example.emplace(met.hit.material, &met);
    }
    for (const auto& [material, met] : example) {
        if (normals[material].size() <= kFlatDirections) continue;
        // Within a solid all ways end at its own surface; between panes they don't.
        std::optional<std::uint32_t> solid;
        const Ray inward = spawn_ray(met->hit, met->ray.direction, facts.probe.time());
        if (const auto behind = facts.probe.meet(inward))
            solid = facts.probe.solid_around(0.5f * (met->hit.p + behind->hit.p));
        if (solid != material) continue;
        return fmt::format(
            "{} is architectural glass on a solid with a curved surface: light passes it straight, "
            "so that it bends nothing and throws no caustic. Give it \"bool architectural\" "
            "[\"false\"]; for flat panes it is right.",
            name_of_material(facts, material));
    }
    return {};
}

}  // namespace lxs
