// Joining of logs.
#include "worth/path_log.h"

namespace aips {

void PathLog::append(const PathLog& other, std::uint32_t landings) {
    const auto vertices_before = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
    for (PathRecord record : other.paths) {
        record.first_vertex += vertices_before;
        record.first_landing += landings;
        paths.push_back(record);
    }
}

}  // namespace aips
