// The graphics state and its scopes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lxs/scene/contents.h"

namespace lxs {

/// What AttributeBegin saves besides the transform.
struct GraphicsState {
    std::shared_ptr<const Material> material;  ///< null: none was named yet
    std::uint32_t material_index = 0;          ///< meaningful with a material
    std::shared_ptr<const Medium> interior, exterior;
    std::shared_ptr<const AreaEmission> emission;  ///< null: shapes do not shine
    std::string light_group = "default";
    bool reverse_orientation = false;
};

/// Kinds of scopes, the lesser ones first: an end never closes a greater scope than its own.
enum class ScopeKind : std::uint8_t { Transform, Attribute, Object };

/// The current state and the states to which the ends of open scopes return.
class ScopeStack {
  public:
    GraphicsState graphics;
    Matrix transform;  ///< where a motion begins
    Motion motion;     ///< of the transform; empty: still

    /// Throws EndOfReading if there are too many open scopes.
    void begin(ScopeKind kind, const SourceLocation& where);
    /// Closes the innermost scope of this kind, and those still open in it, which are reported.
    /// An end without begin is reported and ignored, as LuxRender does.
    void end(ScopeKind kind, const SourceLocation& where, Diagnostics& diagnostics);
    /// Reports scopes still open at the end of the world, and forgets them.
    void close_all(Diagnostics& diagnostics);

  private:
    struct Scope {
        ScopeKind kind;
        SourceLocation where;
        Matrix transform;
        Motion motion;
        GraphicsState graphics;
    };
    void pop();

    std::vector<Scope> scopes_;
};

}  // namespace lxs
