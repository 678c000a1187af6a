// Protects the film's part of a checkpoint: a film that is saved and restored goes on as if nothing
// had happened, and what is of another film is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "lxs/imaging/imaging.h"
#include "memory_archive.h"
#include "scene_options.h"

namespace lxs::test::film_state_test {
namespace {

std::unique_ptr<FileFilm> film(int width = 7, int height = 5) {
    RecordedDiagnostics diagnostics;
    SceneContents contents = scene_of_size(width, height);
    set_option(contents, "PixelFilter", "mitchell", {});
    contents.light_groups = {"one", "two"};
    return make_film(contents, diagnostics);
}

/// Samples, splats and layers of pass `pass`, some of them refused.
void add_pass(FileFilm& film, int pass) {
    film.set_wavelengths(wavelengths_of_pass(3, static_cast<std::uint64_t>(pass)));
    std::vector<Vec2> positions;
    std::vector<Rgb> radiance, layer;
    for (std::uint32_t i = 0; i < film.width() * film.height(); ++i) {
        const float x = static_cast<float>(i % film.width()) + 0.1f * static_cast<float>(pass);
        const std::uint32_t row = i / film.width();
        positions.emplace_back(x, static_cast<float>(row) + 0.3f);
        radiance.emplace_back(0.1f * x);
        radiance.emplace_back(i == 3 ? std::nanf("") : 0.2f);
        layer.emplace_back(static_cast<float>(i + static_cast<std::uint32_t>(pass)));
    }
    film.add_pass({positions, radiance, 2, 1.5, radiance, 1.0 + pass});
    film.add_splats({positions, radiance, 2, 40});
    film.add_layer_pass("photons", {positions, layer, 1, 1.5});
    film.set_layer("error", std::vector<float>(positions.size(), static_cast<float>(pass)));
}

std::string exr_of(const FileFilm& film) {
    const TemporaryFolder folder;
    film.write_exr(folder / "image.exr", {});
    return folder.read("image.exr");
}

TEST(FilmState, ARestoredFilmGoesOnWithTheSameBits) {
    const auto whole = film();
    for (int pass = 0; pass < 5; ++pass)
        add_pass(*whole, pass);

    MemoryArchive archive;
    const auto first = film();
    for (int pass = 0; pass < 3; ++pass)
        add_pass(*first, pass);
    first->state(archive);
    archive.restore();
    const auto second = film();
    add_pass(*second, 9);  // is forgotten
    second->state(archive);
    EXPECT_EQ(archive.remaining(), 0u);
    EXPECT_EQ(second->image(), first->image());
    for (int pass = 3; pass < 5; ++pass)
        add_pass(*second, pass);
    EXPECT_EQ(exr_of(*second), exr_of(*whole));
    EXPECT_EQ(second->refused_samples(), whole->refused_samples());
    EXPECT_GT(second->refused_samples(), 0u);
}

TEST(FilmState, AnEmptyFilmIsRestoredToo) {
    MemoryArchive archive;
    film()->state(archive);
    archive.restore();
    const auto restored = film();
    restored->state(archive);
    EXPECT_EQ(restored->image(), film()->image());
}

TEST(FilmState, AFilmOfAnotherSizeIsRefused) {
    MemoryArchive archive;
    film()->state(archive);
    archive.restore();
    EXPECT_THROW(film(5, 7)->state(archive), StateError) << "as many pixels, but";
    archive.restore();
    EXPECT_THROW(film(8, 5)->state(archive), StateError);
}

TEST(FilmState, SumsThatAreNoNumbersAreRefused) {
    constexpr std::size_t kSums = 8 + 3 * sizeof(std::uint32_t) + 8;  // the size, their number
    constexpr std::size_t kSecondSums = kSums + std::size_t{7} * 5 * 7 * sizeof(double) + 1 + 8;
    for (const std::size_t sums : {kSums, kSecondSums}) {
        for (const double bad :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            MemoryArchive archive;
            const auto saved = film();
            add_pass(*saved, 0);
            saved->state(archive);
            std::memcpy(&archive.content()[sums + 40 * sizeof(double)], &bad, sizeof bad);
            archive.restore();
            EXPECT_THROW(film()->state(archive), StateError);
        }
    }
}

/// Splats and second parts that the restored film has, but the saved one has not.
TEST(FilmState, WhatTheSavedFilmHasNotIsForgotten) {
    MemoryArchive archive;
    film()->state(archive);
    archive.restore();
    const auto restored = film(), fresh = film();
    add_pass(*restored, 1);
    restored->state(archive);
    EXPECT_EQ(restored->image(), fresh->image());
    for (const auto& one : {restored.get(), fresh.get()})
        add_pass(*one, 2);
    EXPECT_EQ(restored->image(), fresh->image());
}

TEST(FilmState, EveryMissingEndIsRefused) {
    MemoryArchive whole;
    const auto saved = film(2, 2);
    add_pass(*saved, 0);
    saved->state(whole);
    for (std::size_t size = 0; size < whole.content().size(); ++size) {
        MemoryArchive cut;
        cut.content().assign(whole.content().begin(),
                             whole.content().begin() + static_cast<std::ptrdiff_t>(size));
        cut.restore();
        EXPECT_THROW(film(2, 2)->state(cut), StateError) << size << " bytes";
    }
}

}  // namespace
}  // namespace lxs::test::film_state_test
