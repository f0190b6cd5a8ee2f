// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/identity/descriptor.hpp"

#include <string>
#include <vector>

namespace tp {

/// By what somebody who has a name is known in a picture of today: the newest faces of a group, never none. Children grow: one
/// person may have several groups.
struct NamedFaces {
    std::string name;
    std::vector<FaceDescriptor> newest;

    bool operator==(const NamedFaces&) const = default;
};

/// Whose face that is, as FaceGroups::offers would be sure of it; empty where it is not sure.
std::string sure_name(const std::vector<NamedFaces>& people, const FaceDescriptor& face);

} // namespace tp
