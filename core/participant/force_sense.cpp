// SPDX-License-Identifier: Apache-2.0
#include "core/participant/force_sense.hpp"

#include <cmath>
#include <numbers>

namespace tp {

double SlowNoise::next(Chance& chance, double dt_s) {
    const double kept = std::exp(-dt_s / memory_s_);
    value_ = kept * value_ + std::sqrt(1.0 - kept * kept) * chance.normal();
    return value_;
}

ForceSense::ForceSense(const Person& person, double dt_s, std::uint64_t seed)
    : person_(person), dt_s_(dt_s), chance_(seed),
      on_its_way_(static_cast<std::size_t>(std::max(1L, std::lround(person.delay_s / dt_s))), Vec2(0.0)),
      size_(person.noise_s), direction_(person.noise_s), x_(person.noise_s), y_(person.noise_s) {}

Vec2 ForceSense::feel(Vec2 force) {
    const Vec2 arrived = on_its_way_[next_];
    on_its_way_[next_] = force;
    next_ = (next_ + 1) % on_its_way_.size();
    const double share = 1.0 + person_.weber * size_.next(chance_, dt_s_);
    const double turn = person_.direction_deg * std::numbers::pi / 180.0 * direction_.next(chance_, dt_s_);
    const Vec2 noise{x_.next(chance_, dt_s_), y_.next(chance_, dt_s_)};
    const double c = std::cos(turn), s = std::sin(turn);
    const Vec2 felt = share * Vec2(c * arrived.x - s * arrived.y, s * arrived.x + c * arrived.y) +
                      person_.force_noise_n * noise;
    return length(felt) >= person_.threshold_n ? felt : Vec2(0.0);
}

} // namespace tp
