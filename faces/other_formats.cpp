// SPDX-License-Identifier: Apache-2.0
#include "faces/other_formats.hpp"

#include "faces/quiet_opencv.hpp"

#include <opencv2/imgcodecs.hpp>

#include <dlfcn.h>

namespace tp {
namespace {

using Decode = cv::Mat (*)(cv::InputArray bytes, int flags);

/// cv::imdecode; null where its library cannot be loaded.
Decode find_decoder() {
    void* const library = dlopen(TP_OPENCV_CODECS, RTLD_NOW | RTLD_LOCAL);
    return library ? reinterpret_cast<Decode>(dlsym(library, "_ZN2cv8imdecodeERKNS_11_InputArrayEi"))
                   : nullptr;
}

} // namespace

Result<cv::Mat> decode_other_format(const Bytes& bytes) {
    const HushedThread hushed;
    static const Decode decode = find_decoder();
    if (!decode)
        return Error{"Pictures other than JPEG need the library " TP_OPENCV_CODECS
                     " (Debian: libopencv-imgcodecs406), which is not here: install it or save the picture "
                     "as JPEG."};
    try {
        return decode(bytes, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) { // limits of OpenCV and of the decoders below it
        return cv::Mat();
    }
}

} // namespace tp
