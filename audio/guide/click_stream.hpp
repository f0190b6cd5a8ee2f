// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/click_list.hpp"
#include "audio/sound/sound_source.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace tp {

inline constexpr double click_ahead_s = 0.02;     ///< so much after its time a click is put into the samples
inline constexpr double loudest_click = 0.25;     ///< peak, of amplitude 1: −12 dBFS
inline constexpr double shortest_click_s = 0.003; ///< a shorter one cracks
inline constexpr double longest_click_s = 0.05;
inline constexpr double dull_click_hz = 300.0;   ///< of sharpness 0
inline constexpr double sharp_click_hz = 3000.0; ///< of sharpness 1

/// Clicks as samples, to the sample: whenever the loudspeaker asks and for however much, two clicks are heard as far apart as
/// their times are. Each is a tone under a round window, of bounded length and loudness; a new one takes the place of one
/// that is under way. One that comes too late to be heard at its place is heard at once.
class ClickStream final : public SoundSource {
public:
    /// `now` tells the clock that clicks go by, s; asked on the loudspeaker's thread.
    ClickStream(std::shared_ptr<ClickList> list, std::function<double()> now);

    std::size_t pull(std::span<float> samples) override;
    void heard(std::int64_t) override {}
    bool answers_a_finger() const override { return true; }

private:
    struct Sounding {
        std::int64_t begin = 0; ///< frame
        std::int64_t frames = 0;
        double amplitude = 0.0;
        double hz = 0.0;
        double sample(std::int64_t frame) const;
    };
    std::optional<Sounding> next(double origin);

    std::shared_ptr<ClickList> list_;
    std::function<double()> now_;
    std::int64_t frame_ = 0;
    std::optional<double>
        origin_; ///< s, time of frame 0: the earliest that any call allows, for calls may be late only
    std::optional<Sounding> sounding_, coming_;
};

} // namespace tp
