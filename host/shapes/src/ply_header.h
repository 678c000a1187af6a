// Headers of PLY files: what follows them, and how it is written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace lxs {

enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };
enum class PlyFormat : std::uint8_t { Ascii, LittleEndian, BigEndian };

/// One property of an element: a value, or a list with its count before it.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float;
    bool is_list = false;
    PlyType count_type = PlyType::UInt8;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
    /// Index of the first property of one of these names, or -1.
    int find(std::initializer_list<std::string_view> names) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;  ///< of the header, in bytes: the data begin here
};

/// Throws std::runtime_error that says what is wrong with it.
PlyHeader read_ply_header(std::string_view file);

}  // namespace lxs
