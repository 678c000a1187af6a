// Reading row by row, so that the file is never in memory beside the mesh.
#include "ply_mesh.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace big_scenes {
namespace {

std::size_t count_after(const std::string& header, const std::string& word) {
    const std::size_t at = header.find(word);
    if (at == std::string::npos) throw std::runtime_error("no " + word + " in the header");
    return std::stoull(header.substr(at + word.size()));
}

}  // namespace

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

}  // namespace big_scenes
