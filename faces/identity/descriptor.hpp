// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tp {

inline constexpr std::size_t descriptor_length = 128;

/// What the net says about a face: the nearer two of them, the more alike the faces. Mostly within ±0.5.
using FaceNumbers = std::array<float, descriptor_length>;

/// The same, a byte a number: what is kept of a face. Nothing measurable is lost (faces/identity/FIGURES.md), sums of
/// many are exact, and so groups of faces are the same whatever the order of their sums.
using FaceDescriptor = std::array<std::int8_t, descriptor_length>;

inline constexpr double descriptor_step = 1.0 / 128.0; ///< what a byte counts

/// Each number to the nearest step; beyond ±127 steps it is ±127. Nothing where one is not finite.
std::optional<FaceDescriptor> descriptor_of(const FaceNumbers& numbers);

/// Euclidean distance of the numbers: the same person's mostly below 0.45, others' above 0.6.
double distance(const FaceNumbers& a, const FaceNumbers& b);
double distance(const FaceDescriptor& a, const FaceDescriptor& b);
/// In steps, squared: exact.
std::int32_t squared_distance(const FaceDescriptor& a, const FaceDescriptor& b);

} // namespace tp
