// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/near_groups.hpp"

#include <algorithm>
#include <array>

namespace tp {
namespace {

constexpr std::size_t lanes = 16;
constexpr double rounding = 8.0; ///< steps²: twenty times what single precision errs by at this size

float product(const float* a, const float* b) {
    std::array<float, lanes> sums{};
    for (std::size_t i = 0; i < descriptor_length; i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            sums[lane] += a[i + lane] * b[i + lane];
    float sum = 0.0F;
    for (const float part : sums)
        sum += part;
    return sum;
}

} // namespace

void NearGroups::set(GroupId group, const GroupSum& sum) {
    const auto [entry, is_new] = places_.try_emplace(group, groups_.size());
    if (is_new) {
        groups_.push_back(group);
        squares_.push_back(0.0F);
        middles_.resize(middles_.size() + descriptor_length);
    }
    const std::array<float, descriptor_length> middle = sum.middle();
    std::ranges::copy(middle, middles_.data() + entry->second * descriptor_length);
    squares_[entry->second] = static_cast<float>(sum.mean_square());
}

void NearGroups::erase(GroupId group) {
    const auto entry = places_.find(group);
    if (entry == places_.end())
        return;
    const std::size_t place = entry->second, last = groups_.size() - 1;
    places_.erase(entry);
    if (place != last) { // the last one moves to where this one was
        std::copy_n(middles_.data() + last * descriptor_length, descriptor_length,
                    middles_.data() + place * descriptor_length);
        squares_[place] = squares_[last];
        groups_[place] = groups_[last];
        places_[groups_[place]] = place;
    }
    groups_.pop_back();
    squares_.pop_back();
    middles_.resize(last * descriptor_length);
}

std::vector<GroupId> NearGroups::within(const FaceDescriptor& face, double most) const {
    std::array<float, descriptor_length> numbers{};
    std::ranges::copy(face, numbers.begin());
    const float own = product(numbers.data(), numbers.data());
    const auto limit = static_cast<float>(most + rounding);
    std::vector<GroupId> near;
    for (std::size_t place = 0; place < groups_.size(); ++place) {
        const float twice = 2.0F * product(numbers.data(), middles_.data() + place * descriptor_length);
        if (own + squares_[place] - twice <= limit)
            near.push_back(groups_[place]);
    }
    return near;
}

} // namespace tp
