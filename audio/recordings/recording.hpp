// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tp {

/// What a recording is about; in the order in which they are played unless a person re-ordered them.
enum class RecordingKind {
    memo,    ///< about the photograph
    person,  ///< who a face is
    place,   ///< where it was
    story,   ///< long, with chapters
    ambient, ///< what was to be heard around the shutter
};

/// "memo", "person", …: as in file names, Vorbis comments, sidecars and JSON.
std::string_view name_of(RecordingKind kind);
std::optional<RecordingKind> recording_kind(std::string_view name);

/// What a recording says of itself, in its own comments and in the photograph's sidecar. All texts are UTF-8.
struct RecordingLabel {
    RecordingKind kind = RecordingKind::memo;
    std::string person;     ///< whom it is about; empty: nobody in particular
    std::string speaker;    ///< who speaks; several are separated by "; "
    std::string language;   ///< BCP 47, such as "de-AT"; empty: unknown
    std::string recorded;   ///< ISO 8601 local time with offset, "2026-05-01T10:15:00+02:00"; empty: unknown
    std::string transcript; ///< typed by a caregiver; may have lines

    bool operator==(const RecordingLabel&) const = default;
};

} // namespace tp
