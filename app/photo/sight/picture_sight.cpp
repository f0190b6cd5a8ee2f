// SPDX-License-Identifier: Apache-2.0
#include "app/photo/sight/picture_sight.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tp {

namespace {

constexpr int colour_side_px = 256, blur_side_px = 512;
constexpr double least_background = 0.15; ///< of a picture, for something to be said of it

cv::Mat shrunk(const cv::Mat& picture, int longest_px) {
    const double scale = static_cast<double>(longest_px) / std::max(picture.cols, picture.rows);
    if (scale >= 1.0)
        return picture;
    const auto side = [&](int px) { return std::max(static_cast<int>(std::lround(scale * px)), 1); };
    cv::Mat small;
    cv::resize(picture, small, {side(picture.cols), side(picture.rows)}, 0.0, 0.0, cv::INTER_AREA);
    return small;
}

/// Of unsorted values, at a share 0 … 1; 0 where there are none.
double quantile(std::vector<float> values, double share) {
    if (values.empty())
        return 0.0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

/// What is neither a face nor a body below one, 255; faces and bodies 0. As large as `size`.
cv::Mat1b around_people(const cv::Size& size, const Extraction& found) {
    cv::Mat1b around(size, 255);
    const double scale = found.width > 0 ? static_cast<double>(size.width) / found.width : 1.0;
    for (const Face& face : found.faces) {
        const auto cover = [&](double aside, double from, double to) { // widths and heights from its centre
            const Vec2 centre = face.box.centre(), box = face.box.max - face.box.min;
            const Vec2 first = glm::floor(scale * (centre + box * Vec2(-aside, from)));
            const Vec2 last = glm::ceil(scale * (centre + box * Vec2(aside, to)));
            const cv::Rect2d covered(first.x, first.y, last.x - first.x, last.y - first.y);
            around(cv::Rect(covered & cv::Rect2d(0.0, 0.0, size.width, size.height))) = 0;
        };
        constexpr double end = 1000.0; // below every picture
        cover(0.75, -1.0, 0.6);        // head and hair
        cover(1.5, 0.6, end);          // shoulders and what is below
    }
    return around;
}

/// F. Crété, T. Dolmière, P. Ladret, M. Nicolas, "The blur effect: perception and estimation with a new no-reference
/// perceptual blur metric", SPIE 6492 (2007), equations 1 to 8, of one part of a picture.
double blur_of(const cv::Mat& grey) {
    const auto along = [&](bool down) {
        cv::Mat smooth, sharp_steps, smooth_steps;
        cv::blur(grey, smooth, down ? cv::Size(1, 9) : cv::Size(9, 1), cv::Point(-1, -1), cv::BORDER_REFLECT);
        const auto steps = [&](const cv::Mat& picture) {
            const cv::Mat a = down ? picture.rowRange(1, picture.rows) : picture.colRange(1, picture.cols);
            const cv::Mat b =
                down ? picture.rowRange(0, picture.rows - 1) : picture.colRange(0, picture.cols - 1);
            return cv::Mat(cv::abs(a - b));
        };
        sharp_steps = steps(grey);
        smooth_steps = steps(smooth);
        const double all = cv::sum(sharp_steps)[0];
        const double lost = cv::sum(cv::max(0.0, sharp_steps - smooth_steps))[0];
        return all > 0.0 ? (all - lost) / all : 1.0;
    };
    return std::max(along(false), along(true));
}

/// Of the sharpest of nine parts: a blurred background makes no blurred photograph.
double sharpest_blur(const cv::Mat& picture) {
    cv::Mat grey;
    cv::cvtColor(shrunk(picture, blur_side_px), grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(grey, CV_32F);
    constexpr int parts = 3;
    double least = 1.0;
    for (int row = 0; row < parts; ++row)
        for (int column = 0; column < parts; ++column) {
            const cv::Rect part(column * grey.cols / parts, row * grey.rows / parts, grey.cols / parts,
                                grey.rows / parts);
            cv::Scalar mean, spread;
            if (part.width < 16 || part.height < 16)
                return 0.0; // too small to tell
            cv::meanStdDev(grey(part), mean, spread);
            if (spread[0] >= 8.0) // plain sky tells nothing
                least = std::min(least, blur_of(grey(part)));
        }
    return least;
}

/// Places of CIE hue, degrees, from which a colour begins; what is between red and yellow is orange.
struct HueFrom {
    double degrees;
    Colours colour;
};
constexpr std::array hues{HueFrom{0.0, Colours::red},     HueFrom{48.0, Colours::many},
                          HueFrom{80.0, Colours::yellow}, HueFrom{112.0, Colours::green},
                          HueFrom{195.0, Colours::blue},  HueFrom{305.0, Colours::violet},
                          HueFrom{345.0, Colours::red}};

Colours hue_named(double degrees) {
    Colours named = Colours::red;
    for (const HueFrom& hue : hues)
        if (degrees >= hue.degrees)
            named = hue.colour;
    return named;
}

/// The colour of more than half of `pixels` (CIE Lab).
Colours most_of(const std::vector<cv::Vec3f>& pixels) {
    constexpr double colourful = 25.0, share = 0.6;
    std::array<std::size_t, 7> counts{};
    for (const cv::Vec3f& pixel : pixels)
        if (std::hypot(pixel[1], pixel[2]) >= colourful) {
            const double degrees = std::atan2(pixel[2], pixel[1]) * 180.0 / std::numbers::pi;
            ++counts[static_cast<std::size_t>(hue_named(degrees < 0.0 ? degrees + 360.0 : degrees))];
        }
    const auto most = std::max_element(counts.begin(), counts.end());
    return static_cast<double>(*most) > share * static_cast<double>(pixels.size())
               ? static_cast<Colours>(most - counts.begin())
               : Colours::many;
}

/// How far pixels lie from grey, and from the one tone that fits best: CIE C*ab that one in twenty is above.
struct Tones {
    double chroma = 0.0, off_tone = 0.0;
};
Tones tones_of(const std::vector<cv::Vec3f>& pixels) {
    double aa = 0.0, bb = 0.0, ab = 0.0;
    for (const cv::Vec3f& pixel : pixels) {
        aa += static_cast<double>(pixel[1]) * pixel[1];
        bb += static_cast<double>(pixel[2]) * pixel[2];
        ab += static_cast<double>(pixel[1]) * pixel[2];
    }
    const double angle = 0.5 * std::atan2(2.0 * ab, aa - bb); // of the line through grey nearest to all
    std::vector<float> chroma, off;
    for (const cv::Vec3f& pixel : pixels) {
        chroma.push_back(std::hypot(pixel[1], pixel[2]));
        off.push_back(static_cast<float>(std::abs(pixel[2] * std::cos(angle) - pixel[1] * std::sin(angle))));
    }
    return {quantile(std::move(chroma), 0.95), quantile(std::move(off), 0.95)};
}

} // namespace

PictureMeasures measures_of(const cv::Mat& picture, const Extraction& found) {
    PictureMeasures measures;
    if (picture.empty())
        return measures;
    cv::Mat3f lab;
    shrunk(picture, colour_side_px).convertTo(lab, CV_32F, 1.0 / 255.0);
    cv::cvtColor(lab, lab, cv::COLOR_BGR2Lab);
    const cv::Mat1b around = around_people(lab.size(), found);
    measures.somebody = !found.faces.empty();
    std::vector<cv::Vec3f> all(lab.begin(), lab.end()), background;
    std::vector<float> lightness;
    for (int y = 0; y < lab.rows; ++y)
        for (int x = 0; x < lab.cols; ++x)
            if (around(y, x) != 0) {
                background.push_back(lab(y, x));
                lightness.push_back(lab(y, x)[0]);
            }
    if (static_cast<double>(background.size()) >= least_background * static_cast<double>(all.size())) {
        measures.lightest = quantile(lightness, 0.9);
        measures.around = quantile(std::move(lightness), 0.5);
        measures.most = most_of(background);
    }
    const Tones tones = tones_of(all);
    measures.chroma = tones.chroma;
    measures.off_tone = tones.off_tone;
    measures.blur = sharpest_blur(picture);
    return measures;
}

Light light_of(const PictureMeasures& measures) {
    constexpr double dark_below = 40.0, dark_background_below = 12.0, bright_background_from = 86.0;
    if (!measures.around)
        return Light::usual;
    if (*measures.around >= bright_background_from)
        return Light::bright_background;
    const bool dark = measures.lightest < dark_below;
    if (measures.somebody) // who may be lit: of the picture as a whole nothing is said
        return dark || *measures.around < dark_background_below ? Light::dark_background : Light::usual;
    return dark ? Light::dark : Light::usual;
}

Colours colours_of(const PictureMeasures& measures) {
    // Portraits in colour have a chroma of 9 and more, and lie 1.7 and more off one tone.
    constexpr double grey_below = 5.0, one_tone_below = 1.3, print_below = 22.0;
    constexpr double toned_below = 7.0, near_tone_below = 2.6; // an old print that has yellowed
    const bool grey = measures.chroma < grey_below ||
                      (measures.off_tone < one_tone_below && measures.chroma < print_below) ||
                      (measures.chroma < toned_below && measures.off_tone < near_tone_below);
    return grey ? Colours::black_and_white : measures.most;
}

bool is_blurred(const PictureMeasures& measures) {
    constexpr double blurred_from = 0.6; // sharp photographs in the wild reach 0.57
    return measures.blur > blurred_from;
}

} // namespace tp
