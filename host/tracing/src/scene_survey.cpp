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
    facts.disperses |= material.disperses;
    facts.max_bsdf_bytes = std::max(facts.max_bsdf_bytes, material.max_bsdf_bytes);
    for (const CurvePointer& spectrum : material.spectra)
        add_once(spectrum, survey.spectra.surfaces);
    survey.has_straight |= material.straight;
}

void add_medium(const std::shared_ptr<const Medium>& medium, SceneSurvey& survey) {
    if (!medium) return;
    survey.media.insert(medium.get());
    survey.facts.has_media |= medium->absorbs() || medium->emits();
    survey.spectra.has_plain_lamps |= medium->emits();
    survey.facts.has_scattering_media |= medium->scatters();
}

void add_emission(const AreaEmission& emission, SceneSurvey& survey) {
    const CurvePointer spectrum = emission.radiance ? emission.radiance->spectrum() : nullptr;
    add_once(spectrum, survey.spectra.lamps);
    survey.spectra.has_plain_lamps |= !spectrum;
    survey.facts.has_image_textures |= emission.radiance && emission.radiance->reads_image();
}

void add_primitive(const Primitive& primitive, SceneSurvey& survey) {
    if (primitive.material) add_material(primitive.material->facts(), survey);
    add_medium(primitive.interior, survey);
    add_medium(primitive.exterior, survey);
    if (primitive.emission) add_emission(*primitive.emission, survey);
    if (const auto* mesh = std::get_if<TriangleMesh>(&primitive.geometry))
        survey.facts.triangles += mesh->indices.size() / 3;
    else
        ++survey.facts.quadrics;
}

/// Whether the light that media scatter is to be rendered: LuxRender's "emission" (its default) and
/// "none" only dim light that crosses them.
bool renders_scattering(const SceneContents& contents, Diagnostics& diagnostics) {
    const auto option = contents.options.find("VolumeIntegrator");
    const bool named = option != contents.options.end();
    const std::string kind = named ? option->second.parameters.plugin : "emission";
    const SourceLocation where = named ? option->second.parameters.where : contents.end;
    if (kind == "single") {
        diagnostics.warning(where,
                            "VolumeIntegrator \"single\": light that media scatter more than "
                            "once is rendered too, as by \"multi\"");
    } else if (kind != "multi") {
        diagnostics.warning(where, "VolumeIntegrator \"" + kind +
                                       "\" loses the light that media scatter; \"multi\" "
                                       "renders it");
        return false;
    }
    return true;
}

}  // namespace

SceneSurvey survey(const SceneContents& contents, Diagnostics& diagnostics) {
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
    add_medium(contents.camera_medium, result);
    for (const LightDescription& light : contents.lights)
        add_medium(light.medium, result);
    for (const SceneMedium& named : contents.media) {
        if (!result.media.contains(named.medium.get())) continue;
        add_once(named.spectra.absorption, result.spectra.media);
        add_once(named.spectra.scattering, result.spectra.media);
    }
    result.spectra.has_plain_lamps |= !contents.lights.empty();
    if (result.facts.has_scattering_media) {
        result.facts.has_scattering_media = renders_scattering(contents, diagnostics);
    }
    return result;
}

}  // namespace lxs
