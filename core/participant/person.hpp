// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tp {

/// One simulated person: what is known, and what is assumed, of hands that feel their way along a force. The numbers are those of a
/// typical person; `person_of` spreads them. None was chosen for what it makes of the published experiments; "assumed" means that
/// nothing published was found for it, and that it is an order of magnitude.
struct Person {
    // The arm behind the finger as a moving impedance: Hogan, "The mechanics of multi-joint posture and movement control", Biol Cybern
    // 52, 1985; Tsuji, Morasso, Goto, Ito, "Human hand impedance characteristics during maintained posture", Biol Cybern 72, 1995.
    // These have stiffnesses of some hundred N/m, some ten N·s/m and about a kilogram for a hand that holds its posture; a hand that
    // lets itself be guided is softer and lighter (assumed: at the lower end).
    double mass_kg = 0.6;             ///< with the handle
    double damping_n_s_per_m = 12.0;  ///< damping ratio 0.6
    double stiffness_n_per_mm = 0.15; ///< between where the hand is meant to be and where it is

    // What is felt of a force.
    /// From a force to what the hand does on purpose about it, s: 0.12 to 0.18 for touch and proprioception (reviewed by Jeannerod,
    /// "The Neural and Behavioural Organization of Goal-Directed Movements", 1988).
    double delay_s = 0.15;
    /// Just noticeable share of a force: 7 to 10 % (Jones, "Matching forces", Perception 18, 1989; Pang, Tan, Durlach, "Manual
    /// discrimination of force using active finger motion", Percept Psychophys 49, 1991).
    double weber = 0.085;
    double threshold_n = 0.06;    ///< smallest force that is noticed by a moving hand (assumed)
    double force_noise_n = 0.015; ///< standard deviation of what is felt where there is nothing (assumed)
    /// Standard deviation of a force's felt direction, degrees: directions are told apart at 18 to 32 (Barbagli, Salisbury, Ho,
    /// Spence, Tan, "Haptic discrimination of force direction and the influence of visual information", ACM TAP 3, 2006).
    double direction_deg = 20.0;
    double noise_s = 0.15; ///< time constant of these noises (assumed)

    // What the hand does.
    /// Standard deviation of the hand's velocity as a share of its speed: noise grows with the signal (Harris and Wolpert,
    /// "Signal-dependent noise determines motor planning", Nature 394, 1998). The share is assumed.
    double motor_noise = 0.15;
    double follow_speed_mm_s =
        50.0; ///< preferred, along a wide line (assumed: that of fingers on raised lines and braille)
    double search_speed_mm_s = 80.0; ///< while nothing is felt (assumed)
    /// Speed goes with the cube root of the radius of a bend: the two-thirds power law (Lacquaniti, Terzuolo, Viviani, "The law relating
    /// the kinematic and figural aspects of drawing movements", Acta Psychol 54, 1983). Here the preferred speed holds, mm:
    double preferred_radius_mm = 50.0;
    double yield_mm_s_n = 15.0; ///< how fast a hand goes along with a force that it feels (assumed)
    double lean_rad_n =
        0.5; ///< by which angle the hand heads for the pull beside going along the line (assumed)
    double turn_s = 0.15; ///< time constant of turning to the line's direction, once felt (assumed)
    double brake_n = 0.3; ///< a force against the movement that stops the hand (assumed)
    double doubt_s = 0.5; ///< so long nothing is felt until the hand sways to find the line (assumed)
    double caution =
        0.6; ///< its speed after the line was lost, as a share of that before; also at first (assumed)
    double trust_per_s =
        0.15; ///< by which share the speed grows in a second without a pull, and falls at twice `brake_n` (assumed)

    // What is remembered.
    /// Standard deviation of a felt place from where it was, mm: position sense of an unseen hand (order of van Beers, Sittig, Denier
    /// van der Gon, "The precision of proprioceptive position sense", Exp Brain Res 122, 1998).
    double place_mm = 6.0;
    /// But of places near each other no worse than that share of the size that was felt: lengths between fingers are told apart at some
    /// 5 to 10 % (Durlach and others, "Manual discrimination and identification of length by the finger-span method", Percept
    /// Psychophys 46, 1989).
    double length_share = 0.1;
    /// And however near, no better than that, mm: fingers' joints are told apart at 2.5° (Tan, Srinivasan, Eberman, Cheng, "Human
    /// factors for the design of force-reflecting haptic interfaces", ASME DSC 55-1, 1994), some 90 mm from the knuckle to the tip. So
    /// neither is the direction of a short side known better than that over its length.
    double joint_mm = 4.0;
    /// Standard deviation of the remembered direction in which the hand went, degrees: angles between two ways of the arm are told apart
    /// at 4.7, three times in four (Voisin, Benoit, Chapman, "Haptic discrimination of object shape in humans: two-dimensional angle
    /// discrimination", Exp Brain Res 145, 2002), which is 3.5 for either way.
    double heading_deg = 3.5;
    /// Standard deviation with which a place of a face's contour is felt, mm: of the size of what can be told apart at all
    /// (core/study/finger_touch.hpp; assumed).
    double touch_mm = 1.0;
    double answer_s = 1.0; ///< from knowing to the key (assumed)
    int most_rounds = 3;   ///< round a shape before an answer is given anyway (assumed)
};

/// Participant `number` (from 1) of a study's seed: each quantity lies a factor of normally distributed logarithm from the typical
/// one, with the spread that stands beside it in person.cpp. The same numbers with every compiler.
Person person_of(int number, std::uint64_t seed);

} // namespace tp
