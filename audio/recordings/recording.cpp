// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/recording.hpp"

#include <array>
#include <cstddef>

namespace tp {

namespace {

constexpr std::array<std::string_view, 5> names{"memo", "person", "place", "story", "ambient"};

} // namespace

std::string_view name_of(RecordingKind kind) { return names[static_cast<std::size_t>(kind)]; }

std::optional<RecordingKind> recording_kind(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name)
            return static_cast<RecordingKind>(i);
    return std::nullopt;
}

} // namespace tp
