// Whether what surfaces declare of media fits what rays are in that come to them.
#pragma once

#include <string>
#include <vector>

#include "media_around.h"
#include "media_table.h"

namespace lxs {

/// Something about the media of a scene that its author may not know.
struct MediaNote {
    SourceLocation where;
    std::string text;
    bool contradiction = false;  ///< a declaration that does not fit
};

/// Where rays begin, and in what.
struct MediaStart {
    Vec3 place{0.0f};
    EnteredMedia media = {};
};

/// Whether light is the same in both; null is vacuum.
bool same_optics(const Medium* a, const Medium* b);

/// `name` in quotes, "no medium" for none.
std::string quoted_medium(const MediaTable& media, MediumNumber medium);

/// Follows rays through glass and off what is opaque: some from each start all around, and one to
/// each target, from the starts in turn. Each note stands for one kind of fault and tells how many
/// surfaces have it. The same for the same scene.
std::vector<MediaNote> review_media(const MeetSurface& meet, const MediaTable& media,
                                    const std::vector<MediaStart>& starts,
                                    const std::vector<Vec3>& targets);

}  // namespace lxs
