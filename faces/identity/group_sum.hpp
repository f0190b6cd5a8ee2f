// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/identity/descriptor.hpp"

#include <array>
#include <cstdint>

namespace tp {

/// What must be known of a group of faces to say how far another face, or another group, is from it: sums of whole
/// numbers, which are the same in whatever order they were made. Enough for 16 million faces.
class GroupSum {
public:
    void add(const FaceDescriptor& face);
    void take(const FaceDescriptor& face); ///< one that was added
    void add(const GroupSum& other);

    std::int64_t count() const { return count_; }
    /// Mean of the squared distances from `face` to each face of the group, in steps². Of one face or more.
    double mean_squared(const FaceDescriptor& face) const;
    /// The same over all pairs of a face here and one there.
    double mean_squared(const GroupSum& other) const;
    /// The middle of the group, and the mean of the squares of its faces, in steps.
    std::array<float, descriptor_length> middle() const;
    double mean_square() const;

private:
    std::array<std::int32_t, descriptor_length> sums_{};
    std::int64_t squares_ = 0, count_ = 0;
};

} // namespace tp
