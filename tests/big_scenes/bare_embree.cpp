// What Embree alone needs for the geometry of scripts/big-scenes: reads a PLY file as that script
// writes it, places its mesh where FRAMES says if it is given, builds the hierarchies with the
// flags of the host, traces a picture's worth of rays, and prints bytes and seconds as JSON.
//
//     bare-embree THREADS FILE.ply [FRAMES]
//
// THREADS: of the build; 0 are all. FRAMES: 12 floats an instance, images of the axes and the
// origin.
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include "lxs/embree/queries.h"
#include "ply_mesh.h"

namespace {

using big_scenes::attach;
using big_scenes::build_mesh;
using big_scenes::Mesh;
using big_scenes::new_scene;
using big_scenes::read_mesh;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::size_t resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    statm >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Embree keeps a copy of each frame.
RTCScene build_instances(RTCDevice device, RTCScene object, const char* frames) {
    const RTCScene scene = new_scene(device);
    std::ifstream file(frames, std::ios::binary);
    std::array<float, 12> frame{};
    while (file.read(reinterpret_cast<char*>(frame.data()), sizeof(frame))) {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, object);
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, frame.data());
        attach(scene, geometry);
    }
    rtcCommitScene(scene);
    return scene;
}

/// Rays down on the square from -1 to 1, as many as the script's picture has pixels.
int hits(RTCScene scene) {
    constexpr int kWidth = 160, kHeight = 120;
    int met = 0;
    for (int i = 0; i < kWidth * kHeight; ++i) {
        const int column = i % kWidth, row = i / kWidth;
        RTCRayHit query{};
        query.ray.org_x = 2 * (static_cast<float>(column) + 0.5f) / kWidth - 1;
        query.ray.org_y = 2 * (static_cast<float>(row) + 0.5f) / kHeight - 1;
        query.ray.org_z = 2;
        query.ray.dir_z = -1;
        query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.mask = ~0u;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        lxs::embree::intersect(scene, query);
        met += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return met;
}

void measure(const std::string& threads, const char* ply, const char* frames) {
    const auto begin = Clock::now();
    const Mesh mesh = read_mesh(ply);
    const double read = seconds_since(begin);
    const RTCDevice device = rtcNewDevice(("threads=" + threads).c_str());
    const RTCScene object = build_mesh(device, mesh);
    const RTCScene scene = frames ? build_instances(device, object, frames) : object;
    const double built = seconds_since(begin);
    const int met = hits(scene);
    std::printf(
        "{\"triangles\": %zu, \"hits\": %d, \"seconds\": {\"load\": %.3f, \"build\": %.3f, "
        "\"first pixels\": %.3f}, \"resident bytes\": %zu, \"peak memory bytes\": %zu}\n",
        mesh.corners.size() / 3, met, read, built - read, seconds_since(begin), resident_bytes(),
        peak_bytes());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("bare-embree THREADS FILE.ply [FRAMES]\n", stderr);
        return 2;
    }
    try {
        measure(argv[1], argv[2], argc > 3 ? argv[3] : nullptr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bare-embree: %s\n", error.what());
        return 1;
    }
    return 0;
}
