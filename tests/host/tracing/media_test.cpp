// Protects the rule of which media a ray is in: what it entered and left, where it begins, and what
// is said of declarations that do not fit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fakes.h"

namespace lxs::test::media_test {
namespace {

using MediumPointer = std::shared_ptr<const Medium>;

MediumPointer absorbing(float amount, float index = 1) {
    return std::make_shared<Medium>(Rgb(amount), index);
}

/// Passes light straight and says that it is glass.
class Glass final : public Material {
  public:
    explicit Glass(bool own_index) : own_index_(own_index) {}
    const Bsdf* scatter(const ShadingPoint&, std::pmr::memory_resource&) const override {
        return nullptr;
    }
    MaterialFacts facts() const override {
        MaterialFacts facts;
        facts.lobes = kSpecular;
        facts.transmits = true;
        facts.own_index = own_index_;
        facts.index_of_media = !own_index_;
        return facts;
    }

  private:
    bool own_index_;
};

Primitive body(Geometry geometry, MediumPointer interior, MediumPointer exterior = nullptr,
               std::uint32_t line = 1) {
    Primitive made = primitive(std::move(geometry), straight(Rgb(1.0f)));
    made.interior = std::move(interior);
    made.exterior = std::move(exterior);
    made.where.line = line;
    return made;
}

/// A wide sheet that faces upwards.
TriangleMesh sheet(float z, float size = 10) {
    return parallelogram(Vec3(-size, -size, z), Vec3(2 * size, 0, 0), Vec3(0, 2 * size, 0));
}

/// A small lamp at `at` that shines downwards.
Primitive lamp(const Vec3& at) {
    Primitive made = primitive(parallelogram(at, Vec3(0, 0.1f, 0), Vec3(0.1f, 0, 0)));
    made.emission = emission(Rgb(1.0f));
    return made;
}

class Recorded final : public Diagnostics {
  public:
    void warning(const SourceLocation& where, const std::string& message) override {
        texts.push_back(std::to_string(where.line) + ": " + message);
    }
    void unknown_parameter(const SourceLocation&, const std::string&) override {}

    std::vector<std::string> texts;
};

/// A scene whose media have names, and a camera.
struct NamedScene {
    SceneContents contents;

    MediumPointer medium(const std::string& name, float amount, float index = 1) {
        const auto made = std::make_shared<Medium>(Rgb(amount), index);
        contents.media.emplace_back(made);
        contents.media.back().name = name;
        return made;
    }
    void camera_at(const Vec3& place) {
        contents.options["Camera"].transform = translation(-place.x, -place.y, -place.z);
    }
    std::unique_ptr<TraceScene> traced() {
        SceneContents copy = contents;
        copy.light_groups = {"default"};
        return make_trace_scene(std::move(copy), {}, recorded);
    }
    /// The warnings, all in one.
    std::string warnings() {
        recorded.texts.clear();
        traced();
        return joined(recorded.texts);
    }
    std::string notes() { return joined(traced()->media_notes()); }
    static std::string joined(const std::vector<std::string>& texts) {
        std::string all;
        for (const std::string& text : texts)
            all += text + "\n";
        return all;
    }

    Recorded recorded;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(EnteredMedia, ForgetsWhatWasEnteredFirst) {
    EnteredMedia media;
    EXPECT_EQ(media.innermost(), kNoMedium);
    for (MediumNumber n = 1; n <= EnteredMedia::kMost + 1; ++n)
        media = media.entered(n);
    EXPECT_EQ(media.innermost(), EnteredMedia::kMost + 1);
    EXPECT_FALSE(media.contains(1));
    for (MediumNumber n = EnteredMedia::kMost + 1; n >= 2; --n)
        media = media.left(n);
    EXPECT_EQ(media, EnteredMedia());
}

TEST(EnteredMedia, LeavesTheLastOfTheSameAndThoseFurtherOut) {
    const EnteredMedia media = EnteredMedia().entered(4095).entered(7).entered(7).entered(3);
    EXPECT_EQ(media.left(7), EnteredMedia().entered(4095).entered(7).entered(3));
    EXPECT_EQ(media.left(4095), EnteredMedia().entered(7).entered(7).entered(3));
    EXPECT_EQ(media.left(5), media);
}

TEST(EnteredMedia, SurfacesThatDeclareNothingSeparateNothing) {
    const EnteredMedia media = EnteredMedia().entered(1).entered(2);
    EXPECT_EQ(media.beyond(kNoMedium, kNoMedium), media);
    EXPECT_EQ(media.beyond(2, 2), media);
    EXPECT_EQ(media.beyond(kNoMedium, 3), media.entered(3));
    EXPECT_EQ(media.beyond(2, kNoMedium), EnteredMedia().entered(1));
    EXPECT_EQ(media.beyond(2, 3), EnteredMedia().entered(1).entered(3));
}

/// Glass in water in haze, none of which names what is around it: a ray comes back to each.
TEST(Media, BodiesWithoutExteriorAreInWhatTheRayCameFrom) {
    const MediumPointer haze = absorbing(0.01f), water = absorbing(0.2f), glass = absorbing(0.5f);
    const auto scene =
        trace_within({body(sphere(3, Matrix()), water), body(sphere(1, Matrix()), glass)}, haze);
    Ray ahead = ray(Vec3(0, 0, -5), Vec3(0, 0, 1));
    ahead.media = scene->camera_media();
    const MediumPointer crossed[] = {haze, water, glass, water, haze};
    for (const MediumPointer& medium : crossed) {
        SurfaceHit met;
        const bool more = hit(*scene, ahead, met);
        EXPECT_EQ(scene->medium(met.crossed), medium.get());
        if (!more) break;
        ahead = ray(met.p + Vec3(0, 0, 1e-3f), ahead.direction);
        ahead.media = met.ng.z > 0 ? met.exterior : met.interior;
    }
    // And so do shadow rays.
    Ray segment = ray(Vec3(0, 0, -5), Vec3(0, 0, 1));
    segment.media = scene->camera_media();
    segment.t_max = 10;
    const float expected = std::exp(-(4 * 0.01f + 4 * 0.2f + 2 * 0.5f));
    EXPECT_NEAR(scene->transmittance(segment).x, expected, 1e-5f);
}

/// One shape, half in water and half out of it, which declares no medium.
TEST(Media, OpaqueShapesStandInWhatRaysComeIn) {
    const MediumPointer water = absorbing(0.2f);
    const auto scene = trace({body(sheet(0), water), primitive(sphere(1, Matrix()))});
    SurfaceHit met;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 0, 5), Vec3(0, 0, -1)), met));
    EXPECT_EQ(met.exterior, EnteredMedia());
    Ray below = ray(Vec3(0, 5, -0.5f), Vec3(0, -1, 0));
    below.media = EnteredMedia().beyond(kNoMedium, 1);
    ASSERT_TRUE(hit(*scene, below, met));
    EXPECT_EQ(scene->medium(met.exterior), water.get());
}

/// Open water: a ray that comes to its ground, or to its surface from below, without having entered
/// it. Each segment is in what is declared at an end of it, whichever way it is looked along.
TEST(Media, OpenSurfacesTellWhatIsInFrontOfThem) {
    const MediumPointer water = absorbing(0.2f);
    Primitive ground = primitive(sheet(-2));
    ground.exterior = water;
    Primitive wall = primitive(parallelogram(Vec3(20, -10, -5), Vec3(0, 0, 10), Vec3(0, 20, 0)));
    const auto scene = trace({body(sheet(0), water), ground, wall});
    SurfaceHit at_ground, at_wall;
    const Vec3 down = Vec3(-1, 0, -0.1f).normalized();
    ASSERT_TRUE(hit(*scene, ray(Vec3(15, 0, -1), down), at_ground));
    EXPECT_EQ(scene->medium(at_ground.crossed), water.get());
    EXPECT_NEAR(at_ground.transmittance.x, std::exp(-0.2f * at_ground.distance), 1e-6f);
    Ray back = ray(at_ground.p + Vec3(0, 0, 1e-3f), -down);
    back.media = at_ground.exterior;
    ASSERT_TRUE(hit(*scene, back, at_wall));
    EXPECT_EQ(scene->medium(at_wall.crossed), water.get());
    EXPECT_EQ(at_wall.exterior, EnteredMedia()) << "of the segment alone";
    SurfaceHit from_below;
    ASSERT_TRUE(hit(*scene, ray(Vec3(0, 0, -1), Vec3(0, 0, 1)), from_below));
    EXPECT_EQ(scene->medium(from_below.crossed), water.get());
    EXPECT_EQ(from_below.exterior, EnteredMedia());
}

TEST(Media, CameraAndLampsStandInTheBodiesAroundThem) {
    NamedScene scene;
    const MediumPointer haze = scene.medium("haze", 0.01f), fog = scene.medium("fog", 0.2f),
                        water = scene.medium("water", 0.3f);
    scene.contents.camera_medium = haze;
    scene.contents.primitives = {body(sphere(3, Matrix()), fog),
                                 body(sphere(3, translation(20, 0, 0)), fog, haze),
                                 body(sphere(1, translation(20, 0, 0)), water),
                                 lamp(Vec3(0, 0, 2)),
                                 lamp(Vec3(20, 0, 0)),
                                 lamp(Vec3(40, 0, 0))};
    scene.camera_at(Vec3(0, 1, 0));
    const auto traced = scene.traced();
    EXPECT_EQ(traced->medium(traced->camera_media()), fog.get());
    const EnteredMedia outside = traced->camera_media().left(traced->camera_media().innermost());
    EXPECT_EQ(traced->medium(outside), haze.get());
    const MediumPointer expected[] = {fog, water, haze};
    for (std::size_t i = 0; i < 3; ++i) {
        EmissionSample sample;
        ASSERT_TRUE(traced->lights()[i]->sample_emission({0.5, 0.5, 0.5, 0.5}, sample));
        EXPECT_EQ(traced->medium(sample.ray.media), expected[i].get()) << i;
    }
}

TEST(Media, LampsBelowOpenWaterAreInIt) {
    NamedScene scene;
    const MediumPointer water = scene.medium("water", 0.2f);
    scene.contents.primitives = {body(sheet(0, 2), water), primitive(sheet(-2, 2)),
                                 lamp(Vec3(0, 0, -1)), lamp(Vec3(0, 0, 4))};
    scene.camera_at(Vec3(0, -4, 3));
    const auto traced = scene.traced();
    EXPECT_EQ(traced->camera_media(), EnteredMedia());
    EmissionSample below, above;
    ASSERT_TRUE(traced->lights()[0]->sample_emission({0.5, 0.5, 0.5, 0.5}, below));
    ASSERT_TRUE(traced->lights()[1]->sample_emission({0.5, 0.5, 0.5, 0.5}, above));
    EXPECT_EQ(traced->medium(below.ray.media), water.get());
    EXPECT_EQ(above.ray.media, EnteredMedia());
}

TEST(Media, MoreThanThereAreNumbersAreRefused) {
    NamedScene scene;
    for (int i = 0; i <= EnteredMedia::kLargestNumber; ++i)
        scene.contents.primitives.push_back(body(sphere(1, Matrix()), absorbing(1)));
    EXPECT_THROW(scene.traced(), InputError);
}

/// A vessel of glass with water in it, in fog, all declared as it should be.
TEST(MediaReview, SaysNothingOfSoundScenes) {
    NamedScene scene;
    const MediumPointer fog = scene.medium("fog", 0.1f), glass = scene.medium("glass", 0, 1.5f),
                        water = scene.medium("water", 0.2f, 1.33f);
    scene.contents.primitives = {body(sphere(9, Matrix()), fog), primitive(sheet(-2, 30)),
                                 body(sphere(1.5f, Matrix()), glass, fog),
                                 body(sphere(1, Matrix()), water, glass), lamp(Vec3(0, 0, 4))};
    scene.camera_at(Vec3(0, -5, 0));
    EXPECT_EQ(scene.warnings(), "");
}

TEST(MediaReview, NamesADeclarationThatIsNotWhatTheRayIsIn) {
    NamedScene scene;
    const MediumPointer air = scene.medium("air", 0), fog = scene.medium("fog", 0.1f),
                        glass = scene.medium("glass", 0, 1.5f);
    scene.contents.primitives = {body(sphere(9, Matrix()), fog, nullptr, 3),
                                 body(sphere(1, Matrix()), glass, air, 7), lamp(Vec3(0, 0, 4))};
    scene.camera_at(Vec3(0, -5, 0));
    const std::string text = scene.warnings();
    EXPECT_TRUE(contains(text, "7: Exterior \"air\" is not what rays are in")) << text;
    EXPECT_TRUE(contains(text, "they come in \"fog\"")) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(MediaReview, NamesSwappedSides) {
    NamedScene scene;
    const MediumPointer air = scene.medium("air", 0), glass = scene.medium("glass", 0, 1.5f);
    scene.contents.primitives = {body(sphere(1, Matrix()), air, glass, 7), primitive(sheet(-2, 30)),
                                 lamp(Vec3(0, 0, 4))};
    scene.camera_at(Vec3(0, -5, 1));
    const std::string text = scene.warnings();
    EXPECT_TRUE(contains(text, "7: Exterior \"glass\"")) << text;
    EXPECT_TRUE(contains(text, "look swapped")) << text;
}

TEST(MediaReview, NamesTheInnerWallsOfAVessel) {
    NamedScene scene;
    const MediumPointer air = scene.medium("air", 0), glass = scene.medium("glass", 0, 1.5f),
                        water = scene.medium("water", 0.2f, 1.33f);
    scene.contents.primitives = {body(sphere(1.5f, Matrix()), glass, air, 3),
                                 body(sphere(1, Matrix()), water, air, 7), lamp(Vec3(0, 0, 4))};
    scene.camera_at(Vec3(0, -5, 0));
    const std::string text = scene.warnings();
    EXPECT_TRUE(contains(text, "7: Exterior \"air\"")) << text;
    EXPECT_TRUE(contains(text, "inner walls of a vessel")) << text;
}

TEST(MediaReview, NamesALampAndACameraOfOtherMedia) {
    NamedScene scene;
    const MediumPointer air = scene.medium("air", 0), fog = scene.medium("fog", 0.1f);
    Primitive bright = lamp(Vec3(0, 0, 2));
    bright.exterior = air;
    bright.emission->where.line = 9;
    scene.contents.primitives = {body(sphere(9, Matrix()), fog, nullptr, 3), bright};
    scene.contents.camera_medium = air;
    scene.contents.end.line = 20;
    scene.camera_at(Vec3(0, -5, 0));
    const std::string text = scene.warnings();
    EXPECT_TRUE(contains(text, "9: Exterior \"air\"")) << text;
    EXPECT_TRUE(contains(text, "the light stands in \"fog\"")) << text;
    EXPECT_TRUE(contains(text, "20: Exterior \"air\"")) << text;
    EXPECT_TRUE(contains(text, "the camera stands in \"fog\"")) << text;
}

TEST(MediaReview, NotesGlassThatIsNotAsItsAuthorThinks) {
    NamedScene scene;
    const MediumPointer water = scene.medium("water", 0.2f, 1.33f);
    Primitive plain = body(sphere(0.5f, Matrix()), nullptr, nullptr, 5);
    plain.material = std::make_shared<Glass>(true);
    Primitive around = body(sphere(1, Matrix()), nullptr, nullptr, 4);
    around.material = plain.material;
    Primitive without = body(sphere(0.5f, translation(3, 0, 0)), nullptr, nullptr, 6);
    without.material = std::make_shared<Glass>(false);
    Primitive sunk = body(sphere(0.5f, translation(-3, 0, 0)), nullptr, nullptr, 8);
    sunk.material = plain.material;
    scene.contents.primitives = {plain,
                                 around,
                                 without,
                                 sunk,
                                 lamp(Vec3(0, 0, 4)),
                                 body(sphere(1, translation(-3, 0, 0)), water, nullptr, 9)};
    scene.camera_at(Vec3(0, -5, 0));
    EXPECT_EQ(scene.warnings(), "");
    const std::string text = scene.notes();
    EXPECT_TRUE(contains(text, "rays come to it within other glass")) << text;
    EXPECT_TRUE(contains(text, "rays come to it within \"water\"")) << text;
    EXPECT_TRUE(contains(text, "\"glass2\" without Interior and Exterior")) << text;
}

}  // namespace
}  // namespace lxs::test::media_test
