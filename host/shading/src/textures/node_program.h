// A graph of Blender's shader nodes as a program: one instruction a node, evaluated at a point.
//
// Each instruction is a line of words: its name, its modes, its inputs, and for some a table of
// numbers. An input is a number, or rN for the value of instruction N, from 0 on. Values are three
// numbers; those of one number have it three times. docs/reference/shading.md has the list.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lxs/scene/texture.h"

namespace lxs::shading::nodes {

class NodeProgram {
  public:
    static constexpr std::size_t kMostInstructions = 256;

    using Inputs = std::vector<std::shared_ptr<const ColorTexture>>;

    /// Throws std::runtime_error with the reason if a line cannot be read. `textures` are what
    /// instruction "texture" asks for by number, from 1 on.
    NodeProgram(const std::vector<std::string>& lines, Inputs textures);

    /// The value of the last instruction; what is not finite is 0.
    Vec3 evaluate(const TexturePoint& point) const;
    /// Whether the value is the same everywhere.
    bool constant() const { return constant_; }
    bool reads_image() const;
    float cell_size() const;

    struct Operand {
        int instruction = -1;  ///< whose value it is; -1: `number`
        float number = 0;
    };
    struct Instruction {
        std::uint8_t name = 0;
        std::vector<std::uint8_t> modes;
        std::vector<Operand> inputs;
        std::vector<float> table;
    };

  private:
    std::vector<Instruction> instructions_;
    Inputs textures_;
    bool constant_ = true;
};

}  // namespace lxs::shading::nodes
