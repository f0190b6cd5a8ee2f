// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/sonar_cue.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

namespace tp {

/// The newest cue, from one writing thread to one reading thread. Neither locks, waits or allocates.
class CueBoard {
public:
    /// Silence until `write` is called again.
    void clear() { write({}, false); }
    void write(const SonarCue& cue) { write(cue, true); }

    /// What to sound now, none for silence. Where the writer is in the middle of writing: what it was before.
    std::optional<SonarCue> read();

private:
    void write(const SonarCue& cue, bool sounds);

    std::atomic<std::uint64_t> version_{0}; ///< odd while being written
    std::array<std::atomic<double>, 6> values_{};
    std::atomic<bool> sounds_{false};
    std::optional<SonarCue> last_; ///< only the reader
};

static_assert(std::atomic<double>::is_always_lock_free && std::atomic<std::uint64_t>::is_always_lock_free);

} // namespace tp
