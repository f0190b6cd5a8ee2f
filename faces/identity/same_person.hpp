// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/identity/descriptor.hpp"

namespace tp {

/// Distance up to which faces are taken for one person's: of a face to a group, and of two groups, the root mean
/// square. Of one person's two portraits of a day the largest is 0.36; from 0.40 on different people were seen in one
/// group (faces/identity/FIGURES.md).
inline constexpr double same_person = 0.39;
/// Up to which somebody is asked about: of a thousand pairs of different people one is as near.
inline constexpr double worth_asking = 0.50;
/// A name is sure only where every other is so much farther.
inline constexpr double clear_lead = 0.10;

/// A distance in steps of a descriptor, squared.
constexpr double squared_steps(double distance) {
    return distance / descriptor_step * (distance / descriptor_step);
}

} // namespace tp
