// What runs in a render, as one value: what the scene needs of what the settings ask for, and what
// the pilot pass made of it. Whoever builds a part of the engine asks here, and nobody
// else decides.
#pragma once

#include <string>

#include "aips/adapter/camera.h"
#include "plan/needs.h"
#include "plan/pilot_pass.h"

namespace aips {

struct Plan {
    Needs needs;
    /// What takes photons through the scene if the guide is the adaptive one; until the pilot pass
    /// Guided, or what another render that was learned from had taken.
    PhotonWay way = PhotonWay::Guided;
    bool media = false;  ///< some medium of the scene scatters

    /// As asked for, without what the scene does not need.
    const Settings& settings() const { return needs.settings; }
    /// What guides photons: the settings' guide, unless the pilot pass left it out.
    GuideKind guide() const;
    /// Whether photon paths come from Markov chains.
    bool chains() const { return settings().photon_sampler == PhotonSampler::AdaptiveChains; }
    /// Whether a guide learns that lessens the weight of the first photon paths.
    bool learns() const { return guide() == GuideKind::Adaptive; }
    /// Whether photons are looked at before the first pass shoots any. In media scores know
    /// surfaces alone, and so would the counts.
    bool has_pilot_pass() const;
    /// Whether the photons per pass follow the noise that passes tell.
    bool measures_noise() const;
    /// Leaves out emitter paths if they are not drawn onto this film, whatever the settings ask
    /// for.
    void fit_to(const Film& film);
    /// Settings of the radius policy.
    Settings radius_settings() const;

    /// Whether these settings let photons go this way.
    bool allows(PhotonWay other) const;
    /// Between passes: saves what was decided since the start, or restores it. Throws StateError
    /// for a decision that these settings do not allow.
    void state(StateArchive& archive);
};

/// Before any ray is traced.
Plan make_plan(const Scene& scene, const Settings& settings);

/// One line for the log: eye paths, photon paths, guide, photons per pass, radii.
std::string describe(const Plan& plan);

}  // namespace aips
