// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/chance.hpp"
#include "core/geometry/vec.hpp"
#include "core/participant/person.hpp"

#include <cstdint>
#include <vector>

namespace tp {

/// Noise that changes slowly: normally distributed with standard deviation 1 and exponential memory (Uhlenbeck and Ornstein 1930).
class SlowNoise {
public:
    explicit SlowNoise(double memory_s) : memory_s_(memory_s) {}
    /// `dt_s` later.
    double next(Chance& chance, double dt_s);

private:
    double memory_s_;
    double value_ = 0.0;
};

/// What a person feels of the force on the finger: late, not exactly, and nothing below a threshold.
class ForceSense {
public:
    /// `dt_s` > 0 passes between two forces.
    ForceSense(const Person& person, double dt_s, std::uint64_t seed);
    /// The force that acts now, N; what is felt now, N.
    Vec2 feel(Vec2 force);

private:
    Person person_;
    double dt_s_;
    Chance chance_;
    std::vector<Vec2> on_its_way_; ///< ring
    std::size_t next_ = 0;
    SlowNoise size_, direction_, x_, y_;
};

} // namespace tp
