// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/sound/earcons.hpp"
#include "audio/sound/sound_source.hpp"

#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace tp {

/// Earcons as they come, mixed. Goes on in silence for a while after the last one, because a loudspeaker that
/// is started anew is late; then it ends.
class EarconStream final : public SoundSource {
public:
    /// False where the stream has ended: the earcon needs another one. Any thread. Four sound at once; a
    /// fifth is dropped, unless it is a fault.
    bool add(Earcon earcon);

    std::size_t pull(std::span<float> samples) override;
    void heard(std::int64_t) override {}
    bool answers_a_finger() const override { return true; }

private:
    std::mutex mutex_;                             ///< held for the mixing of one block at most
    std::vector<std::span<const float>> sounding_; ///< what is left of each
    std::size_t silent_frames_ = 0;                ///< since the last one
    bool ended_ = false;
};

} // namespace tp
