// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <string>
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

/// A colour for each pixel: `pattern` gives 0 … 1 between two colours of chance.
template <typename Pattern>
cv::Mat two_coloured(cv::RNG& random, cv::Size size, Pattern pattern) {
    cv::Vec3f colours[2];
    for (cv::Vec3f& colour : colours)
        for (int c = 0; c < 3; ++c)
            colour[c] = static_cast<float>(random.uniform(0, 256));
    cv::Mat picture(size, CV_8UC3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const float share = static_cast<float>(std::clamp(pattern(double(x), double(y)), 0.0, 1.0));
            picture.at<cv::Vec3b>(y, x) = colours[0] + share * (colours[1] - colours[0]);
        }
    return picture;
}

/// Waves in one direction, of `length` px.
inline cv::Mat stripes(cv::RNG& random, cv::Size size, double length) {
    const double angle = random.uniform(0.0, CV_PI), c = std::cos(angle) / length,
                 s = std::sin(angle) / length;
    return two_coloured(random, size, [=](double x, double y) {
        return 0.5 + 0.5 * std::sin(2.0 * CV_PI * (c * x + s * y));
    });
}

/// Bricks with joints, every second row set off.
inline cv::Mat bricks(cv::RNG& random, cv::Size size, double height) {
    return two_coloured(random, size, [height](double x, double y) {
        const double row = std::floor(y / height), along = x / (2.2 * height) + 0.5 * std::fmod(row, 2.0);
        return std::fmod(along, 1.0) < 0.06 || y / height - row < 0.12 ? 1.0 : 0.0;
    });
}

/// Rings about a centre, as in wood, bent by waves.
inline cv::Mat wood(cv::RNG& random, cv::Size size, double ring) {
    const double cx = random.uniform(0.0, double(size.width)), cy = random.uniform(0.0, double(size.height)),
                 bend = random.uniform(0.5, 3.0);
    return two_coloured(random, size, [=](double x, double y) {
        const double r = std::hypot(x - cx, 0.4 * (y - cy)) + bend * ring * std::sin(0.7 * y / ring / 3.0);
        return 0.5 + 0.5 * std::sin(2.0 * CV_PI * r / ring);
    });
}

/// Dots in a grid, every second row set off: pairs of eyes everywhere.
inline cv::Mat dots(cv::RNG& random, cv::Size size, double grid) {
    const double reach = random.uniform(0.15, 0.45);
    return two_coloured(random, size, [=](double x, double y) {
        const double row = std::floor(y / grid),
                     dx = std::fmod(x / grid + 0.5 * std::fmod(row, 2.0), 1.0) - 0.5,
                     dy = y / grid - row - 0.5;
        return (reach - std::hypot(dx, dy)) * grid;
    });
}

/// The cells nearest to points of chance, as in stone or skin of fruit.
inline cv::Mat cells(cv::RNG& random, cv::Size size, int count) {
    std::vector<cv::Point2d> points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(random.uniform(0.0, double(size.width)),
                            random.uniform(0.0, double(size.height)));
    return two_coloured(random, size, [&](double x, double y) {
        double first = 1e9, second = 1e9;
        for (const cv::Point2d& p : points) {
            const double d = std::hypot(p.x - x, p.y - y);
            second = std::min(second, std::max(d, first));
            first = std::min(first, d);
        }
        return (second - first) / 12.0;
    });
}

/// Clouds on clouds, from coarse to fine: marble, foliage, plaster.
inline cv::Mat marble(cv::RNG& random, cv::Size size) {
    cv::Mat sum(size, CV_32FC3, cv::Scalar::all(0));
    for (int grain = 160; grain >= 5; grain /= 2) {
        cv::Mat layer;
        clouds(random, size, grain).convertTo(layer, CV_32FC3);
        sum += layer * (grain / 320.0);
    }
    cv::Mat picture;
    sum.convertTo(picture, CV_8UC3);
    return picture;
}

/// Leaves: ellipses of one hue, dark and light.
inline cv::Mat leaves(cv::RNG& random, cv::Size size, int count) {
    cv::Mat picture(size, CV_8UC3, cv::Scalar(20, 60, 30));
    for (int i = 0; i < count; ++i) {
        const double light = random.uniform(0.4, 1.6);
        cv::ellipse(picture, {random.uniform(0, size.width), random.uniform(0, size.height)},
                    {random.uniform(8, 40), random.uniform(3, 14)}, random.uniform(0, 360), 0, 360,
                    cv::Scalar(40 * light, 110 * light, 60 * light), cv::FILLED, cv::LINE_AA);
    }
    return picture;
}

/// Lines of letters, as on a page or a sign.
inline cv::Mat letters(cv::RNG& random, cv::Size size, double scale) {
    cv::Mat picture(size, CV_8UC3, cv::Scalar::all(random.uniform(180, 256)));
    for (int y = static_cast<int>(30 * scale); y < size.height; y += static_cast<int>(32 * scale)) {
        std::string line;
        while (line.size() < 60)
            line += static_cast<char>(random.uniform('!', 'z'));
        cv::putText(picture, line, {5, y}, cv::FONT_HERSHEY_SIMPLEX, scale,
                    cv::Scalar::all(random.uniform(0, 90)), std::max(1, static_cast<int>(2 * scale)),
                    cv::LINE_AA);
    }
    return picture;
}

/// One of each texture.
inline std::vector<cv::Mat> textures(cv::RNG& random, cv::Size size) {
    return {stripes(random, size, random.uniform(4.0, 60.0)),
            bricks(random, size, random.uniform(8.0, 50.0)),
            wood(random, size, random.uniform(6.0, 40.0)),
            dots(random, size, random.uniform(8.0, 60.0)),
            cells(random, size, random.uniform(10, 60)),
            marble(random, size),
            leaves(random, size, 600),
            letters(random, size, random.uniform(0.4, 2.0))};
}

/// One of each kind, of any content.
inline std::vector<cv::Mat> without_faces(cv::RNG& random, cv::Size size) {
    const int grain = random.uniform(20, 90);
    return {noise(random, size), clouds(random, size, grain), gradient(random, size),
            shapes(random, size, 30, 300), shapes(random, size, 300, 80)};
}

} // namespace drawn
