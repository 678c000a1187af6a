// Declared parameters of cameras, films, filters and samplers, for docs.
#include "camera_settings.h"
#include "film_parameters.h"
#include "lxs/imaging/imaging.h"
#include "pixel_filter.h"
#include "sampler_parameters.h"

namespace lxs {

std::vector<ParameterDeclaration> option_parameters(const std::string& statement,
                                                    const std::string& plugin) {
    if (statement == "Camera") return camera_parameters(plugin);
    if (statement == "Film") return film_parameters(plugin);
    if (statement == "PixelFilter") return filter_parameters(plugin);
    if (statement == "Sampler") return all_sampler_parameters(plugin);
    return {};
}

}  // namespace lxs
