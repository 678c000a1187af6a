// Reads headers of PLY files (Turk 1994, "The PLY polygon file format").
#include "ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "lxs/sdk/diagnostics.h"

namespace lxs {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t begin = line.find_first_not_of(kBlanks);
    while (begin != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kBlanks, end);
    }
    return words;
}

PlyType type_of(std::string_view word) {
    using enum PlyType;
    struct Entry {
        std::string_view name;
        PlyType type;
    };
    constexpr std::array<Entry, 16> kTypes = {{{"char", Int8},
                                               {"int8", Int8},
                                               {"uchar", UInt8},
                                               {"uint8", UInt8},
                                               {"short", Int16},
                                               {"int16", Int16},
                                               {"ushort", UInt16},
                                               {"uint16", UInt16},
                                               {"int", Int32},
                                               {"int32", Int32},
                                               {"uint", UInt32},
                                               {"uint32", UInt32},
                                               {"float", Float},
                                               {"float32", Float},
                                               {"double", Double},
                                               {"float64", Double}}};
    for (const Entry& entry : kTypes) {
        if (entry.name == word) return entry.type;
    }
    throw std::runtime_error(fmt::format("unknown type {} in its header", in_quotes(word)));
}

PlyFormat format_of(std::string_view word) {
    if (word == "ascii") return PlyFormat::Ascii;
    if (word == "binary_little_endian") return PlyFormat::LittleEndian;
    if (word == "binary_big_endian") return PlyFormat::BigEndian;
    throw std::runtime_error(fmt::format("unknown format {}", in_quotes(word)));
}

void read_line(const std::vector<std::string_view>& words, PlyHeader& header) {
    const auto malformed = [&] {
        return std::runtime_error(fmt::format("a \"{}\" line of its header is damaged", words[0]));
    };
    if (words[0] == "format") {
        if (words.size() < 2) throw malformed();
        header.format = format_of(words[1]);
    } else if (words[0] == "element") {
        PlyElement element;
        if (words.size() != 3) throw malformed();
        element.name = words[1];
        const auto read = std::from_chars(words[2].begin(), words[2].end(), element.count);
        if (read.ec != std::errc() || read.ptr != words[2].end()) throw malformed();
        header.elements.push_back(std::move(element));
    } else if (words[0] == "property") {
        const bool is_list = words.size() == 5 && words[1] == "list";
        if (header.elements.empty() || (!is_list && words.size() != 3)) throw malformed();
        PlyProperty property;
        property.name = words.back();
        property.is_list = is_list;
        property.type = type_of(words[words.size() - 2]);
        if (is_list) property.count_type = type_of(words[2]);
        header.elements.back().properties.push_back(std::move(property));
    } else if (words[0] != "comment" && words[0] != "obj_info") {
        throw std::runtime_error(fmt::format("unknown word {} in its header", in_quotes(words[0])));
    }
}

}  // namespace

int PlyElement::find(std::initializer_list<std::string_view> names) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
        if (std::find(names.begin(), names.end(), properties[i].name) != names.end())
            return static_cast<int>(i);
    }
    return -1;
}

PlyHeader read_ply_header(std::string_view file) {
    PlyHeader header;
    std::size_t begin = 0;
    for (int line_number = 0;; ++line_number) {
        const std::size_t end = file.find('\n', begin);
        if (end == std::string_view::npos) {
            throw std::runtime_error(line_number == 0 ? "it is not a PLY file"
                                                      : "its header has no end");
        }
        const std::vector<std::string_view> words = words_of(file.substr(begin, end - begin));
        begin = end + 1;
        if (line_number == 0) {
            if (words.size() != 1 || words[0] != "ply")
                throw std::runtime_error("it is not a PLY file");
            continue;
        }
        if (words.empty()) continue;
        if (words[0] == "end_header") break;
        read_line(words, header);
    }
    header.size = begin;
    return header;
}

}  // namespace lxs
