// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace tp {

/// How a tone goes: `steady` rises and falls by half a cosine of `edge_ms`; `struck` rises by one and dies
/// away exponentially to −40 dB, ending in one.
enum class Envelope { steady, struck };

/// One tone of an earcon. Its frequency glides evenly in pitch from the first to the second.
struct Tone {
    int begin_ms;
    int duration_ms;
    double from_hz; ///< 300–3000
    double to_hz;
    Envelope envelope;
    double third_harmonic = 0.0; ///< amplitude beside the tone's own 1; makes it reedy
};

inline constexpr int edge_ms = 6;                ///< shorter ones click
inline constexpr double earcon_peak = 0.2511886; ///< −12 dBFS

/// The tones added up at 48 000 samples a second, scaled to the peak.
std::vector<float> render_tones(std::span<const Tone> tones);

} // namespace tp
