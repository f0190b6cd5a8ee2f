// SPDX-License-Identifier: Apache-2.0
#include "app/capture/seeing/face_namer.hpp"

#include "faces/identity/unfit.hpp"

namespace tp {

std::string FaceNamer::name(const cv::Mat& picture, const Face& face) {
    const KnownPeople::List people = people_->list();
    if (people->empty() || unfit_for_guessing(picture, face) != Unfit::no)
        return {};
    const auto numbers = describer_.describe(picture, face);
    const auto descriptor = numbers ? descriptor_of(*numbers) : std::nullopt;
    return descriptor ? sure_name(*people, *descriptor) : std::string();
}

} // namespace tp
