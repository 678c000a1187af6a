// Reads packets of tev's protocol, as the viewer does.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lxs::test {

struct ShownImage {
    std::int32_t width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<std::vector<float>> values;  ///< by channel, row by row
    int created = 0, updates = 0;
};

/// Does to `images`, by name, what a packet says; `packet`: what follows its length. Throws
/// std::runtime_error where it is none that lxsrender may send.
void take_tev_packet(const std::vector<char>& packet, std::map<std::string, ShownImage>& images);

}  // namespace lxs::test
