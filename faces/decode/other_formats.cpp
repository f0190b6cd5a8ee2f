// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/other_formats.hpp"

#include "core/libraries/loaded_library.hpp"
#include "core/libraries/package_name.hpp"
#include "faces/decode/quiet_opencv.hpp"

#include <opencv2/imgcodecs.hpp>

namespace tp {
namespace {

using Decode = cv::Mat(cv::InputArray bytes, int flags);

/// cv::imdecode; null where its library cannot be loaded.
Decode* find_decoder() {
    Decode* decode = nullptr;
    LoadedLibrary(TP_OPENCV_CODECS).find(decode, "_ZN2cv8imdecodeERKNS_11_InputArrayEi");
    return decode;
}

/// Loaded at the first call.
Decode* decoder() {
    const HushedThread hushed;
    static Decode* const decode = find_decoder();
    return decode;
}

} // namespace

bool load_other_decoders() { return decoder() != nullptr; }

Result<cv::Mat> decode_other_format(const Bytes& bytes) {
    const HushedThread hushed;
    Decode* const decode = decoder();
    if (!decode)
        return Error{"Pictures other than JPEG need the library " TP_OPENCV_CODECS " (Debian: " +
                     debian_package(TP_OPENCV_CODECS) +
                     "), which is not installed: install it or save the picture as JPEG."};
    try {
        return decode(bytes, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception&) { // limits of OpenCV and of the decoders below it
        return cv::Mat();
    }
}

} // namespace tp
