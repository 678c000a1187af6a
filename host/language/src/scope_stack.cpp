// Scopes of the graphics state.
#include "scope_stack.h"

#include <algorithm>

#include "lxs/scene/registry.h"

namespace lxs {
namespace {

constexpr std::size_t kMostScopes = 10000;  // open at a time; each keeps a state of some 500 bytes

std::string_view statement_stem(ScopeKind kind) {
    switch (kind) {
        case ScopeKind::Transform:
            return "Transform";
        case ScopeKind::Attribute:
            return "Attribute";
        case ScopeKind::Object:
            return "Object";
    }
    return {};
}

void report_unclosed(ScopeKind kind, const SourceLocation& where, Diagnostics& diagnostics) {
    const std::string stem(statement_stem(kind));
    diagnostics.fallback(where, stem + "Begin is not closed by " + stem + "End",
                         "it ends with what is around it");
}

}  // namespace

void ScopeStack::begin(ScopeKind kind, const SourceLocation& where) {
    if (scopes_.size() >= kMostScopes) {
        throw EndOfReading(where, std::string(statement_stem(kind)) + "Begin nests deeper than " +
                                      std::to_string(kMostScopes) + " levels");
    }
    scopes_.push_back({kind, where, transform, motion, graphics});
}

void ScopeStack::end(ScopeKind kind, const SourceLocation& where, Diagnostics& diagnostics) {
    // The order of ScopeKind: an end closes forgotten scopes of lesser kind, never a greater one.
    const auto found = std::find_if(scopes_.rbegin(), scopes_.rend(),
                                    [&](const Scope& scope) { return scope.kind >= kind; });
    if (found == scopes_.rend() || found->kind != kind) {
        const std::string stem(statement_stem(kind));
        diagnostics.fallback(where, stem + "End without " + stem + "Begin", "it is ignored");
        return;
    }
    for (auto inner = scopes_.rbegin(); inner != found; ++inner) {
        report_unclosed(inner->kind, inner->where, diagnostics);
    }
    const auto depth = static_cast<std::size_t>(scopes_.rend() - found);
    while (scopes_.size() >= depth)
        pop();
}

void ScopeStack::close_all(Diagnostics& diagnostics) {
    for (const Scope& scope : scopes_)
        report_unclosed(scope.kind, scope.where, diagnostics);
    while (!scopes_.empty())
        pop();
}

void ScopeStack::pop() {
    Scope& scope = scopes_.back();
    transform = scope.transform;
    motion = std::move(scope.motion);
    if (scope.kind != ScopeKind::Transform) graphics = std::move(scope.graphics);
    scopes_.pop_back();
}

}  // namespace lxs
