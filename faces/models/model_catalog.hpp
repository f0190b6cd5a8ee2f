// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/dnn/dnn.hpp>

#include <cstddef>
#include <vector>

namespace tp {

/// The nets that are part of the program (resources/models/ORIGINS.md says where each comes from).
enum class EmbeddedModel {
    detector,
    contours,
    eye,
    mouth,
    outline,
    dark_glasses,
    hidden_jaw,
    mesh,
    yunet,
    descriptor
};

/// A fresh copy of an embedded net, ready to run on the CPU. Throws cv::Exception where the program was built
/// with a file that is not a net.
cv::dnn::Net embedded_net(EmbeddedModel model);

/// An embedded net, for a person.
struct EmbeddedModelFacts {
    const char* name;
    const char* purpose; ///< e.g. "finds faces"
    const char* licence;
    std::size_t bytes;
};
std::vector<EmbeddedModelFacts> embedded_models();

} // namespace tp
