// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/identity/group_sum.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tp {

using GroupId = std::int64_t;

/// Which of many groups are near a face: a plain look at the middle of each, laid out so that the compiler makes it
/// wide. With 20 000 groups it takes a millisecond (faces/identity/FIGURES.md).
class NearGroups {
public:
    /// From now on the group is so; `sum` holds one face or more.
    void set(GroupId group, const GroupSum& sum);
    void erase(GroupId group);

    /// All groups whose mean_squared from `face` is at most `most` (steps²), and perhaps some that are a little
    /// farther: single precision. In no order that means something.
    std::vector<GroupId> within(const FaceDescriptor& face, double most) const;

private:
    std::vector<float> middles_;  ///< descriptor_length a group
    std::vector<float> squares_;  ///< mean square of its faces
    std::vector<GroupId> groups_; ///< whose these are
    std::unordered_map<GroupId, std::size_t> places_;
};

} // namespace tp
