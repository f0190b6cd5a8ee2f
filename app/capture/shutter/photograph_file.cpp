// SPDX-License-Identifier: Apache-2.0
#include "app/capture/shutter/photograph_file.hpp"

#include "faces/exiv2/prepare_exiv2.hpp"

#include <QString>

#include <exiv2/exiv2.hpp>
#include <opencv2/core.hpp>
#include <turbojpeg.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string_view>

namespace tp {

namespace {

struct EndCoder {
    void operator()(void* handle) const { tjDestroy(handle); }
};
struct FreeBytes {
    void operator()(unsigned char* bytes) const { tjFree(bytes); }
};

/// "+01:00"
std::string offset_text(const QDateTime& time) {
    const int minutes = time.offsetFromUtc() / 60;
    return QString::asprintf("%c%02d:%02d", minutes < 0 ? '-' : '+', std::abs(minutes) / 60,
                             std::abs(minutes) % 60)
        .toStdString();
}

/// Degrees, minutes and seconds to the thousandth.
std::string degrees_text(double degrees) {
    const long long milliseconds = std::llround(std::abs(degrees) * 3'600'000.0);
    return std::to_string(milliseconds / 3'600'000) + "/1 " + std::to_string(milliseconds / 60'000 % 60) +
           "/1 " + std::to_string(milliseconds % 60'000) + "/1000";
}

void say_time(Exiv2::ExifData& exif, const QDateTime& taken) {
    const std::string time = (taken.toString(QStringLiteral("yyyy:MM:dd")) + QLatin1Char(' ') +
                              taken.toString(QStringLiteral("HH:mm:ss")))
                                 .toStdString();
    const std::string part = QString::asprintf("%03d", taken.time().msec()).toStdString();
    exif["Exif.Image.DateTime"] = time;
    for (const char* when : {"Original", "Digitized"}) {
        exif[std::string("Exif.Photo.DateTime") + when] = time;
        exif[std::string("Exif.Photo.SubSecTime") + when] = part;
        exif[std::string("Exif.Photo.OffsetTime") + when] = offset_text(taken);
    }
    exif["Exif.Photo.SubSecTime"] = part;
    exif["Exif.Photo.OffsetTime"] = offset_text(taken);
}

void say_place(Exiv2::ExifData& exif, const Place& place) {
    exif["Exif.GPSInfo.GPSVersionID"] = "2 3 0 0";
    exif["Exif.GPSInfo.GPSLatitudeRef"] = place.latitude < 0.0 ? "S" : "N";
    exif["Exif.GPSInfo.GPSLatitude"] = degrees_text(place.latitude);
    exif["Exif.GPSInfo.GPSLongitudeRef"] = place.longitude < 0.0 ? "W" : "E";
    exif["Exif.GPSInfo.GPSLongitude"] = degrees_text(place.longitude);
}

Exiv2::ExifData exif_of(cv::Size size, const PhotographFacts& facts) {
    Exiv2::ExifData exif;
    exif["Exif.Image.Orientation"] = std::uint16_t{1};
    exif["Exif.Image.Software"] = facts.software;
    if (!facts.make.empty())
        exif["Exif.Image.Make"] = facts.make;
    if (!facts.model.empty())
        exif["Exif.Image.Model"] = facts.model;
    exif["Exif.Photo.ExifVersion"] = "48 50 51 49"; // "0231", where offsets of time came
    exif["Exif.Photo.ColorSpace"] = std::uint16_t{1};
    exif["Exif.Photo.PixelXDimension"] = static_cast<std::uint32_t>(size.width);
    exif["Exif.Photo.PixelYDimension"] = static_cast<std::uint32_t>(size.height);
    if (facts.taken.isValid())
        say_time(exif, facts.taken);
    if (facts.place)
        say_place(exif, *facts.place);
    return exif;
}

} // namespace

Result<CodedPicture> coded_picture(const cv::Mat& picture) {
    if (picture.empty() || picture.type() != CV_8UC3)
        return Error{"it cannot be written."};
    const std::unique_ptr<void, EndCoder> coder(tjInitCompress());
    unsigned char* made = nullptr;
    unsigned long size = 0;
    const int failed = tjCompress2(coder.get(), picture.data, picture.cols, static_cast<int>(picture.step),
                                   picture.rows, TJPF_BGR, &made, &size, TJSAMP_420, photograph_quality, 0);
    const std::unique_ptr<unsigned char, FreeBytes> bytes(made);
    if (failed)
        return Error{"it cannot be written."};
    return CodedPicture{std::string(reinterpret_cast<const char*>(bytes.get()), size), picture.size()};
}

cv::Mat pixels_of(const CodedPicture& coded) {
    if (coded.jpeg.empty() || coded.size.empty())
        return {};
    const std::unique_ptr<void, EndCoder> coder(tjInitDecompress());
    cv::Mat pixels(coded.size, CV_8UC3);
    const bool done = tjDecompress2(coder.get(), reinterpret_cast<const unsigned char*>(coded.jpeg.data()),
                                    static_cast<unsigned long>(coded.jpeg.size()), pixels.data, pixels.cols,
                                    static_cast<int>(pixels.step), pixels.rows, TJPF_BGR, 0) == 0;
    return done ? pixels : cv::Mat();
}

Result<std::string> photograph_jpeg(const CodedPicture& coded, const PhotographFacts& facts) {
    try {
        prepare_exiv2();
        const auto image = Exiv2::ImageFactory::open(reinterpret_cast<const Exiv2::byte*>(coded.jpeg.data()),
                                                     static_cast<long>(coded.jpeg.size()));
        image->setExifData(exif_of(coded.size, facts));
        image->writeMetadata();
        Exiv2::BasicIo& file = image->io();
        file.seek(0, Exiv2::BasicIo::beg);
        std::string whole(file.size(), '\0');
        const auto read =
            file.read(reinterpret_cast<Exiv2::byte*>(whole.data()), static_cast<long>(whole.size()));
        if (static_cast<std::size_t>(read) != whole.size())
            return Error{"it cannot be written."};
        return whole;
    } catch (const std::exception&) { // Exiv2's, or no memory
        return Error{"it cannot be written."};
    }
}

} // namespace tp
