// Meshes in PLY files, read with Assimp.
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>

#include "mesh_data.h"
#include "shape_factories.h"

namespace lxs {
namespace {

std::vector<ParameterDeclaration> ply_parameters() {
    using enum ParameterType;
    std::vector<ParameterDeclaration> parameters = {
        {"filename", String, "", "PLY file, text or binary; faces may have any number of corners."},
        {"smooth", Bool, "false",
         "Make smooth normals in place of the file's; always so if it has none."},
    };
    ParameterDeclaration colours{"usecolor", Bool, "true", "Use the file's vertex colours."};
    colours.no_effect = true;
    parameters.push_back(colours);
    for (const ParameterDeclaration& more : compatibility_parameters())
        parameters.push_back(more);
    return parameters;
}

void append_triangles(const aiMesh& file, const MeshSource& source,
                      std::vector<std::uint32_t>& indices) {
    indices.reserve(static_cast<std::size_t>(file.mNumFaces) * 3);
    for (unsigned face = 0; face < file.mNumFaces; ++face) {
        const aiFace& corners = file.mFaces[face];
        if (corners.mNumIndices < 3) {
            source.reader.fail(source.parameter, fmt::format("face {} of {} has {} corners", face,
                                                             source.label, corners.mNumIndices));
        }
        for (unsigned k = 0; k < corners.mNumIndices; ++k) {
            if (corners.mIndices[k] < file.mNumVertices) continue;
            source.reader.fail(
                source.parameter,
                fmt::format("face {} of {} names vertex {}, but there are {} "
                            "vertices, numbered from 0",
                            face, source.label, corners.mIndices[k], file.mNumVertices));
        }
        for (unsigned k = 1; k + 1 < corners.mNumIndices; ++k) {
            for (const unsigned corner : {0u, k, k + 1})
                indices.push_back(corners.mIndices[corner]);
        }
    }
}

std::vector<Vec3> vectors(const aiVector3D* first, unsigned count) {
    std::vector<Vec3> result;
    result.reserve(count + std::size_t{1});
    for (unsigned i = 0; i < count; ++i)
        result.emplace_back(first[i].x, first[i].y, first[i].z);
    return result;
}

/// The file's only mesh: without post-processing Assimp leaves a PLY file in one piece.
TriangleMesh read_file(const std::string& path, const MeshSource& source) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path, 0);
    if (!scene) {
        source.reader.fail(source.parameter, fmt::format("{} can't be read: {}", source.label,
                                                         importer.GetErrorString()));
    }
    if (scene->mNumMeshes != 1) {
        source.reader.fail(source.parameter, fmt::format("{} holds no mesh", source.label));
    }
    const aiMesh& file = *scene->mMeshes[0];
    TriangleMesh mesh;
    mesh.positions = vectors(file.mVertices, file.mNumVertices);
    check_vectors(mesh.positions, "vertex", source);
    append_triangles(file, source, mesh.indices);
    if (file.HasNormals()) {
        mesh.normals = vectors(file.mNormals, file.mNumVertices);
        check_vectors(mesh.normals, "normal", source);
    }
    if (file.HasTextureCoords(0)) {
        for (const Vec3& uvw : vectors(file.mTextureCoords[0], file.mNumVertices))
            mesh.uvs.emplace_back(uvw.x, uvw.y);
        check_coordinates(mesh.uvs, source);
    }
    return mesh;
}

Geometry create_ply(const ParameterReader& reader, const AssetContext& assets,
                    const Matrix& to_world) {
    warn_unrendered(reader);
    const std::string name = reader.string("filename", "");
    if (name.empty())
        reader.fail("filename", "plymesh needs a file: \"string filename\" [\"...\"]");
    const std::string path = assets.resolve(name, reader.where("filename"));
    TriangleMesh mesh = read_file(path, {reader, "filename", fmt::format("\"{}\"", name)});
    if (mesh.normals.empty() || reader.boolean("smooth", false))
        mesh.normals = smooth_normals(mesh.positions, mesh.indices);
    return finish_mesh(std::move(mesh), to_world, reader);
}

}  // namespace

ShapeFactory make_ply_factory() {
    return {ply_parameters(), create_ply};
}

}  // namespace lxs
