// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/index/album_scan.hpp"
#include "app/album/index/folder_listing.hpp"
#include "synthetic_album.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <filesystem>
#include <string>

namespace tp::testing {

/// An album and a cache in a folder of their own.
class TestAlbum {
public:
    TestAlbum() {
        fs::create_directory(root());
        tools.read_record = [](const fs::path& photo) { return read_synthetic(photo); };
        tools.read_recording = [](const fs::path& recording) -> Result<Tag> {
            Tag tag;
            tag.file = recording.filename().string();
            tag.label.transcript = file_bytes(recording);
            return tag;
        };
    }

    ~TestAlbum() { // QTemporaryDir does not remove names that are no UTF-8
        std::error_code none;
        fs::remove_all(root(), none);
    }
    TestAlbum(const TestAlbum&) = delete;
    TestAlbum& operator=(const TestAlbum&) = delete;

    fs::path top() const { return fs::canonical(dir_.path().toStdString()); }
    fs::path root() const { return fs::path(dir_.path().toStdString()) / "album"; }
    fs::path cache() const { return fs::path(dir_.path().toStdString()) / "cache"; }

    /// A photograph with that content and, where there are any, names of people in its sidecar.
    fs::path add(const std::string& name, const std::string& content,
                 const std::vector<std::string>& people = {}) {
        const fs::path photo = root() / name;
        fs::create_directories(photo.parent_path());
        write_file(photo, jpeg_bytes(content));
        if (!people.empty())
            set_people(photo, people);
        return photo;
    }
    static void set_people(const fs::path& photo, const std::vector<std::string>& people) {
        PhotoRecord record;
        record.persons = people;
        fs::path sidecar = photo;
        sidecar += ".xmp";
        write_file(sidecar, sidecar_text(record));
    }

    Result<ScanReport> scan(AlbumIndex& index) { return scan_album(index, {root()}, tools); }

    /// Waits until no file is so new that a scan would read it again: some ticks of the system's clock.
    bool settles() const {
        return QTest::qWaitFor([&] {
            std::vector<fs::path> folders{root()};
            while (!folders.empty()) {
                const FolderListing listing = list_folder(folders.back());
                folders.pop_back();
                for (const ListedPhoto& photo : listing.photos)
                    if (photo.stamp.empty() || photo.beside.empty())
                        return false;
                for (const ListedFolder& folder : listing.folders)
                    folders.push_back(folder.path);
            }
            return true;
        });
    }

    /// The dump of an index that is made from nothing.
    std::string fresh_dump() {
        auto index = AlbumIndex::in_memory();
        if (const auto report = scan(*index); !report)
            return "error: " + report.error();
        return index->dump().value();
    }

    ScanTools tools;

private:
    QTemporaryDir dir_;
};

/// What SQLite and its full-text index find wrong with themselves; empty: nothing.
inline std::string faults_of(AlbumIndex& index) {
    try {
        std::string faults;
        SqlRun check = index.connection().run("PRAGMA integrity_check");
        while (check.next())
            faults += check.text(0) == "ok" ? "" : check.text(0) + "\n";
        SqlRun keys = index.connection().run("PRAGMA foreign_key_check");
        while (keys.next())
            faults += "foreign key of " + keys.text(0) + "\n";
        index.connection().run_once("INSERT INTO words(words) VALUES('integrity-check')");
        return faults;
    } catch (const SqlFault& fault) {
        return fault.text;
    }
}

/// Forgets every photograph that is missing, as one whose move was followed.
inline bool forgets_missing(AlbumIndex& index) {
    const auto missing = index.missing();
    return missing.ok() && std::ranges::all_of(missing.value(), [&](const std::filesystem::path& gone) {
               return index.forget(gone).empty();
           });
}

} // namespace tp::testing
