// SPDX-License-Identifier: Apache-2.0
#include "app/cli/album/album_index_words.hpp"

#include "app/album/keeper/recording_facts.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/cli/batch_progress.hpp"
#include "core/files/file_words.hpp"

#include <QCryptographicHash>
#include <QStandardPaths>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace tp {

namespace fs = std::filesystem;

VerbLine& add_index_options(VerbLine& line) {
    return line.option("cache", "Where the index lies; may be thrown away at any time.", "DIR");
}

fs::path cache_of(const VerbLine& line, const std::vector<fs::path>& folders) {
    if (line.has("cache"))
        return path_given(line.text("cache"));
    std::vector<std::string> names;
    for (const fs::path& folder : folders)
        names.push_back(folder.string());
    std::sort(names.begin(), names.end());
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const std::string& name : names)
        hash.addData(QByteArrayView(name.c_str(), static_cast<qsizetype>(name.size()) + 1)); // with its end
    const QString home = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    return fs::path(home.toStdString()) / "touchphoto" / hash.result().toHex().left(16).toStdString();
}

Result<AlbumIndex> open_index(const VerbLine& line, const std::vector<fs::path>& folders) {
    auto index = AlbumIndex::open(cache_of(line, folders));
    if (index)
        for (const std::string& notice : index->notices())
            say(notice);
    return index;
}

namespace {

/// `scan` with the readers, telling once a second how far it is.
template <typename Scan>
Result<ScanReport> told(StopOnSignal& stop, Scan scan) {
    ScanTools tools;
    tools.read_record = read_record;
    tools.read_recording = recording_facts;
    tools.stop = stop.token();
    auto said = std::chrono::steady_clock::now();
    tools.progress = [&](const ScanProgress& progress) {
        stop.look();
        const auto now = std::chrono::steady_clock::now();
        if (now - said < std::chrono::seconds(1))
            return;
        said = now;
        std::string line = std::to_string(progress.done) + " of " + std::to_string(progress.total) + ": " +
                           readable(progress.photo.filename().string());
        if (progress.left)
            line += ", about " + std::to_string(progress.left->count() / 1000 + 1) + " s left";
        say(line);
    };
    return scan(tools);
}

} // namespace

Result<ScanReport> scan_with_progress(AlbumIndex& index, const std::vector<fs::path>& folders,
                                      StopOnSignal& stop) {
    return told(stop, [&](const ScanTools& tools) { return scan_album(index, folders, tools); });
}

Result<ScanReport> rescan_with_progress(AlbumIndex& index, const std::vector<fs::path>& folders,
                                        StopOnSignal& stop) {
    return told(stop, [&](const ScanTools& tools) { return rescan_folders(index, folders, tools); });
}

Result<AlbumIndex> scanned_index(const VerbLine& line, const std::vector<fs::path>& folders,
                                 StopOnSignal& stop) {
    auto index = open_index(line, folders);
    if (!index)
        return index;
    const auto report = scan_with_progress(*index, folders, stop);
    return report ? std::move(index) : Result<AlbumIndex>(Error{report.error()});
}

Result<AlbumIndex> filled_index(const VerbLine& line, const std::vector<fs::path>& folders) {
    auto index = open_index(line, folders);
    if (!index)
        return index;
    const auto totals = index->totals();
    if (!totals)
        return Error{totals.error()};
    if (totals->photos > 0)
        return index;
    StopOnSignal stop;
    const auto report = scan_with_progress(*index, folders, stop);
    return report ? std::move(index) : Result<AlbumIndex>(Error{report.error()});
}

} // namespace tp
