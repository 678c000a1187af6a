// Embree 3.13 or 4, whichever the build found, by one set of calls: all that differs between the
// two stands here. The rest of the library's interface is the same in both.
#pragma once

#if LXS_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace lxs::embree {

#if LXS_EMBREE_MAJOR >= 4

/// What a query hands to callbacks: instances that the ray is in, and what derives from it.
using QueryContext = RTCRayQueryContext;
/// Of scenes that are asked by `intersect_filtered`.
inline constexpr RTCSceneFlags kFilteredByQueries = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

/// Nearest hit; `query.hit.geomID` and `.instID[0]` are RTC_INVALID_GEOMETRY_ID before it.
inline void intersect(RTCScene scene, RTCRayHit& query) {
    rtcIntersect1(scene, &query);
}

/// Sets `ray.tfar` below zero if anything lies on the ray.
inline void occluded(RTCScene scene, RTCRay& ray) {
    rtcOccluded1(scene, &ray);
}

/// As `intersect`, of hits that `filter` lets through; it is shown `context`, which this prepares.
inline void intersect_filtered(RTCScene scene, RTCRayHit& query, RTCFilterFunctionN filter,
                               QueryContext& context) {
    rtcInitRayQueryContext(&context);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = static_cast<RTCRayQueryFlags>(RTC_RAY_QUERY_FLAG_INCOHERENT |
                                                    RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER);
    arguments.context = &context;
    arguments.filter = filter;
    rtcIntersect1(scene, &query, &arguments);
}

#else

using QueryContext = RTCIntersectContext;
inline constexpr RTCSceneFlags kFilteredByQueries = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void intersect(RTCScene scene, RTCRayHit& query) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
}

inline void occluded(RTCScene scene, RTCRay& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
}

inline void intersect_filtered(RTCScene scene, RTCRayHit& query, RTCFilterFunctionN filter,
                               QueryContext& context) {
    rtcInitIntersectContext(&context);
    context.filter = filter;
    rtcIntersect1(scene, &context, &query);
}

#endif

}  // namespace lxs::embree
