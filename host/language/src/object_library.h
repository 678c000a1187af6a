// Named objects (ObjectBegin/End) and their instances.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "lxs/language/arguments.h"
#include "lxs/scene/contents.h"
#include "unknown_names.h"

namespace lxs {

/// What an instance passes on to the shapes of its object that have none of their own.
struct Inheritance {
    std::shared_ptr<const Material> material;
    std::uint32_t material_index = 0;
    std::shared_ptr<const Medium> interior, exterior;
};

/// Objects as they are defined, instances as they are placed in the world. Objects may hold
/// instances of other objects; the finished scene has one level: each placed part is an Instance
/// of an ObjectDefinition. Objects of which no instance is placed are left out.
class ObjectLibrary {
  public:
    ObjectLibrary(UnknownNames& unknown, Diagnostics& diagnostics)
        : unknown_(unknown), diagnostics_(diagnostics) {}

    /// Throws InputError inside of another object.
    void begin(const Name& name);
    /// Throws InputError when no object is open or it nests too deep.
    void end(const SourceLocation& where);
    /// Where the object being defined begins; null outside of objects.
    const SourceLocation* open() const { return recording_ ? &objects_.back().where : nullptr; }

    /// Adds to the object being defined.
    void add(Primitive primitive) { objects_.back().primitives.push_back(std::move(primitive)); }
    void add(LightDescription light) { objects_.back().lights.push_back(std::move(light)); }

    /// Places an object in the world or in the object being defined. Throws InputError for an
    /// unknown name and for more than ten million placed parts.
    void place(const Name& name, const MovingTransform& transform, const Inheritance& inherited,
               SceneContents& contents);

    /// Moves the definitions in use to `contents`; shapes that found no material get `fallback`.
    void finish(const Inheritance& fallback, SceneContents& contents);
    /// True if some shape may still be without material.
    bool lacks_material() const;

  private:
    struct Child {
        std::size_t object;
        MovingTransform transform;
        Inheritance inherited;
    };
    struct Object {
        std::string name;
        SourceLocation where;
        std::vector<Primitive> primitives;
        std::vector<LightDescription> lights;
        std::vector<Child> children;
        /// Into SceneContents::outer_objects, once it was placed around others.
        std::uint32_t outer = Instance::kNoOuterObject;
        // Set by end():
        int depth = 1;     ///< levels of objects, itself included
        double parts = 0;  ///< definitions and lights that one instance places
        bool shines = false;
        bool lacks_material = false, lacks_interior = false, lacks_exterior = false;
    };
    /// An object with the inheritance that its shapes need: one ObjectDefinition.
    struct Variant {
        std::size_t object;
        Inheritance inherited;
    };
    using VariantKey = std::tuple<std::size_t, const void*, const void*, const void*>;

    std::size_t find(const Name& name) const;
    void expand(std::size_t object, const MovingTransform& transform, const Inheritance& inherited,
                std::uint32_t outer, SceneContents& contents);
    /// Index into SceneContents::outer_objects, which gets the name at its first use.
    static std::uint32_t outer_index(Object& placed, SceneContents& contents);
    /// Stills objects that shine, with a warning.
    MovingTransform placed(const Object& object, const MovingTransform& transform) const;
    std::size_t variant(std::size_t object, Inheritance inherited);

    UnknownNames& unknown_;
    Diagnostics& diagnostics_;
    std::vector<Object> objects_;
    std::map<std::string, std::size_t> by_name_;
    std::vector<Variant> variants_;
    std::map<VariantKey, std::size_t> variant_index_;
    bool recording_ = false;
};

}  // namespace lxs
