// Counts of photons by light and by material.
#include "photons/photon_statistics.h"

#include "base/growing_sums.h"
#include "base/luminance_by_light.h"

namespace aips {
namespace {

std::uint64_t& of_fate(MaterialStatistics& statistics, PhotonFate fate) {
    switch (fate) {
        case PhotonFate::Stored:
            return statistics.stored;
        case PhotonFate::Unseen:
            return statistics.unseen;
        case PhotonFate::Direct:
            return statistics.direct;
        case PhotonFate::Specular:
            return statistics.specular;
        case PhotonFate::Black:
            break;
    }
    return statistics.black;
}

}  // namespace

MaterialStatistics& MaterialStatistics::operator+=(const MaterialStatistics& o) {
    hits += o.hits;
    stored += o.stored;
    unseen += o.unseen;
    direct += o.direct;
    specular += o.specular;
    black += o.black;
    cut += o.cut;
    cut_specular += o.cut_specular;
    return *this;
}

void PhotonStatistics::path(LightIndex light, bool counted) {
    Paths& paths = sum_at(lights_, told_light(light));
    ++paths.all;
    paths.counted += counted;
}

void PhotonStatistics::hit(std::uint32_t material, PhotonFate fate, bool cut) {
    MaterialStatistics& statistics = sum_at(materials_, material);
    ++of_fate(statistics, fate);
    if (!cut) return;
    ++statistics.cut;
    statistics.cut_specular += fate == PhotonFate::Specular;
}

PhotonStatistics& PhotonStatistics::operator+=(const PhotonStatistics& other) {
    add_sums(lights_, other.lights_);
    add_sums(materials_, other.materials_);
    return *this;
}

void PhotonStatistics::state(StateArchive& archive) {
    lights_.resize(archive.count(lights_.size(), sizeof(Paths)));
    StateArchive::check(lights_.size() <= kMostToldLights, "more lights than are told apart");
    for (Paths& paths : lights_) {
        archive.value(paths.all);
        archive.value(paths.counted);
    }
    materials_.resize(archive.count(materials_.size(), 7 * sizeof(std::uint64_t)));
    for (MaterialStatistics& m : materials_) {
        for (std::uint64_t* count :
             {&m.stored, &m.unseen, &m.direct, &m.specular, &m.black, &m.cut, &m.cut_specular})
            archive.value(*count);
    }
}

void PhotonStatistics::add_to(TransportStatistics& transport) const {
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        LightStatistics& light = sum_at(transport.lights, i);
        light.paths += lights_[i].all;
        light.counted += lights_[i].counted;
    }
    add_sums(transport.materials, materials_);
    for (MaterialStatistics& m : transport.materials)
        m.hits = m.stored + m.unseen + m.direct + m.specular + m.black;
}

}  // namespace aips
