// SPDX-License-Identifier: Apache-2.0
#include "faces/identity/group_sum.hpp"

namespace tp {
namespace {

std::int64_t square_of(const FaceDescriptor& face) { return squared_distance(face, FaceDescriptor{}); }

} // namespace

void GroupSum::add(const FaceDescriptor& face) {
    for (std::size_t i = 0; i < descriptor_length; ++i)
        sums_[i] += face[i];
    squares_ += square_of(face);
    ++count_;
}

void GroupSum::take(const FaceDescriptor& face) {
    for (std::size_t i = 0; i < descriptor_length; ++i)
        sums_[i] -= face[i];
    squares_ -= square_of(face);
    --count_;
}

void GroupSum::add(const GroupSum& other) {
    for (std::size_t i = 0; i < descriptor_length; ++i)
        sums_[i] += other.sums_[i];
    squares_ += other.squares_;
    count_ += other.count_;
}

// Σ|a − b|² over all pairs is nb·Σ|a|² + na·Σ|b|² − 2·Σa·Σb.
double GroupSum::mean_squared(const FaceDescriptor& face) const {
    std::int64_t product = 0;
    for (std::size_t i = 0; i < descriptor_length; ++i)
        product += std::int64_t{face[i]} * sums_[i];
    return static_cast<double>(count_ * square_of(face) + squares_ - 2 * product) /
           static_cast<double>(count_);
}

double GroupSum::mean_squared(const GroupSum& other) const {
    double product = 0.0; // of whole numbers; exact up to 2⁵³, which is groups of 50 000
    for (std::size_t i = 0; i < descriptor_length; ++i)
        product += static_cast<double>(sums_[i]) * other.sums_[i];
    return mean_square() + other.mean_square() -
           2.0 * product / (static_cast<double>(count_) * static_cast<double>(other.count_));
}

std::array<float, descriptor_length> GroupSum::middle() const {
    std::array<float, descriptor_length> middle{};
    for (std::size_t i = 0; i < descriptor_length; ++i)
        middle[i] = static_cast<float>(sums_[i]) / static_cast<float>(count_);
    return middle;
}

double GroupSum::mean_square() const { return static_cast<double>(squares_) / static_cast<double>(count_); }

} // namespace tp
