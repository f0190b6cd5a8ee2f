// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/decode/picture_file.hpp"
#include "places.hpp"

#include <QByteArray>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <filesystem>
#include <string>

namespace tp::test {

/// Smooth, and different in every corner, so that no two ways of turning it look alike.
inline cv::Mat gradient(int width, int height) {
    cv::Mat picture(height, width, CV_8UC3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at<cv::Vec3b>(y, x) =
                cv::Vec3b(static_cast<unsigned char>(40 + 200 * x / width),
                          static_cast<unsigned char>(30 + 190 * y / height),
                          static_cast<unsigned char>(220 - 100 * x / width - 80 * y / height));
    return picture;
}

/// The largest of all values' differences; very large where the pictures are of different kinds.
inline double largest_difference(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && a.type() == b.type() ? cv::norm(a, b, cv::NORM_INF) : 1e9;
}

/// A folder with pictures that other programs coded: heif-enc, and the scripts in tests/faces/decode.
class MadePictures {
public:
    std::filesystem::path path(const std::string& name) const {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }

    /// `NAME.heic` or, so called, `NAME.avif`.
    std::filesystem::path coded(const std::string& name, const cv::Mat& picture,
                                const QStringList& more = {}) const {
        const std::filesystem::path png = path(name + ".png"), file = path(name);
        cv::imwrite(png.string(), picture);
        run("heif-enc",
            QStringList{"-q", "95", "-p", "chroma=444"} + more + QStringList{text(png), "-o", text(file)});
        return file;
    }

    /// A file of make_heif.py or make_raw.py with the arguments that follow its name.
    std::filesystem::path by_script(const char* script, const std::string& name,
                                    const QStringList& arguments) const {
        run("/usr/bin/python3",
            QStringList{QString(in_source("tests/faces/decode/")) + script, text(path(name))} + arguments);
        return path(name);
    }

    static QString text(const std::filesystem::path& file) { return QString::fromStdString(file.string()); }

private:
    static void run(const QString& program, const QStringList& arguments) {
        QProcess process;
        process.start(program, arguments);
        if (!process.waitForFinished(60'000) || process.exitCode() != 0)
            qFatal("%s: %s", qPrintable(program), process.readAllStandardError().constData());
    }

    QTemporaryDir folder_;
};

} // namespace tp::test
