// Reads STL files (3D Systems 1989, "StereoLithography Interface Specification").
#include "stl_mesh.h"

#include <charconv>
#include <stdexcept>

#include "ply_values.h"

namespace lxs {
namespace {

constexpr std::size_t kBinaryHeader = 84;  // 80 bytes of text, the number of facets
constexpr std::size_t kBinaryFacet = 50;   // normal, three corners, two bytes of attributes

void add_corner(const Vec3& p, TriangleMesh& mesh) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(p);
}

Vec3 next_vector(PlyValues& values) {
    Vec3 v;
    for (int i = 0; i < 3; ++i)
        v[i] = static_cast<float>(values.next(PlyType::Float));
    return v;
}

TriangleMesh read_binary(std::string_view file, std::size_t facets) {
    TriangleMesh mesh;
    mesh.positions.reserve(3 * facets + 1);
    mesh.indices.reserve(3 * facets);
    for (std::size_t i = 0; i < facets; ++i) {
        PlyValues values(file.substr(kBinaryHeader + i * kBinaryFacet, kBinaryFacet),
                         PlyFormat::LittleEndian);
        next_vector(values);
        for (int corner = 0; corner < 3; ++corner)
            add_corner(next_vector(values), mesh);
    }
    return mesh;
}

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Whether the `length` characters at `at` are the first word of a line: a solid's name may hold
/// them too.
bool is_first_word(std::string_view file, std::size_t at, std::size_t length) {
    const std::size_t end = at + length;
    if (end >= file.size() || !is_blank(file[end])) return false;
    std::size_t begin = at;
    while (begin > 0 && file[begin - 1] != '\n' && file[begin - 1] != '\r') {
        if (!is_blank(file[--begin])) return false;
    }
    return true;
}

/// All that counts of the text are its lines "vertex x y z".
TriangleMesh read_text(std::string_view file) {
    constexpr std::string_view kVertex = "vertex";
    TriangleMesh mesh;
    for (std::size_t at = file.find(kVertex); at != std::string_view::npos;
         at = file.find(kVertex, at + 1)) {
        if (!is_first_word(file, at, kVertex.size())) continue;
        PlyValues values(file.substr(at + kVertex.size()), PlyFormat::Ascii);
        add_corner(next_vector(values), mesh);
    }
    if (mesh.indices.size() % 3 != 0)
        throw std::runtime_error("its vertices are not three to a facet");
    return mesh;
}

}  // namespace

TriangleMesh read_stl_mesh(std::string_view file) {
    TriangleMesh mesh;
    // Binary files too may begin with "solid": their size tells.
    if (file.size() >= kBinaryHeader) {
        PlyValues count(file.substr(80, 4), PlyFormat::LittleEndian);
        const auto facets = static_cast<std::size_t>(count.next(PlyType::UInt32));
        if (file.size() >= kBinaryHeader + facets * kBinaryFacet && facets > 0 &&
            (!file.starts_with("solid") || file.size() == kBinaryHeader + facets * kBinaryFacet)) {
            mesh = read_binary(file, facets);
        }
    }
    if (!mesh.indices.empty()) return mesh;
    if (!file.starts_with("solid")) throw std::runtime_error("it holds no STL mesh");
    return read_text(file);
}

}  // namespace lxs
