// LuxRender's lights in plain numbers.
//
// LuxRender samples a point of a light by area, lights at infinity by a sphere around the scene,
// and describes by a BSDF at that point where the light goes.
#include "scene_view.h"

namespace aips::luxrender {
namespace {

using luxrays::SWCSpectrum;
using luxrays::Vector;

/// A density per area at a light's point, per steradian.
float per_steradian(float per_area, const luxrays::Point& from, const luxrays::Point& at,
                    const lux::Normal& normal) {
    const Vector way(at - from);
    const float square = way.LengthSquared();
    const float cosine = AbsDot(way, normal) / sqrtf(square);
    return cosine > 0.f ? per_area * square / cosine : 0.f;
}

}  // namespace

unsigned SceneView::light_count() const {
    return static_cast<unsigned>(scene_.lights.size());
}

unsigned SceneView::light_group(unsigned light) const {
    return std::min(scene_.lights[light]->group, light_groups() - 1);
}

bool SceneView::light_at_infinity(unsigned light) const {
    return scene_.lights[light]->IsEnvironmental();
}

bool SceneView::light_is_delta(unsigned light) const {
    return scene_.lights[light]->IsDeltaLight();
}

bool SceneView::emit(unsigned light, const float place[3], const float direction[3],
                     ViewEmission& emission) const {
    LuxWorker& w = worker();
    lux::BSDF* bsdf = nullptr;
    float pdf = 0;
    SWCSpectrum power, into;
    if (!scene_.lights[light]->SampleL(scene_, w.sample, place[0], place[1], place[2], &bsdf, &pdf,
                                       &power)) {
        return false;
    }
    Vector along;
    if (!bsdf->SampleF(w.sample.swl, Vector(bsdf->dgShading.nn), &along, direction[0], direction[1],
                       direction[2], &into, &pdf)) {
        return false;
    }
    emission.ray.origin = triple_of(bsdf->dgShading.p);
    emission.ray.direction = triple_of(along);
    emission.ray.time = w.sample.realTime;
    emission.ray.volume = bsdf->GetVolume(along);
    emission.power = triple_of(power * into);
    return true;
}

bool SceneView::sample_direct(unsigned light, const Triple& from, const float u[3],
                              ViewDirect& sample) const {
    LuxWorker& w = worker();
    const lux::Light& of = *scene_.lights[light];
    lux::BSDF* bsdf = nullptr;
    float per_area = 0;
    SWCSpectrum power;
    const luxrays::Point here = point_of(from);
    if (!of.SampleL(scene_, w.sample, here, u[0], u[1], u[2], &bsdf, nullptr, &per_area, &power))
        return false;
    const luxrays::Point& there = bsdf->dgShading.p;
    const Vector way(there - here);
    const float square = way.LengthSquared();
    if (!(square > 0.f)) return false;
    const Vector wi = way / sqrtf(square);
    const Vector normal(bsdf->dgShading.nn);
    SWCSpectrum value = power * bsdf->F(w.sample.swl, normal, -wi, false) / square;
    if (value.Black()) return false;
    sample.delta = of.IsDeltaLight();
    sample.pdf = sample.delta ? 1.f : per_steradian(per_area, here, there, bsdf->dgShading.nn);
    if (!(sample.pdf > 0.f)) return false;
    // LuxRender has divided by the density.
    if (!sample.delta) value *= sample.pdf;
    sample.wi = triple_of(wi);
    sample.distance = sqrtf(square);
    sample.radiance = triple_of(value);
    sample.end = triple_of(there);
    return true;
}

float SceneView::pdf_direct(unsigned light, const Triple& from, const Triple& at,
                            const Triple& normal) const {
    LuxWorker& w = worker();
    const lux::Light& of = *scene_.lights[light];
    if (of.IsDeltaLight()) return 0.f;
    const Vector along = vector_of(normal);
    Vector u, v;
    luxrays::CoordinateSystem(along, &u, &v);
    lux::PartialDifferentialGeometry there(point_of(at), lux::Normal(along), u, v);
    there.time = w.sample.realTime;
    return per_steradian(of.Pdf(point_of(from), there), point_of(from), there.p, there.nn);
}

float SceneView::pdf_escaping(unsigned light, const Triple& from, const Triple& wi) const {
    LuxWorker& w = worker();
    const lux::Light& of = *scene_.lights[light];
    if (of.IsDeltaLight()) return 0.f;
    luxrays::Ray ray(point_of(from), vector_of(wi));
    ray.time = w.sample.realTime;
    lux::BSDF* bsdf = nullptr;
    float per_area = 0;
    SWCSpectrum radiance(1.f);
    if (!of.Le(scene_, w.sample, ray, &bsdf, nullptr, &per_area, &radiance)) return 0.f;
    return per_steradian(per_area, ray.o, bsdf->dgShading.p, bsdf->dgShading.nn);
}

Triple SceneView::escaped(unsigned light, const Triple& direction) const {
    LuxWorker& w = worker();
    const lux::Light& of = *scene_.lights[light];
    if (!of.IsEnvironmental()) return {};
    luxrays::Point centre;
    float radius = 0;
    scene_.WorldBound().BoundingSphere(&centre, &radius);
    luxrays::Ray ray(centre, vector_of(direction));
    ray.time = w.sample.realTime;
    lux::BSDF* bsdf = nullptr;
    SWCSpectrum radiance(1.f);
    if (!of.Le(scene_, w.sample, ray, &bsdf, nullptr, nullptr, &radiance)) return {};
    return triple_of(radiance);
}

}  // namespace aips::luxrender
