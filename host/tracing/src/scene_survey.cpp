// Collects facts over all primitives of a scene.
#include "scene_survey.h"

#include <algorithm>

namespace lxs {
namespace {

void add_material(const MaterialFacts& material, SceneSurvey& survey) {
    SceneFacts& facts = survey.facts;
    facts.has_diffuse |= (material.lobes & kDiffuse) != 0;
    facts.has_glossy |= (material.lobes & kGlossy) != 0;
    facts.has_specular |= (material.lobes & kSpecular) != 0;
    facts.has_transmission |= material.transmits || material.straight;
    facts.has_image_textures |= material.reads_image;
    facts.max_bsdf_bytes = std::max(facts.max_bsdf_bytes, material.max_bsdf_bytes);
    survey.has_straight |= material.straight;
}

bool absorbs(const std::shared_ptr<const Medium>& medium) {
    return medium && medium->absorbs();
}

void add_primitive(const Primitive& primitive, SceneSurvey& survey) {
    if (primitive.material) add_material(primitive.material->facts(), survey);
    survey.facts.has_media |= absorbs(primitive.interior) || absorbs(primitive.exterior);
    if (primitive.emission && primitive.emission->radiance)
        survey.facts.has_image_textures |= primitive.emission->radiance->reads_image();
    if (const auto* mesh = std::get_if<TriangleMesh>(&primitive.geometry))
        survey.facts.triangles += mesh->indices.size() / 3;
}

}  // namespace

SceneSurvey survey(const SceneContents& contents) {
    SceneSurvey result;
    for (const Primitive& primitive : contents.primitives)
        add_primitive(primitive, result);
    for (const ObjectDefinition& object : contents.objects) {
        for (const Primitive& primitive : object.primitives)
            add_primitive(primitive, result);
    }
    for (const Instance& instance : contents.instances)
        result.facts.has_motion |= !instance.motion.empty();
    const auto camera = contents.options.find("Camera");
    result.facts.has_motion |= camera != contents.options.end() && !camera->second.motion.empty();
    result.facts.has_media |= absorbs(contents.camera_medium);
    for (const LightDescription& light : contents.lights)
        result.facts.has_media |= absorbs(light.medium);
    return result;
}

}  // namespace lxs
