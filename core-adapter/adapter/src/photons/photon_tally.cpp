// Counts of photons by light and by material.
#include "photons/photon_tally.h"

#include "base/growing_tally.h"
#include "base/luminance_by_light.h"

namespace aips {
namespace {

std::uint64_t& of_fate(MaterialTally& tally, PhotonFate fate) {
    switch (fate) {
        case PhotonFate::Stored:
            return tally.stored;
        case PhotonFate::Unseen:
            return tally.unseen;
        case PhotonFate::Direct:
            return tally.direct;
        case PhotonFate::Smooth:
            return tally.smooth;
        case PhotonFate::Black:
            break;
    }
    return tally.black;
}

}  // namespace

MaterialTally& MaterialTally::operator+=(const MaterialTally& o) {
    hits += o.hits;
    stored += o.stored;
    unseen += o.unseen;
    direct += o.direct;
    smooth += o.smooth;
    black += o.black;
    cut += o.cut;
    cut_smooth += o.cut_smooth;
    return *this;
}

void PhotonTally::path(LightIndex light, bool counted) {
    Paths& paths = tally_at(lights_, told_light(light));
    ++paths.all;
    paths.counted += counted;
}

void PhotonTally::hit(std::uint32_t material, PhotonFate fate, bool cut) {
    MaterialTally& tally = tally_at(materials_, material);
    ++of_fate(tally, fate);
    if (!cut) return;
    ++tally.cut;
    tally.cut_smooth += fate == PhotonFate::Smooth;
}

PhotonTally& PhotonTally::operator+=(const PhotonTally& other) {
    add_tallies(lights_, other.lights_);
    add_tallies(materials_, other.materials_);
    return *this;
}

void PhotonTally::state(StateArchive& archive) {
    lights_.resize(archive.count(lights_.size(), sizeof(Paths)));
    StateArchive::check(lights_.size() <= kMostToldLights, "more lights than are told apart");
    for (Paths& paths : lights_) {
        archive.value(paths.all);
        archive.value(paths.counted);
    }
    materials_.resize(archive.count(materials_.size(), 7 * sizeof(std::uint64_t)));
    for (MaterialTally& m : materials_) {
        for (std::uint64_t* count :
             {&m.stored, &m.unseen, &m.direct, &m.smooth, &m.black, &m.cut, &m.cut_smooth})
            archive.value(*count);
    }
}

void PhotonTally::add_to(RenderAccount& account) const {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        LightTally& light = tally_at(account.lights, i);
        light.paths += lights_[i].all;
        light.counted += lights_[i].counted;
    }
    add_tallies(account.materials, materials_);
    for (MaterialTally& m : account.materials)
        m.hits = m.stored + m.unseen + m.direct + m.smooth + m.black;
}

}  // namespace aips
