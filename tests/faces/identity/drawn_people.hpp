// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/identity/face_groups.hpp"

#include <cmath>
#include <random>
#include <vector>

/// People who look as different as people do, and descriptors of them in which they vary from picture to picture.
namespace drawn {

inline constexpr double between_people = 0.85,
                        between_pictures = 0.25; ///< mean distances, as in real portraits

class People {
public:
    explicit People(std::uint32_t seed) : random_(seed) {}

    /// One of person `who`, `times` as far from their middle as usual.
    tp::FaceDescriptor picture_of(std::size_t who, double times = 1.0) {
        while (middles_.size() <= who)
            middles_.push_back(noise(between_people));
        tp::FaceNumbers numbers = noise(times * between_pictures);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] += middles_[who][i];
        return *tp::descriptor_of(numbers);
    }
    /// A whole number from 0 to below `end`.
    std::size_t below(std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
    }
    std::mt19937& random() { return random_; }

private:
    /// So that two of them are `apart` from each other.
    tp::FaceNumbers noise(double apart) {
        std::normal_distribution<double> normal(0.0, apart / std::sqrt(2.0 * tp::descriptor_length));
        tp::FaceNumbers numbers{};
        for (float& number : numbers)
            number = static_cast<float>(normal(random_));
        return numbers;
    }

    std::mt19937 random_;
    std::vector<tp::FaceNumbers> middles_;
};

inline tp::ComingFace face(tp::FaceId id, tp::PhotoId photo, const tp::FaceDescriptor& descriptor) {
    tp::ComingFace face;
    face.id = id;
    face.photo = photo;
    face.descriptor = descriptor;
    return face;
}

} // namespace drawn
