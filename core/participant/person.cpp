// SPDX-License-Identifier: Apache-2.0
#include "core/participant/person.hpp"

#include "core/base/chance.hpp"

#include <algorithm>
#include <cmath>

namespace tp {

Person person_of(int number, std::uint64_t seed) {
    Chance chance(seed * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(number));
    Person person;
    const auto spread = [&](double& quantity, double share) {
        quantity *= std::exp(share * std::clamp(chance.normal(), -2.0, 2.0));
    };
    // Between people: 15 % where there is a band in the literature, a quarter where people differ in manner (both assumed).
    for (double* const known : {&person.mass_kg, &person.stiffness_n_per_mm, &person.delay_s, &person.weber,
                                &person.direction_deg, &person.length_share})
        spread(*known, 0.15);
    for (double* const manner :
         {&person.threshold_n, &person.motor_noise, &person.follow_speed_mm_s, &person.search_speed_mm_s,
          &person.yield_mm_s_n, &person.turn_s, &person.brake_n, &person.doubt_s, &person.trust_per_s,
          &person.place_mm, &person.answer_s, &person.touch_mm})
        spread(*manner, 0.25);
    spread(person.heading_deg, 0.15);
    spread(person.joint_mm, 0.15);
    // The same damping ratio for everybody: arms that are stiffer are more damped.
    const Person typical;
    person.damping_n_s_per_m *= std::sqrt(person.mass_kg * person.stiffness_n_per_mm /
                                          (typical.mass_kg * typical.stiffness_n_per_mm));
    person.force_noise_n = person.threshold_n / 4.0;
    return person;
}

} // namespace tp
