// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/open/open_album.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QColor>
#include <QImage>
#include <QTest>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tp::testing {

/// An album of small drawn photographs in a folder of its own, and the program's side of it.
struct DrawnAlbum {
    AlbumFolder folder;
    Preferences preferences;
    std::unique_ptr<OpenAlbum> album;

    DrawnAlbum() {
        std::filesystem::create_directory(root());
        preferences.change(
            [this](Choices& choices) { choices.folders << QString::fromStdString(root().string()); });
    }

    std::filesystem::path root() const { return std::filesystem::canonical(folder.path()) / "album"; }

    /// A photograph with the time it was taken and, where one is given, the place.
    std::filesystem::path photo(const std::string& name, const std::string& taken,
                                const std::string& city = {}) const {
        const std::filesystem::path file = root() / name;
        std::filesystem::create_directories(file.parent_path());
        QImage image(60, 40, QImage::Format_RGB32);
        image.fill(QColor::fromHsv(static_cast<int>(std::hash<std::string>()(name) % 360), 120, 200));
        if (!image.save(QString::fromStdString(file.string())))
            qFatal("cannot write %s", file.c_str());
        std::string sidecar =
            R"(<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about="" xmlns:exif="http://ns.adobe.com/exif/1.0/" xmlns:photoshop="http://ns.adobe.com/photoshop/1.0/" exif:DateTimeOriginal=")" +
            taken + "\"";
        if (!city.empty())
            sidecar += " photoshop:City=\"" + city + "\"";
        folder.write("album/" + name + ".xmp", sidecar + "/></rdf:RDF></x:xmpmeta>");
        return file;
    }
    /// Somebody's face on it.
    void name(const std::filesystem::path& photo, const std::string& person, double x) const {
        if (const std::string why = AlbumKeeper(root()).name_face(photo, {x, 0.5, 0.2, 0.3, person});
            !why.empty())
            qFatal("%s", why.c_str());
    }
    /// A FLAC of a tone among its recordings.
    void record(const std::filesystem::path& photo, RecordingKind kind, const std::string& speaker,
                double seconds, double hertz) const {
        const auto sound = a_sound(folder, "sounds/tone.wav", seconds, hertz);
        RecordingLabel label;
        label.kind = kind;
        label.speaker = speaker;
        if (const auto added = AlbumKeeper(root()).add_recording(photo, sound, label); !added)
            qFatal("%s", added.error().c_str());
    }

    /// Five photographs: Anna and Tom in May with two recordings, Ben and Anna with one, and three without
    /// people.
    struct Five {
        std::filesystem::path garden, walk, sea, cat, tower;
    };
    Five five() const {
        Five all;
        all.garden = photo("garden.jpg", "2026-05-01T10:15:00", "Vienna");
        name(all.garden, "Anna", 0.3);
        name(all.garden, "Tom", 0.7);
        record(all.garden, RecordingKind::story, "Ben", 1.0, 440.0);
        record(all.garden, RecordingKind::memo, "Tom", 0.5, 300.0);
        all.walk = photo("walk.png", "2026-06-02T09:00:00");
        name(all.walk, "Anna", 0.3);
        name(all.walk, "Ben", 0.7);
        record(all.walk, RecordingKind::memo, "Anna", 0.5, 600.0);
        all.sea = photo("sea.jpg", "2025-07-03T12:00:00", "Trieste");
        all.cat = photo("cat.jpg", "2025-08-04T12:00:00");
        all.tower = photo("tower.jpg", "2024-02-05T12:00:00", "Vienna");
        return all;
    }

    /// As at a start of the program, and its first scan is over.
    void open() {
        album = std::make_unique<OpenAlbum>(
            folder / "cache", preferences,
            AlbumWatcher::Times{std::chrono::milliseconds(0), std::chrono::hours(1)});
        if (!scanned())
            qFatal("the scan does not end");
    }
    bool scanned() const {
        return QTest::qWaitFor([this] { return !album->scanning(); }, 60'000);
    }
};

} // namespace tp::testing
