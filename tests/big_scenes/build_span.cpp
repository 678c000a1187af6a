// What more processors would make of Embree's own build of a hierarchy, which scripts/scaling does
// not see: its work and span, from a build on one thread whose tasks are divided as for 64.
//
//     build-span FILE.ply
//
// FILE.ply is one that scripts/big-scenes writes. Prints JSON; seconds on a number of processors
// are those that they need at most.
#include <cstdio>
#include <exception>

#include "ply_mesh.h"
#include "task_span.h"

namespace {

constexpr int kProcessors = 64;

void measure(const char* ply) {
    const big_scenes::Mesh mesh = big_scenes::read_mesh(ply);
    const RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = nullptr;
    const task_span::Span span =
        task_span::measure(kProcessors, [&] { scene = big_scenes::build_mesh(device, mesh); });
    std::printf("{\"triangles\": %zu, \"tasks\": %llu, \"seconds\": {\"1\": %.4f",
                mesh.corners.size() / 3, static_cast<unsigned long long>(span.tasks), span.work);
    for (int processors = 2; processors <= kProcessors; processors *= 2)
        std::printf(", \"%d\": %.4f", processors, span.on(processors));
    std::printf(", \"any\": %.4f}}\n", span.span);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("build-span FILE.ply\n", stderr);
        return 2;
    }
    try {
        measure(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "build-span: %s\n", error.what());
        return 1;
    }
    return 0;
}
