// SPDX-License-Identifier: Apache-2.0
#include "app/cli/album/album_index_words.hpp"

#include "app/album/keeper/recording_facts.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/cli/long_work.hpp"
#include "core/files/file_name.hpp"
#include "core/files/file_words.hpp"

#include <QCryptographicHash>
#include <QStandardPaths>

#include <algorithm>

namespace tp {

namespace fs = std::filesystem;

VerbLine& add_index_options(VerbLine& line) {
    return line.option("cache", "Where the index is kept; it can be deleted at any time.", "DIR");
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
    return path_named(home.toStdString()) / "touchphoto" / hash.result().toHex().left(16).toStdString();
}

Result<AlbumIndex> open_index(const VerbLine& line, const std::vector<fs::path>& folders) {
    auto index = AlbumIndex::open(cache_of(line, folders));
    if (index)
        for (const std::string& notice : index->notices())
            say(notice);
    return index;
}

namespace {

/// `scan` with the readers, telling how far it is.
template <typename Scan>
Result<ScanReport> told(Scan scan) {
    LongWork::step("looking through the folders");
    ScanTools tools;
    tools.read_record = read_record;
    tools.read_recording = recording_facts;
    tools.stop = LongWork::stop_token();
    tools.progress = [](const ScanProgress& progress) {
        LongWork::item(readable(progress.photo.filename().string()), progress.done, progress.total);
    };
    auto report = scan(tools);
    LongWork::step("finishing the index");
    return report;
}

/// The index, unless the scan came to an error or was stopped.
Result<AlbumIndex> index_after(Result<AlbumIndex> index, const std::vector<fs::path>& folders) {
    const auto report = scan_with_progress(*index, folders);
    if (!report)
        return Error{report.error()};
    if (report->stopped)
        return Error{"The scan was stopped before its end; \"album scan\" continues it."};
    return index;
}

} // namespace

Result<ScanReport> scan_with_progress(AlbumIndex& index, const std::vector<fs::path>& folders) {
    return told([&](const ScanTools& tools) { return scan_album(index, folders, tools); });
}

Result<ScanReport> rescan_with_progress(AlbumIndex& index, const std::vector<fs::path>& folders) {
    return told([&](const ScanTools& tools) { return rescan_folders(index, folders, tools); });
}

Result<AlbumIndex> scanned_index(const VerbLine& line, const std::vector<fs::path>& folders) {
    auto index = open_index(line, folders);
    return index ? index_after(std::move(index), folders) : std::move(index);
}

Result<AlbumIndex> filled_index(const VerbLine& line, const std::vector<fs::path>& folders) {
    auto index = open_index(line, folders);
    if (!index)
        return index;
    const auto totals = index->totals();
    if (!totals)
        return Error{totals.error()};
    return totals->photos > 0 ? std::move(index) : index_after(std::move(index), folders);
}

} // namespace tp
