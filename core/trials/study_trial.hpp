// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.hpp"
#include "core/experiment/trial_order.hpp"
#include "core/guidance/haptic_scene.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace tp {

/// Where faces come from: a folder of photographs, drawn portraits.
class StudyFaces {
public:
    virtual ~StudyFaces() = default;
    /// The contours of one face as a photograph has them (any unit, x right, y down); `expression` and `face` as the experiment
    /// spells its levels.
    virtual Result<std::vector<Contour>> contours(std::string_view expression,
                                                  std::string_view face) const = 0;
};

/// What one trial puts before a finger, in the surface frame (mm, origin at the centre, x right, y up).
struct StudyTrial {
    StudyTask task = StudyTask::follow;
    Scene scene;
    TentProfile profile;
    LawKind law = LawKind::exact;
    Vec2 start{0.0}; ///< where the finger is brought before the trial begins
    /// What is followed, from the start on: in `follow` tasks the one contour of the scene; else without points. It may be gone round
    /// either way where it is closed.
    Polyline path;
    std::vector<Vec2> knots; ///< places of the path that must be passed, else the trial is repeated
    double reach_mm = 0.0;   ///< a knot or an end is passed where the finger comes as near
    std::optional<double> longest_s;
    bool asks = false; ///< at its end an answer is asked for
};

/// How near is near enough, mm; of a path so short that knots would run together, half of what lies between two.
inline constexpr double study_reach_mm = 10.0;
/// Knots divide a path into as many equal parts: of a triangle they are its corners and the middles of its sides.
inline constexpr int study_path_parts = 6;
/// Left free round what lies at a random place, where the surface is large enough, mm.
inline constexpr double study_margin_mm = 10.0;

/// The strongest pull that some trial of the experiment asks for, training too: the largest K·d, N.
double strongest_pull_n(const Experiment& experiment);
/// In how many of the experiment's conditions a limit cuts the pull: K·d is above it.
std::size_t conditions_cut_at(const Experiment& experiment, double limit_n);

/// The trial that was planned. What is random in it follows from its seed: the same on every computer.
///
/// A path lies anywhere on the surface where it fits, and begins at any of its places that it may (a circle everywhere, a triangle at
/// a corner, a curve at an end). A shape to be named lies about the middle of the surface, as published, and the finger begins there,
/// inside. A face fills the surface; the finger begins in the middle. A stiffness, range or law that
/// the experiment does not say is the program's own.
///
/// `faces` may be nullptr where the experiment has none. An error, in one sentence, where there is nothing to follow or name, more
/// than one thing, or where it does not fit on the surface.
Result<StudyTrial> trial_of(const Experiment& experiment, const PlannedTrial& planned,
                            const StudyFaces* faces = nullptr);

/// What the servo renders of it, with the exact law's switches softened or not. The published law is given points a millimetre apart, as
/// its images have them, and cannot be softened: an error.
Result<std::unique_ptr<HapticScene>> haptic_scene_of(const StudyTrial& trial,
                                                     const Continuity& continuity = {});

} // namespace tp
