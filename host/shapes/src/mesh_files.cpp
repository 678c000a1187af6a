// Meshes in PLY and STL files.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <any>
#include <cmath>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>

#include "empty_shape.h"
#include "mesh_data.h"
#include "mesh_refinement.h"
#include "ply_mesh.h"
#include "shape_factories.h"
#include "stl_mesh.h"

namespace lxs {
namespace {

/// A file's bytes; a string would write zeros over all of them first.
struct FileText {
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;
    std::string_view view() const { return {bytes.get(), size}; }
};

FileText whole_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw std::runtime_error("it can't be opened");
    FileText text;
    text.size = static_cast<std::size_t>(file.tellg());
    text.bytes = std::make_unique_for_overwrite<char[]>(text.size);
    file.seekg(0);
    if (!file.read(text.bytes.get(), static_cast<std::streamsize>(text.size)))
        throw std::runtime_error("reading stopped before its end");
    return text;
}

/// The same, unpacked if it is of gzip's format by its first bytes.
FileText whole_file_unpacked(const std::string& path) {
    FileText packed = whole_file(path);
    const std::string_view bytes = packed.view();
    if (!bytes.starts_with("\x1f\x8b")) return packed;
    // A longer one is no mesh; it also bounds what a small file may ask for.
    constexpr std::size_t kMostBytes = std::size_t{64} << 30;
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), &gzclose);
    if (!file) throw std::runtime_error("it can't be opened");
    FileText text;
    std::size_t room = std::min(4 * packed.size + 4096, kMostBytes);
    text.bytes = std::make_unique_for_overwrite<char[]>(room);
    for (;;) {
        const auto block = static_cast<unsigned>(std::min<std::size_t>(room - text.size, 1 << 30));
        const int read = gzread(file.get(), text.bytes.get() + text.size, block);
        if (read < 0) throw std::runtime_error("its compressed data is damaged");
        text.size += static_cast<std::size_t>(read);
        if (static_cast<unsigned>(read) < block) break;
        if (text.size < room) continue;
        if (room == kMostBytes) throw std::runtime_error("it is longer than 64 GiB unpacked");
        room = std::min(2 * room, kMostBytes);
        auto more = std::make_unique_for_overwrite<char[]>(room);
        std::copy_n(text.bytes.get(), text.size, more.get());
        text.bytes = std::move(more);
    }
    int status = Z_OK;
    gzerror(file.get(), &status);
    if (status != Z_OK && status != Z_STREAM_END)
        throw std::runtime_error("its compressed data is damaged");
    return text;
}

using ReadMesh = TriangleMesh (*)(std::string_view file);

/// A mesh that was read ahead; shared, as std::any wants copies.
using MeshAhead = std::shared_ptr<TriangleMesh>;

/// For Factory::read_file.
template <ReadMesh kRead>
std::any read_ahead(const std::string& path) {
    return std::make_shared<TriangleMesh>(kRead(whole_file_unpacked(path).view()));
}

constexpr std::string_view kFile = "filename";

MeshSource file_source(const ParameterReader& reader) {
    return {reader, kFile, fmt::format("\"{}\"", reader.string(kFile, ""))};
}

/// The file that the statement names, read by `read`, with positions that can be used.
TriangleMesh read_mesh(const ParameterReader& reader, const AssetContext& assets, ReadMesh read) {
    const std::string name = reader.string(kFile, "");
    if (name.empty()) {
        reader.fail(kFile,
                    fmt::format("{} needs a file: \"string filename\" [\"...\"]", reader.plugin()));
    }
    const std::string path = assets.resolve(name, reader.where(kFile));
    TriangleMesh mesh;
    try {
        const std::any ahead = assets.take_ahead(std::string(reader.plugin()), path);
        if (const auto* known = std::any_cast<MeshAhead>(&ahead)) {
            mesh = std::move(**known);
        } else {
            mesh = read(whole_file_unpacked(path).view());
        }
    } catch (const std::bad_alloc&) {
        throw EndOfReading(reader.where(kFile),
                           fmt::format("not enough memory for the mesh in \"{}\"", name));
    } catch (const std::runtime_error& error) {
        reader.fail(kFile, fmt::format("\"{}\" can't be read: {}", name, error.what()));
    }
    if (mesh.indices.empty())
        fail_empty(reader, kFile, fmt::format("\"{}\" holds a mesh without triangles", name));
    mend_positions(mesh, file_source(reader));
    return mesh;
}

Geometry create_ply(const ParameterReader& reader, const AssetContext& assets,
                    const Matrix& to_world) {
    TriangleMesh mesh = read_mesh(reader, assets, read_ply_mesh);
    if (!reader.boolean("usecolor", true)) mesh.colors.clear();
    if (reader.boolean("discardmeshnormals", false)) mesh.normals.clear();
    const MeshSource source = file_source(reader);
    mend_normals(mesh, source);
    mend_coordinates(mesh, source);
    mend_colors(mesh, source);
    mend_alphas(mesh, source);
    apply_gamma(mesh.colors, static_cast<float>(reader.number("gamma", 1)));
    mesh = refine(std::move(mesh), reader, assets, to_world, "nsubdivlevels", 0);
    const bool refined = reader.integer("nsubdivlevels", 0) > 0 || reader.given("displacementmap");
    const bool flat = reader.boolean("facesbynormals", false);
    if (!refined && ((mesh.normals.empty() && !flat) || reader.boolean("smooth", false)))
        mesh.normals = smooth_normals(mesh.positions, mesh.indices);
    return finish_mesh(std::move(mesh), to_world, reader);
}

Geometry create_stl(const ParameterReader& reader, const AssetContext& assets,
                    const Matrix& to_world) {
    TriangleMesh mesh = read_mesh(reader, assets, read_stl_mesh);
    return finish_mesh(refine(std::move(mesh), reader, assets, to_world, "nsubdivlevels", 0),
                       to_world, reader);
}

std::vector<ParameterDeclaration> file_parameters(std::vector<ParameterDeclaration> own) {
    for (const auto& more :
         {refinement_parameters("nsubdivlevels", "0"), compatibility_parameters()})
        own.insert(own.end(), more.begin(), more.end());
    return own;
}

}  // namespace

ShapeFactory make_ply_factory() {
    using enum ParameterType;
    return {
        file_parameters({{"filename", String, "",
                          "PLY file, text or binary, also packed by gzip; faces may have any "
                          "number of corners."},
                         {"smooth", Bool, "false",
                          "Make smooth normals in place of the file's; always so if it has none."},
                         {"usecolor", Bool, "true", "Use the file's vertex colours."},
                         {"gamma", Float, "1", "Exponent of the file's vertex colours.", 0}}),
        create_ply, read_ahead<read_ply_mesh>};
}

ShapeFactory make_stl_factory() {
    return {file_parameters({{"filename", ParameterType::String, "",
                              "STL file, text or binary; its facets are flat."}}),
            create_stl, read_ahead<read_stl_mesh>};
}

}  // namespace lxs
