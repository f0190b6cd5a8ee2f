// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/recordings/recording.hpp"
#include "audio/recordings/vorbis_comments.hpp"

#include <string>
#include <vector>

namespace tp {

/// A place in a story.
struct Chapter {
    double begin_s = 0.0; ///< from the recording's beginning, ≥ 0; kept to a millisecond
    std::string name;     ///< UTF-8; may be empty

    bool operator==(const Chapter&) const = default;
};

/// All that a recording's own comments say of it.
struct RecordingNotes {
    RecordingLabel label;
    std::vector<Chapter> chapters; ///< in the order of time; at most 999

    bool operator==(const RecordingNotes&) const = default;
};

// The fields are KIND, PERSON, SPEAKER, LANGUAGE, DATE, TRANSCRIPT, and for chapters CHAPTER001=00:01:02.500
// with CHAPTER001NAME (Xiph, "Chapter Extension"). An empty text has no field.

/// Reads ours. Where a field is missing, what other programs write stands in for it: ARTIST or PERFORMER for
/// the speaker. What is not UTF-8 is made readable; an unknown kind is a memo.
RecordingNotes notes_in(const VorbisComments& comments);

/// Puts ours in; other programs' fields stay as they are.
void set_notes(VorbisComments& comments, const RecordingNotes& notes);

/// The chapters of the piece from `begin_s` to `end_s`, counted from its beginning. The one that is going on
/// at `begin_s` starts the piece.
std::vector<Chapter> chapters_between(const std::vector<Chapter>& chapters, double begin_s, double end_s);

} // namespace tp
