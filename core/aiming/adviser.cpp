// SPDX-License-Identifier: Apache-2.0
#include "core/aiming/adviser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tp {

namespace {

constexpr double worst = 10.0;         ///< no fault counts more
constexpr double cut_slope = 0.05;     ///< of the picture, by which a face reaches over an edge
constexpr double light_slope = 0.1;    ///< of brightness, within which a face becomes one limit darker
constexpr double contrast_slope = 0.2; ///< the same of the light behind
constexpr double sharp_slope = 0.2;
constexpr double bright_face = 0.45; ///< from here on a face is light enough before any background
constexpr double tone_says = 0.5;    ///< of a fault that a tone tells too
constexpr double shut_eyes = 1.2;
constexpr double lost_s = 5.0; ///< so long a lost face is looked for where it went
constexpr double went_somewhere =
    0.2; ///< share of the picture beside its place, from where a lost face has gone off that way

// What hands take for "a little" is about 5°, without a word of measure 10°, and "far" 20°: between them, for a field of
// 62° by 37°.
constexpr double little_width = 0.12; ///< of the picture
constexpr double some_width = 0.24;
constexpr double little_height = 0.2;
constexpr double some_height = 0.4;
constexpr double field_height_deg = 37.0;
constexpr double little_turn = 8.0; ///< degrees
constexpr double some_turn = 15.0;
constexpr double half_step_m = 0.4;
constexpr double one_step_m = 0.9;

/// AimFault after fault: where the camera is, how it lies, then light, then the moment.
constexpr std::array<std::array<AimFault, 4>, 4> turns{{
    {AimFault::across, AimFault::height, AimFault::size, AimFault::tilt},
    {AimFault::light, AimFault::light, AimFault::light, AimFault::light},
    {AimFault::blur, AimFault::blur, AimFault::blur, AimFault::blur},
    {AimFault::eyes, AimFault::eyes, AimFault::eyes, AimFault::eyes},
}};

std::size_t at(AimFault fault) { return static_cast<std::size_t>(fault); }

double bounded(double size) { return std::isfinite(size) ? std::clamp(size, 0.0, worst) : 0.0; }

AimStep step_of(double amount, double little, double some) {
    return amount < little ? AimStep::little : amount < some ? AimStep::some : AimStep::much;
}

/// Neither side helps: somebody is cut at both, or people are missing, and nobody knows on which side.
bool steps_back(const Framing& framing) {
    return (framing.cut_both && framing.size_off > 0.0) || framing.missing > 0;
}

double side_fault(double off, double tolerance, double cut) {
    const double beside = std::abs(off) / tolerance;
    return cut != 0.0 ? std::max(beside, begins_at + std::abs(cut) / cut_slope) : beside;
}

} // namespace

void Adviser::forget() {
    framing_.reset();
    sizes_ = {};
    there_ = {};
    present_.reset();
    searching_since_.reset();
    left_by_.reset();
    too_large_ = false;
    tilt_deg_ = 0.0;
    backlit_ = false;
}

bool Adviser::good() const {
    return framing_ && std::none_of(there_.begin(), there_.end(), [](bool there) { return there; });
}

AimInstruction Adviser::advise(const std::vector<TrackedFace>& faces, const AimFrame& frame) {
    framing_ = framer_.frame(faces, frame.aspect);
    AimInstruction instruction;
    if (!framing_) {
        sizes_ = {};
        there_ = {};
        present_.reset();
        return search(frame);
    }
    searching_since_.reset();
    left_by_ = framing_->off;
    too_large_ = framing_->size_off > begins_at;
    measure(faces, frame);

    std::optional<AimFault> chosen;
    for (const auto& turn : turns) {
        for (const AimFault fault : turn)
            if (there_[at(fault)] && (!chosen || urgency(fault) > urgency(*chosen)))
                chosen = fault;
        if (!chosen)
            continue;
        const bool same_turn = present_ && std::find(turn.begin(), turn.end(), *present_) != turn.end();
        if (same_turn && there_[at(*present_)] && urgency(*chosen) < takes_turn * urgency(*present_))
            chosen = present_;
        break;
    }
    present_ = chosen;
    instruction = chosen ? words_for(*chosen) : AimInstruction{Advice::ready};
    instruction.faces = static_cast<int>(faces.size());
    instruction.names = names_of(faces);
    const Vec2 cut = framing_->cut;
    const bool sideways = std::abs(cut.x) >= std::abs(cut.y);
    if (sideways && cut.x != 0.0)
        instruction.cut = (cut.x < 0.0) != camera_.swaps_sides() ? AimEdge::left : AimEdge::right;
    else if (cut.y != 0.0)
        instruction.cut = cut.y < 0.0 ? AimEdge::top : AimEdge::bottom;
    return instruction;
}

/// How much words help against a fault. A tone says where the camera is to go; words say first what it cannot.
double Adviser::urgency(AimFault fault) const {
    const bool heard = tone_ && (fault == AimFault::across || fault == AimFault::height);
    return heard ? tone_says * sizes_[at(fault)] : sizes_[at(fault)];
}

/// Where the last one went; otherwise, held upright, one way, the other way twice as long and back, sideways and then up and down.
AimInstruction Adviser::search(const AimFrame& frame) {
    const double now_s = frame.time_s;
    if (!searching_since_ || now_s < *searching_since_)
        searching_since_ = now_s;
    const double since = now_s - *searching_since_;
    if (left_by_ && since < lost_s) {
        const Vec2 way = *left_by_;
        if (std::max(std::abs(way.x), std::abs(way.y)) > went_somewhere)
            return {way_to(way, std::abs(way.x) >= std::abs(way.y), Advice::look_left)};
    }
    if (too_large_) {
        AimInstruction back;
        back.advice = Advice::farther;
        back.amount = one_step_m;
        back.step = AimStep::some;
        return back;
    }
    // Upright first: then people are beside it, not above or below.
    if (frame.elevation_deg && std::abs(*frame.elevation_deg) > upright_deg) {
        AimInstruction upright;
        upright.advice = *frame.elevation_deg > 0.0 ? Advice::move_down : Advice::move_up;
        upright.amount = std::abs(*frame.elevation_deg) / field_height_deg;
        upright.step = step_of(upright.amount, little_height, some_height);
        return upright;
    }
    constexpr std::array<std::pair<Advice, double>, 6> sweep{{{Advice::look_right, 1.0},
                                                              {Advice::look_left, 2.0},
                                                              {Advice::look_right, 1.0},
                                                              {Advice::look_up, 0.5},
                                                              {Advice::look_down, 1.0},
                                                              {Advice::look_up, 0.5}}};
    double in_round = std::fmod(since / sweep_s, 6.0);
    for (const auto& [advice, turns_long] : sweep) {
        if (in_round < turns_long)
            return {advice};
        in_round -= turns_long;
    }
    return {sweep.front().first};
}

void Adviser::measure(const std::vector<TrackedFace>& faces, const AimFrame& frame) {
    const Framing& framing = *framing_;
    AimFaultSizes sizes{};
    sizes[at(AimFault::across)] = side_fault(framing.off.x, framing.tolerance.x, framing.cut.x);
    sizes[at(AimFault::height)] = side_fault(framing.off.y, framing.tolerance.y, framing.cut.y);
    sizes[at(AimFault::size)] = std::abs(framing.size_off);
    const double tilt = framing.tilt_deg.value_or(frame.horizon_deg.value_or(0.0));
    tilt_deg_ = std::isfinite(tilt) ? tilt : 0.0;
    sizes[at(AimFault::tilt)] = std::abs(tilt_deg_) / level_deg;

    std::optional<double> darkest;
    double moves = 0.0;
    for (const TrackedFace& face : faces) {
        if (std::find(framing.subjects.begin(), framing.subjects.end(), face.id) == framing.subjects.end())
            continue;
        if (face.brightness && (!darkest || *face.brightness < *darkest))
            darkest = face.brightness;
        if (face.eyes_shut)
            sizes[at(AimFault::eyes)] = shut_eyes;
        moves = std::max(moves, std::hypot(face.speed.x, face.speed.y / frame.aspect));
    }
    if (darkest) {
        const double too_dark = begins_at + (darkest_face - *darkest) / light_slope;
        const double behind =
            frame.surroundings && *darkest < bright_face
                ? begins_at + (*frame.surroundings - *darkest - against_light) / contrast_slope
                : 0.0;
        backlit_ = behind >= (backlit_ ? ends_at : begins_at);
        sizes[at(AimFault::light)] = std::max(too_dark, behind);
    }
    if (frame.motion && std::isfinite(*frame.motion))
        moves = std::max(moves, *frame.motion);
    sizes[at(AimFault::blur)] = moves / still_enough;
    if (frame.sharpness && std::isfinite(*frame.sharpness))
        sizes[at(AimFault::blur)] =
            std::max(sizes[at(AimFault::blur)], begins_at + (sharp_enough - *frame.sharpness) / sharp_slope);

    for (std::size_t i = 0; i < aim_fault_count; ++i) {
        sizes_[i] = bounded(sizes[i]);
        there_[i] = sizes_[i] >= (there_[i] ? ends_at : begins_at);
    }
    if (steps_back(framing)) {
        there_[at(AimFault::size)] = true;
        sizes_[at(AimFault::size)] = worst;
    }
}

/// The advice on the way `picture_way` along one axis; `first` is the one to the left, the others follow it.
Advice Adviser::way_to(Vec2 picture_way, bool across, Advice first) const {
    const Vec2 way = camera_.hand_way(picture_way);
    const int further = across ? (way.x < 0.0 ? 0 : 1) : (way.y > 0.0 ? 2 : 3);
    return static_cast<Advice>(static_cast<int>(first) + further);
}

AimInstruction Adviser::words_for(AimFault fault) const {
    const Framing& framing = *framing_;
    AimInstruction instruction;
    switch (fault) {
    case AimFault::across:
    case AimFault::height: {
        const bool across = fault == AimFault::across;
        const Vec2 way{framing.cut.x != 0.0 ? framing.cut.x : framing.off.x,
                       framing.cut.y != 0.0 ? framing.cut.y : framing.off.y};
        instruction.advice = way_to(way, across, Advice::move_left);
        instruction.amount = std::max(std::abs(across ? framing.off.x : framing.off.y),
                                      std::abs(across ? framing.cut.x : framing.cut.y));
        instruction.step = across ? step_of(instruction.amount, little_width, some_width)
                                  : step_of(instruction.amount, little_height, some_height);
        break;
    }
    case AimFault::size:
        instruction.advice =
            framing.size_off < 0.0 && !steps_back(framing) ? Advice::closer : Advice::farther;
        instruction.amount = framing.missing > 0
                                 ? half_step_m
                                 : std::abs(1.0 - 1.0 / framing.grow) * metres_per_size / framing.face;
        instruction.step = step_of(instruction.amount, half_step_m, one_step_m);
        break;
    case AimFault::tilt:
        instruction.amount = std::abs(tilt_deg_);
        instruction.advice =
            camera_.hand_turn(tilt_deg_) > 0.0 ? Advice::turn_clockwise : Advice::turn_anticlockwise;
        instruction.step = step_of(instruction.amount, little_turn, some_turn);
        break;
    case AimFault::light:
        instruction.advice = backlit_ ? Advice::light_behind_them : Advice::more_light;
        break;
    case AimFault::blur:
        instruction.advice = Advice::keep_still;
        break;
    case AimFault::eyes:
        instruction.advice = Advice::eyes_shut;
        break;
    }
    return instruction;
}

} // namespace tp
