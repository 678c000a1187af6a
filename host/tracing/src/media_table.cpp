// Numbers the media of a scene.
#include "media_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace lxs {

MediaTable::MediaTable(const SceneContents& contents) {
    const auto add_of = [&](const std::vector<Primitive>& primitives) {
        for (const Primitive& primitive : primitives) {
            add(primitive.interior, contents);
            add(primitive.exterior, contents);
        }
    };
    add_of(contents.primitives);
    for (const ObjectDefinition& object : contents.objects)
        add_of(object.primitives);
    for (const LightDescription& light : contents.lights)
        add(light.medium, contents);
    add(contents.camera_medium, contents);
}

void MediaTable::add(const std::shared_ptr<const Medium>& medium, const SceneContents& contents) {
    if (!medium || numbers_.contains(medium.get())) return;
    if (media_.size() > EnteredMedia::kLargestNumber) {
        throw InputError(contents.end, fmt::format("more than {} volumes are in use",
                                                   EnteredMedia::kLargestNumber));
    }
    numbers_.emplace(medium.get(), static_cast<MediumNumber>(media_.size()));
    media_.push_back(medium.get());
    const auto named = std::find_if(contents.media.begin(), contents.media.end(),
                                    [&](const auto& m) { return m.medium == medium; });
    names_.push_back(named == contents.media.end() ? std::string() : named->name);
}

}  // namespace lxs
