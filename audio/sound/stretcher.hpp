// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace tp {

inline constexpr double slowest_playing = 0.5;
inline constexpr double fastest_playing = 2.0;

/// Brings a recording to the output's rate and makes it faster or slower with its pitch kept (SoundTouch). At
/// speed 1 and the output's own rate the samples pass unchanged.
class Stretcher {
public:
    /// `rate` of what is put in; `channels` 1 or 2, of both sides; `speed` 0.5–2.
    Stretcher(int rate, int channels, double speed);
    ~Stretcher();

    void put(std::span<const float> samples);
    /// No more is put: what is left comes out, of exactly the length that is due.
    void end();
    /// What has come out and was not taken yet, interleaved; gone at the next call of anything.
    std::span<const float> take();

private:
    struct Touch;
    std::unique_ptr<Touch> touch_; ///< null: passes unchanged
    std::size_t channels_;
    double frames_due_for_one_; ///< frames out for one frame in
    double frames_due_ = 0.0;
    double frames_given_ = 0.0;
    std::vector<float> out_;   ///< what passes unchanged
    std::vector<float> taken_; ///< what take() last gave
};

} // namespace tp
