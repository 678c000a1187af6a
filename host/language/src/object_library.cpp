// Objects, nesting, inheritance, instances.
#include "object_library.h"

#include <algorithm>

#include "lxs/scene/registry.h"

namespace lxs {
namespace {

constexpr int kMaxDepth = 64;
constexpr double kMaxParts = 1e7;  // placed parts: 1.4 GB of instances

/// What `outer` adds where `inner` has nothing.
Inheritance combined(Inheritance inner, const Inheritance& outer) {
    if (!inner.material) {
        inner.material = outer.material;
        inner.material_index = outer.material_index;
    }
    if (!inner.interior) inner.interior = outer.interior;
    if (!inner.exterior) inner.exterior = outer.exterior;
    return inner;
}

void inherit(Primitive& primitive, const Inheritance& inherited) {
    if (!primitive.material) {
        primitive.material = inherited.material;
        primitive.material_index = inherited.material_index;
    }
    if (!primitive.interior) primitive.interior = inherited.interior;
    if (!primitive.exterior) primitive.exterior = inherited.exterior;
}

}  // namespace

void ObjectLibrary::begin(const Name& name) {
    if (recording_) {
        throw InputError(name.where, std::string("ObjectBegin inside of object ") +
                                         in_quotes(objects_.back().name));
    }
    recording_ = true;
    Object object;
    object.name = name.text;
    object.where = name.where;
    objects_.push_back(std::move(object));
}

void ObjectLibrary::end(const SourceLocation& where) {
    if (!recording_) throw IgnoredStatement(where, "ObjectEnd without ObjectBegin");
    recording_ = false;
    Object& object = objects_.back();
    object.parts = static_cast<double>(object.lights.size()) + (object.primitives.empty() ? 0 : 1);
    object.shines = !object.lights.empty();
    for (const Primitive& primitive : object.primitives) {
        object.shines |= primitive.emission.has_value();
        object.lacks_material |= !primitive.material;
        object.lacks_interior |= !primitive.interior;
        object.lacks_exterior |= !primitive.exterior;
    }
    for (const Child& child : object.children) {
        object.depth = std::max(object.depth, objects_[child.object].depth + 1);
        object.parts += objects_[child.object].parts;
    }
    if (object.depth > kMaxDepth) {
        throw InputError(object.where, "objects nest deeper than " + std::to_string(kMaxDepth));
    }
    const auto [entry, is_new] = by_name_.insert_or_assign(object.name, objects_.size() - 1);
    if (!is_new) {
        diagnostics_.warning(object.where, "object " + in_quotes(object.name) +
                                               " is defined again: instances below use this one");
    }
}

std::size_t ObjectLibrary::find(const Name& name) const {
    if (recording_ && objects_.back().name == name.text) {
        throw IgnoredStatement(name.where, "object " + in_quotes(name.text) + " holds itself");
    }
    const auto found = by_name_.find(name.text);
    if (found != by_name_.end()) return found->second;
    throw IgnoredStatement(
        name.where, unknown_.message("object", name.text, [this] { return names_of(by_name_); }));
}

void ObjectLibrary::place(const Name& name, const MovingTransform& transform,
                          const Inheritance& inherited, SceneContents& contents) {
    const std::size_t object = find(name);
    if (recording_) {
        objects_.back().children.push_back({object, transform, inherited});
        return;
    }
    const auto placed = static_cast<double>(contents.instances.size() + contents.lights.size());
    if (placed + objects_[object].parts > kMaxParts) {
        throw EndOfReading(name.where, "more than ten million instances");
    }
    expand(object, transform, inherited, Instance::kNoOuterObject, contents);
}

std::uint32_t ObjectLibrary::outer_index(Object& placed, SceneContents& contents) {
    if (placed.outer == Instance::kNoOuterObject) {
        placed.outer = static_cast<std::uint32_t>(contents.outer_objects.size());
        contents.outer_objects.push_back(placed.name);
    }
    return placed.outer;
}

MovingTransform ObjectLibrary::placed(const Object& object,
                                      const MovingTransform& transform) const {
    if (transform.motion.empty() || !object.shines) return transform;
    diagnostics_.warning(object.where, "object " + in_quotes(object.name) +
                                           " holds lights and is moved: its lights, and shapes "
                                           "beside them, stay where the motion begins");
    return {transform.matrix, {}};
}

void ObjectLibrary::expand(std::size_t index, const MovingTransform& moving,
                           const Inheritance& inherited, std::uint32_t outer,
                           SceneContents& contents) {
    Object& object = objects_[index];
    if (object.parts == 0) return;
    const MovingTransform transform = placed(object, moving);
    if (!object.primitives.empty()) {
        contents.instances.push_back(
            {variant(index, inherited), transform.matrix, transform.motion, outer});
    }
    for (LightDescription light : object.lights) {
        light.to_world *= transform.matrix;
        if (!light.medium) light.medium = inherited.exterior;
        contents.lights.push_back(std::move(light));
    }
    if (object.children.empty()) return;
    if (outer == Instance::kNoOuterObject) outer = outer_index(object, contents);
    for (const Child& child : object.children) {
        expand(child.object, combined(child.transform, moving),
               combined(child.inherited, inherited), outer, contents);
    }
}

std::size_t ObjectLibrary::variant(std::size_t index, Inheritance inherited) {
    // Inheritance that no shape here needs would only split one definition into several.
    const Object& object = objects_[index];
    if (!object.lacks_material) inherited.material = nullptr;
    if (!object.lacks_interior) inherited.interior = nullptr;
    if (!object.lacks_exterior) inherited.exterior = nullptr;
    const VariantKey key{index, inherited.material.get(), inherited.interior.get(),
                         inherited.exterior.get()};
    const auto [entry, is_new] = variant_index_.try_emplace(key, variants_.size());
    if (is_new) variants_.push_back({index, std::move(inherited)});
    return entry->second;
}

bool ObjectLibrary::lacks_material() const {
    return std::any_of(variants_.begin(), variants_.end(), [&](const Variant& v) {
        return !v.inherited.material && objects_[v.object].lacks_material;
    });
}

void ObjectLibrary::finish(const Inheritance& fallback, SceneContents& contents) {
    std::vector<std::size_t> uses(objects_.size(), 0);
    for (const Variant& v : variants_)
        ++uses[v.object];
    for (const Variant& v : variants_) {
        Object& object = objects_[v.object];
        ObjectDefinition definition;
        definition.name = object.name;
        const bool last_use = --uses[v.object] == 0;
        if (last_use) {
            definition.primitives = std::move(object.primitives);
        } else {
            definition.primitives = object.primitives;
        }
        const Inheritance inherited = combined(v.inherited, fallback);
        for (Primitive& primitive : definition.primitives)
            inherit(primitive, inherited);
        contents.objects.push_back(std::move(definition));
    }
    objects_.clear();
    variants_.clear();
}

}  // namespace lxs
