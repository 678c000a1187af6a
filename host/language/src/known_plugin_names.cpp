// The plugin names of LuxRender 1.9, and older renderers, by statement; textures by their type as
// well.
#include "lxs/language/read_scene.h"

namespace lxs {

const std::map<std::string, std::vector<std::string>>& known_plugin_names() {
    static const std::map<std::string, std::vector<std::string>> names = {
        {"Accelerator",
         {"bruteforce", "bvh", "kdtree", "mbvh", "none", "qbvh", "sqbvh", "tabreckdtree"}},
        {"AreaLightSource", {"area"}},
        {"Camera", {"environment", "orthographic", "perspective"}},
        {"Film", {"fleximage", "multiimage"}},
        {"LightSource",
         {"distant", "goniometric", "infinite", "infinitesample", "point", "projection", "sky",
          "sky2", "spot", "sun", "sunsky", "sunsky2"}},
        {"MakeNamedVolume", {"clear", "heterogeneous", "homogeneous"}},
        {"Material", {"carpaint",     "cloth",         "doubleside",
                      "glass",        "glass2",        "glossy",
                      "glossy_lossy", "glossycoating", "glossytranslucent",
                      "layered",      "matte",         "mattetranslucent",
                      "metal",        "metal2",        "mirror",
                      "mix",          "null",          "plastic",
                      "roughglass",   "scatter",       "shinymetal",
                      "substrate",    "velvet"}},
        {"PixelFilter",
         {"blackmanharris", "box", "catmullrom", "gaussian", "mitchell", "sinc", "triangle"}},
        {"PixelSampler", {"grid", "hilbert", "linear", "lowdiscrepancy", "tile", "vegas"}},
        {"Renderer",
         {"hybrid", "hybridsampler", "hybridsppm", "luxcore", "sampler", "slg", "sppm"}},
        {"Sampler", {"erpt", "lowdiscrepancy", "metropolis", "random"}},
        {"Shape",
         {"barytrianglemesh", "cone", "cylinder", "deferred", "disk", "hairfile", "heightfield",
          "hyperboloid", "loopsubdiv", "mesh", "nurbs", "paraboloid", "plymesh", "sphere",
          "stlmesh", "torus", "trianglemesh", "waldtrianglemesh"}},
        {"SurfaceIntegrator", {"bidirectional", "directlighting", "exphotonmap", "path", "sppm"}},
        {"Texture color",
         {"add",        "band",          "bilerp",      "blackbody",     "brick",
          "colordepth", "constant",      "equalenergy", "frequency",     "gaussian",
          "harlequin",  "hitpointcolor", "imagemap",    "irregulardata", "lampspectrum",
          "marble",     "mix",           "multimix",    "regulardata",   "scale",
          "subtract",   "tabulateddata", "uv"}},
        {"Texture float", {"add",           "band",           "bilerp",
                           "blender_blend", "blender_clouds", "blender_distortednoise",
                           "blender_magic", "blender_marble", "blender_musgrave",
                           "blender_noise", "blender_stucci", "blender_voronoi",
                           "blender_wood",  "brick",          "checkerboard",
                           "cloud",         "constant",       "densitygrid",
                           "dots",          "exponential",    "fbm",
                           "hitpointalpha", "hitpointgrey",   "imagemap",
                           "mix",           "multimix",       "normalmap",
                           "scale",         "subtract",       "uvmask",
                           "windy",         "wrinkled"}},
        {"Texture fresnel",
         {"abbe", "band", "bilerp", "cauchy", "constant", "fresnelcolor", "fresnelname", "luxpop",
          "mix", "multimix", "preset", "sellmeier", "sopra"}},
        {"ToneMap",
         {"autolinear", "contrast", "falsecolors", "linear", "maxwhite", "nonlinear", "reinhard"}},
        {"Volume", {"cloud", "exponential", "heterogeneous", "homogeneous", "volumegrid"}},
        {"VolumeIntegrator", {"emission", "multi", "none", "single"}},
    };
    return names;
}

}  // namespace lxs
