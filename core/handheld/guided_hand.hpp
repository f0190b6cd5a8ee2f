// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/aiming/advice.hpp"
#include "core/aiming/aim_tone.hpp"
#include "core/base/chance.hpp"
#include "core/handheld/held_pose.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace tp {

/// What is known and assumed of hands that aim a camera by ear. No number was chosen for what it makes of the figures;
/// "assumed" means that nothing published was found for it.
struct HandManner {
    /// From what is heard to the hand's begin, s. Blind people's choice reaction to sounds is 0.304 ± 0.030 s (Kumari, Bankey,
    /// Shah, Naghate, "A comparative study of auditory reaction time among blind and blindfolded sighted subjects", 150 blind
    /// people pressing keys); a camera in both hands is slower (assumed: up to twice).
    double fastest_reaction_s = 0.3;
    double slowest_reaction_s = 0.6;
    double speech_starts_s = 0.15;   ///< from an instruction to its sound (assumed)
    double words_per_minute = 175.0; ///< eSpeak NG's own default; practised listeners take far more
    double turn_deg_s = 25.0;        ///< mean speed of a turn that is meant (assumed)
    double look_deg_s = 15.0;        ///< of a slow look round (assumed)
    double walk_m_s = 0.6;           ///< with a camera before one: half of an unhurried walk (assumed)
    double little_deg = 5.0;         ///< what "a little" is to a hand (assumed)
    double some_deg = 10.0;          ///< a direction without a measure (assumed)
    double much_deg = 20.0;          ///< "far" (assumed)
    double little_m = 0.25;          ///< a little closer: the arms, or half a step (assumed)
    double some_m = 0.6;             ///< a step: about the step length of a walk
    double much_m = 1.2;             ///< two steps
    double spread = 0.35;            ///< standard deviation of a move's length, shares of it (assumed)
    /// Left for right. That the words "left" and "right" are confused is known (Farrell, "Coding left and right", 1979); how often
    /// with a camera in the hand is assumed. Up and down are confused less (Maki, Grandy, Hauge 1979), assumed half as often.
    double wrong_side = 0.06;
    double wrong_height = 0.03;
    double tone_wrong_side = 0.06;   ///< a tone's side is taken for the other (assumed the same)
    double tone_wrong_height = 0.10; ///< and its pitch (assumed: not everybody hears at once what is high)
    double tone_spread = 0.3;        ///< of what a rate says of the distance (assumed)
    double tone_step_deg = 4.0;      ///< moved for each tolerance that the tone says it is off (assumed)
    double re_aims_s = 3.0;          ///< without a word or tone one aims anew at the voice so often (assumed)
    /// How exactly one aims at somebody who talks or was touched, standard deviation, degrees (assumed). It is also
    /// how a trial begins.
    double aim_pan_deg = 15.0;
    double aim_tilt_deg = 10.0;
    double aim_roll_deg = 8.0;
};

/// How many words an instruction takes, for how long it is heard: "Far left", "A little left", "Hold still".
int words_in(const AimInstruction& instruction);

/// A person's hand with a camera in it, which knows only what it hears. One per trial; deterministic.
class GuidedHand {
public:
    GuidedHand(const HandManner& manner, const HeldPose& start, bool front, std::uint64_t seed);

    /// A sentence begins; when it ends, s. It replaces one that was not acted upon.
    double hear_words(const AimInstruction& instruction, double now_s);
    /// What sounds from now on.
    void hear_tone(const AimTone& tone, double now_s);
    /// `dt` > 0 s later.
    void step(double dt);
    /// Where the camera would be if the hand did not tremble.
    const HeldPose& pose() const { return pose_; }
    double now_s() const { return now_s_; }

private:
    enum class Axis { pan, tilt, roll, forward };
    struct Move {
        Axis axis;
        double amount; ///< degrees or m, the camera's
        double lasts_s;
        double done_s = 0.0;
        bool look = false;
    };
    void act(const AimInstruction& instruction);
    void follow_tone();
    void correct(const AimTone& tone);
    void aim_at_voice();
    /// `amount` in the holder's terms: right, up, clockwise, closer.
    void move(Axis axis, double amount, double speed, bool look = false);
    double& value(Axis axis);

    HandManner manner_;
    HeldPose pose_;
    double side_; ///< -1 for the front camera: the holder's right is its left
    Chance chance_;
    double reaction_s_; ///< this person's
    double now_s_ = 0.0;
    std::vector<Move> moves_;
    std::optional<AimInstruction> heard_;
    double acts_at_s_ = 0.0;
    bool hears_words_ = false;
    std::deque<std::pair<double, AimTone>> tones_;
    double corrects_at_s_ = 0.0;
    double aims_at_s_ = 0.0;
};

} // namespace tp
