// The profile of intensities that an area light's statement names.
#include "front_profile.h"
#include "lxs/lights/lights.h"
#include "lxs/scene/registry.h"
#include "profile_map.h"

namespace lxs {

std::shared_ptr<const FrontProfile> read_area_profile(const ParameterReader& reader,
                                                      const AssetResolver& resolve) try {
    if (!names_profile(reader)) return nullptr;
    auto profile = std::make_shared<const FrontProfile>(sphere_map(reader, resolve));
    if (is_black(profile->flux())) {
        reader.diagnostics().warning(
            reader.where(reader.string("iesname", "").empty() ? "mapname" : "iesname"),
            "the profile is dark in front of the surface, so the light is; \"flipz\" turns it "
            "over");
    }
    return profile;
} catch (const EndOfReading&) {
    throw;
} catch (const InputError& error) {
    reader.diagnostics().fallback(error.where(), error.message(), "the light shines without it");
    return nullptr;
}

}  // namespace lxs
