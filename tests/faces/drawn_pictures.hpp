// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/imgproc.hpp>

#include <vector>

/// Pictures without a face.
namespace drawn {

inline cv::Mat noise(cv::RNG& random, cv::Size size) {
    cv::Mat picture(size, CV_8UC3);
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    return picture;
}

/// Soft blobs of `grain` px.
inline cv::Mat clouds(cv::RNG& random, cv::Size size, int grain) {
    cv::Mat picture;
    cv::resize(noise(random, {size.width / grain + 2, size.height / grain + 2}), picture, size, 0, 0,
               cv::INTER_CUBIC);
    return picture;
}

inline cv::Mat gradient(cv::RNG& random, cv::Size size) {
    cv::Mat picture;
    cv::resize(noise(random, {2, 2}), picture, size, 0, 0, cv::INTER_LINEAR);
    return picture;
}

/// Discs, rings, boxes, ellipses and lines in all colours.
inline cv::Mat shapes(cv::RNG& random, cv::Size size, int count, int largest) {
    const auto colour = [&] {
        return cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256));
    };
    cv::Mat picture(size, CV_8UC3, colour());
    for (int i = 0; i < count; ++i) {
        const cv::Point at(random.uniform(0, size.width), random.uniform(0, size.height));
        const int reach = random.uniform(3, largest);
        const cv::Scalar paint = colour();
        switch (random.uniform(0, 5)) {
        case 0:
            cv::circle(picture, at, reach, paint, cv::FILLED, cv::LINE_AA);
            break;
        case 1:
            cv::circle(picture, at, reach, paint, 3, cv::LINE_AA);
            break;
        case 2:
            cv::rectangle(picture, at, at + cv::Point(reach, random.uniform(3, reach + 4)), paint,
                          cv::FILLED);
            break;
        case 3:
            cv::ellipse(picture, at, {reach, reach / 2 + 1}, random.uniform(0, 360), 0, 360, paint,
                        cv::FILLED, cv::LINE_AA);
            break;
        default:
            cv::line(picture, at,
                     at + cv::Point(random.uniform(-reach, reach), random.uniform(-reach, reach)), paint,
                     random.uniform(1, 8), cv::LINE_AA);
        }
    }
    return picture;
}

/// One of each kind, of any content.
inline std::vector<cv::Mat> without_faces(cv::RNG& random, cv::Size size) {
    const int grain = random.uniform(20, 90);
    return {noise(random, size), clouds(random, size, grain), gradient(random, size),
            shapes(random, size, 30, 300), shapes(random, size, 300, 80)};
}

} // namespace drawn
