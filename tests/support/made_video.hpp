// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QFile>
#include <QProcess>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <string>

namespace tp::test {

/// Whether FFmpeg's program is installed, with which the tests make videos as other programs do.
inline bool can_make_videos() {
    QProcess process;
    process.start(QStringLiteral("ffmpeg"), {QStringLiteral("-version")});
    return process.waitForFinished(-1) && process.exitCode() == 0;
}

/// What lies in a video.
struct VideoParts {
    QString sound =
        QStringLiteral("sine=frequency=440:sample_rate=48000:duration=1"); ///< FFmpeg's source; empty: none
    QString codec = QStringLiteral("aac");
    QString container = QStringLiteral("mp4");
    QStringList more = {};
    bool pictures = true;
};

/// Makes a video of a second, 64 × 48 pixels; false where FFmpeg would not, with its words on stderr.
inline bool make_video(const std::filesystem::path& file, const VideoParts& parts = {}) {
    QStringList arguments{QStringLiteral("-nostdin"), QStringLiteral("-v"), QStringLiteral("error"),
                          QStringLiteral("-y")};
    if (parts.pictures)
        arguments << QStringLiteral("-f") << QStringLiteral("lavfi") << QStringLiteral("-i")
                  << QStringLiteral("testsrc=size=64x48:rate=5:duration=1");
    if (!parts.sound.isEmpty())
        arguments << QStringLiteral("-f") << QStringLiteral("lavfi") << QStringLiteral("-i") << parts.sound
                  << QStringLiteral("-c:a") << parts.codec;
    if (parts.pictures)
        arguments << QStringLiteral("-c:v") << QStringLiteral("mpeg4");
    arguments << QStringLiteral("-bitexact") << parts.more << QStringLiteral("-f") << parts.container
              << QFile::decodeName(file.c_str());
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(QStringLiteral("ffmpeg"), arguments);
    return process.waitForFinished(-1) && process.exitStatus() == QProcess::NormalExit &&
           process.exitCode() == 0;
}

/// Makes a video say that its pictures are upright when they are turned clockwise by a quarter, as that of a telephone held
/// upright does: the matrix in its track's header, 16.16 fixed. False where it has no such header.
inline bool turn_video(const std::filesystem::path& file, int width) {
    QFile video(QFile::decodeName(file.c_str()));
    if (!video.open(QIODevice::ReadWrite))
        return false;
    const qsizetype header = video.readAll().indexOf("tkhd");
    constexpr qsizetype matrix = 44; // behind the header's name
    QByteArray numbers;
    for (const int number : {0, 1 << 16, 0, -(1 << 16), 0, 0, width << 16, 0, 1 << 30})
        for (int byte = 3; byte >= 0; --byte)
            numbers.append(static_cast<char>(number >> (8 * byte) & 0xFF));
    return header >= 0 && video.seek(header + matrix) && video.write(numbers) == numbers.size();
}

/// A JPEG of 1 × 1 pixel that says this XMP of itself and has these bytes behind it.
inline std::string made_motion_photo(const std::string& properties, const std::string& behind) {
    const std::string xmp =
        "http://ns.adobe.com/xap/1.0/" + std::string(1, '\0') +
        "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
        "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"><rdf:Description rdf:about=\"\" "
        "xmlns:GCamera=\"http://ns.google.com/photos/1.0/camera/\" "
        "xmlns:Container=\"http://ns.google.com/photos/1.0/container/\" "
        "xmlns:Item=\"http://ns.google.com/photos/1.0/container/item/\" " +
        properties + "</rdf:Description></rdf:RDF></x:xmpmeta>";
    std::string bytes("\xFF\xD8\xFF\xE1", 4);
    bytes += static_cast<char>((xmp.size() + 2) >> 8);
    bytes += static_cast<char>((xmp.size() + 2) & 0xFF);
    bytes += xmp;
    bytes += std::string("\xFF\xC0\x00\x0B\x08\x00\x01\x00\x01\x01\x01\x11\x00\xFF\xD9", 15);
    return bytes + behind;
}

/// The attributes and the list by which Google's format 1.0 says how long what lies behind the picture is.
inline std::string motion_photo_1(std::size_t video_bytes) {
    return "GCamera:MotionPhoto=\"1\" GCamera:MotionPhotoVersion=\"1\"><Container:Directory><rdf:Seq>"
           "<rdf:li rdf:parseType=\"Resource\"><Container:Item Item:Mime=\"image/jpeg\" "
           "Item:Semantic=\"Primary\" "
           "Item:Length=\"0\" Item:Padding=\"0\"/></rdf:li>"
           "<rdf:li rdf:parseType=\"Resource\"><Container:Item Item:Mime=\"video/mp4\" "
           "Item:Semantic=\"MotionPhoto\" "
           "Item:Length=\"" +
           std::to_string(video_bytes) + "\" Item:Padding=\"0\"/></rdf:li></rdf:Seq></Container:Directory>";
}

/// The older way: where the video begins, from the end.
inline std::string micro_video(std::size_t from_end) {
    return "GCamera:MicroVideo=\"1\" GCamera:MicroVideoVersion=\"1\" GCamera:MicroVideoOffset=\"" +
           std::to_string(from_end) + "\">";
}

/// What Samsung's cameras put behind the picture: a block with the video, and the list that leads to it.
inline std::string samsung_end(const std::string& video) {
    const auto number = [](std::size_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i)
            text += static_cast<char>(value >> (8 * i) & 0xFF);
        return text;
    };
    const std::string name = "MotionPhoto_Data";
    const std::string block = number(0, 2) + number(0x0A30, 2) + number(name.size(), 4) + name + video;
    const std::string list = "SEFH" + number(106, 4) + number(1, 4) + number(0, 2) + number(0x0A30, 2) +
                             number(block.size(), 4) + number(block.size(), 4);
    return block + list + number(list.size(), 4) + "SEFT";
}

} // namespace tp::test
