// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// What sounds until the next cue.
struct SonarCue {
    double interval_s = 0.0; ///< from the beginning of one beep to that of the next; 0: one steady tone
    double from_hz = 0.0;    ///< a beep's pitch at its beginning; a steady tone's
    double to_hz = 0.0;      ///< a beep's pitch at its end
    double gain = 0.0;       ///< peak, 0 … 1
    double side = 0.0;       ///< -1 left … 1 right
    double reed = 0.0;       ///< amplitude of the third harmonic beside the tone's own 1

    bool steady() const { return interval_s <= 0.0; }
    bool operator==(const SonarCue&) const = default;
};

inline constexpr double on_line_mm = 1.5;       ///< so near a fingertip is on the line
inline constexpr double far_mm = 40.0;          ///< from here on the beeps do not slow down further
inline constexpr double shortest_interval_s = 0.10;
inline constexpr double longest_interval_s = 0.80;
inline constexpr double beep_s = 0.05;
inline constexpr double level_hz = 660.0;       ///< of a line beside the finger, and on it
inline constexpr double beep_gain = 0.18;       ///< −15 dBFS
inline constexpr double far_gain = 0.09;        ///< −21 dBFS
inline constexpr double line_gain = 0.06;       ///< −24 dBFS
inline constexpr double most_reed = 0.5;

/// How the way to the nearest line sounds. `distance_mm` ≥ 0 to it, `right` and `up` the direction to it (any
/// length; none where the finger is on the line). NaN or infinity is taken for far away.
///
/// The interval between beeps is a linear function of distance: in Bazilinskyy et al. 2016 ("Sonifying the location
/// of an object: a comparison of three methods") beep rate beat loudness for distance together with direction, and
/// no method was better. Height is pitch, the mapping that people bring with them (Parise, Knorre, Ernst, PNAS 2014):
/// an octave from straight below to straight above for the beep as a whole, half an octave within it. Left and right
/// are loudness by ear and, for one loudspeaker, timbre, which is heard independently of pitch and rate (Ziemer,
/// Schultheis 2018). A target that has a sound of its own is found more precisely (Parseihian et al., IEEE
/// Transactions on Multimedia 2016), so the line itself is one steady tone; it is softer than the beeps, because
/// people prefer sound that falls with their error.
SonarCue sonar_cue(double distance_mm, double right, double up);

/// How a place sounds to which a finger is led: `across` 0 left … 1 right, `height` 0 bottom … 1 top of the surface.
/// A steady tone, an octave below the level at the bottom and one above at the top.
SonarCue tour_cue(double across, double height);

} // namespace tp
