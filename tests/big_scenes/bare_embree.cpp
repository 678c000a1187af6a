// What Embree alone needs for the geometry of scripts/big-scenes: reads a PLY file as that script
// writes it, places its mesh where FRAMES says if it is given, builds the hierarchies with the
// flags of the host, traces a picture's worth of rays, and prints bytes and seconds as JSON.
//
//     bare-embree THREADS FILE.ply [FRAMES]
//
// THREADS: of the build; 0 are all. FRAMES: 12 floats an instance, images of the axes and the
// origin.
#include <embree3/rtcore.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

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

struct Mesh {
    std::vector<float> positions;  ///< x, y, z, and a vertex behind the last that Embree may read
    std::vector<std::uint32_t> corners;
    std::size_t vertices = 0;
};

std::size_t count_after(const std::string& header, const std::string& word) {
    const std::size_t at = header.find(word);
    if (at == std::string::npos) throw std::runtime_error("no " + word + " in the header");
    return std::stoull(header.substr(at + word.size()));
}

Mesh read_mesh(const char* path) {
    std::ifstream file(path, std::ios::binary);
    std::string header, line;
    while (std::getline(file, line) && line != "end_header")
        header += line + '\n';
    if (!file) throw std::runtime_error(std::string(path) + " is no PLY file");
    Mesh mesh;
    mesh.vertices = count_after(header, "element vertex ");
    const std::size_t faces = count_after(header, "element face ");
    mesh.positions.resize(3 * mesh.vertices + 4);
    file.read(reinterpret_cast<char*>(mesh.positions.data()),
              static_cast<std::streamsize>(12 * mesh.vertices));
    mesh.corners.resize(3 * faces);
    constexpr std::size_t kFace = 13, kAtOnce = 4096;
    std::vector<char> block(kFace * kAtOnce);
    for (std::size_t done = 0; done < faces;) {
        const std::size_t count = std::min(kAtOnce, faces - done);
        if (!file.read(block.data(), static_cast<std::streamsize>(kFace * count)))
            throw std::runtime_error(std::string(path) + " is too short");
        for (std::size_t i = 0; i < count; ++i)
            std::memcpy(&mesh.corners[3 * (done + i)], &block[kFace * i + 1], 12);
        done += count;
    }
    return mesh;
}

void attach(RTCScene scene, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

RTCScene new_scene(RTCDevice device) {
    const RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    return scene;
}

RTCScene build_mesh(RTCDevice device, const Mesh& mesh) {
    const RTCScene scene = new_scene(device);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh.positions.data(), 0, 12, mesh.vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.corners.data(), 0, 12, mesh.corners.size() / 3);
    attach(scene, geometry);
    rtcCommitScene(scene);
    return scene;
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
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene, &context, &query);
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
