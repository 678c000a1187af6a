// Protects reading EXR files of others: what is written comes back, and damage is a message.
#include "lxs/imaging/exr_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "rendered_image.h"

namespace lxs::exr_image_test {
namespace {

using testing::HasSubstr;

std::string refusal_of(std::span<const std::byte> bytes) {
    try {
        (void)decode_exr(bytes, "x.exr");
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(ExrImage, ComesBackAsItWas) {
    ExrImage image = test::rendered(3, 10, 0.7f, 0.1f);
    image.channels["R"][4] = 1e30f;
    const ExrImage back = decode_exr(encode_exr(image), "x.exr");
    EXPECT_EQ(back.channels, image.channels);
    EXPECT_EQ(back.metadata, image.metadata);
    EXPECT_EQ(back.frame.x, 1u);
    EXPECT_EQ(back.frame.y_resolution, 4u);
    EXPECT_EQ(back.frame.width, 3u);
}

TEST(ExrImage, RefusesWhatIsNoImage) {
    EXPECT_THAT(refusal_of({}), HasSubstr("cannot read 'x.exr': it is no OpenEXR file"));
    EXPECT_THROW((void)read_exr("/nowhere/x.exr"), std::runtime_error);
    EXPECT_THROW((void)read_exr("/"), std::runtime_error);
}

/// Every prefix, and every byte changed: read or refused with a message, never more than that.
TEST(ExrImage, SurvivesDamage) {
    const std::vector<std::byte> whole = encode_exr(test::rendered(3, 10, 0.7f, 0.1f));
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THAT(refusal_of(std::span(whole).first(size)), HasSubstr("'x.exr'")) << size;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::vector<std::byte> damaged = whole;
        damaged[at] ^= std::byte{0x55};
        (void)refusal_of(damaged);
    }
}

}  // namespace
}  // namespace lxs::exr_image_test
