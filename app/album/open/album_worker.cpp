// SPDX-License-Identifier: Apache-2.0
#include "app/album/open/album_worker.hpp"

#include "app/album/keeper/follow_moves.hpp"
#include "app/album/keeper/recording_facts.hpp"
#include "app/album/metadata/read_record.hpp"
#include "app/album/open/lies_in.hpp"
#include "audio/sentences/sentences.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <system_error>
#include <utility>

namespace tp {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

namespace {
constexpr std::chrono::milliseconds progress_every{100};
constexpr std::chrono::seconds grown_every{2};

void take(std::vector<std::string>& problems, std::vector<std::string> more) {
    problems.insert(problems.end(), std::make_move_iterator(more.begin()),
                    std::make_move_iterator(more.end()));
}
} // namespace

AlbumWorker::AlbumWorker(const AlbumIndex& index, AlbumWatcher::Times times)
    : shared_(index), times_(times) {}

void AlbumWorker::work(const AlbumTask& task, const std::stop_token& stop) {
    AlbumTaskReport report;
    if (open())
        scan(task, stop, report);
    emit done(report);
}

bool AlbumWorker::open() {
    if (index_)
        return true;
    Result<AlbumIndex> index = shared_.another();
    if (!index) {
        emit said(in_persons_language(index.error()));
        return false;
    }
    index_ = std::make_unique<AlbumIndex>(std::move(*index));
    watcher_ = std::make_unique<AlbumWatcher>(times_);
    connect(watcher_.get(), &AlbumWatcher::changed, this, &AlbumWorker::heed);
    connect(watcher_.get(), &AlbumWatcher::limited, this,
            [this](const std::string& sentence) { emit said(in_persons_language(sentence)); });
    return true;
}

void AlbumWorker::scan(const AlbumTask& task, const std::stop_token& stop, AlbumTaskReport& report) {
    if (task.whole)
        chosen_ = task.folders;
    watch();
    ScanTools tools;
    tools.read_record = read_record;
    tools.read_recording = recording_facts;
    tools.stop = stop;
    auto told = steady_clock::now() - progress_every, grown = steady_clock::now();
    tools.progress = [&](const ScanProgress& now) {
        const auto time = steady_clock::now();
        if (time - told < progress_every && now.done < now.total)
            return;
        told = time;
        const bool more = time - grown >= grown_every;
        if (more)
            grown = time;
        emit progress(now.done, now.total, now.left ? now.left->count() : -1, more);
    };
    Result<ScanReport> scanned =
        task.whole ? scan_album(*index_, task.folders, tools) : rescan_folders(*index_, task.folders, tools);
    if (!scanned) {
        report.problems.push_back(scanned.error());
        return;
    }
    report.changed = scanned->read > 0 || scanned->missing > 0;
    report.stopped = scanned->stopped;
    take(report.problems, std::move(scanned->problems));
    if (!report.stopped && (task.whole || !scanned->moves.empty())) // also what a kill left half-way
        follow(tools, report);
    watch();
}

/// What belongs to moved photographs goes along, and the index learns where it is now.
void AlbumWorker::follow(const ScanTools& tools, AlbumTaskReport& report) {
    Result<FollowedMoves> moves = follow_moves(*index_, {{}, tools.stop});
    if (!moves) {
        report.problems.push_back(moves.error());
        return;
    }
    take(report.problems, std::move(moves->problems));
    report.stopped = moves->stopped;
    std::vector<fs::path> folders;
    for (const Move& move : moves->followed)
        folders.push_back(move.to.parent_path());
    if (folders.empty())
        return;
    Result<ScanReport> again = rescan_folders(*index_, folders, tools);
    if (!again) {
        report.problems.push_back(again.error());
        return;
    }
    take(report.problems, std::move(again->problems));
    report.stopped = report.stopped || again->stopped;
}

/// Before a scan and after it, so that nothing falls between the two.
void AlbumWorker::watch() {
    const Result<std::vector<fs::path>> known = index_->folders();
    if (!known)
        return; // the scan tells
    absent_ = absent_now();
    around_.clear();
    for (fs::path folder : absent_) {
        std::error_code error;
        while (folder.has_relative_path() && !fs::is_directory(folder, error))
            folder = folder.parent_path();
        around_.insert(std::move(folder));
    }
    std::set<fs::path> folders = around_;
    folders.insert(known->begin(), known->end());
    folders.insert(chosen_.begin(), chosen_.end());
    std::erase_if(folders, [this](const fs::path& folder) { return is_absent(folder); });
    watcher_->set_folders({folders.begin(), folders.end()});
}

void AlbumWorker::heed(const std::vector<fs::path>& folders) {
    if (absent_now() != absent_) { // the whole album tells more than some of its folders
        emit folders_came_or_went();
        return;
    }
    std::vector<fs::path> ours;
    for (const fs::path& folder : folders)
        if (!is_absent(folder) && !around_.contains(folder))
            ours.push_back(folder);
    if (!ours.empty())
        emit changed(ours);
}

std::set<fs::path> AlbumWorker::absent_now() const {
    std::set<fs::path> absent;
    std::error_code error;
    for (const fs::path& folder : chosen_)
        if (!fs::is_directory(folder, error))
            absent.insert(folder);
    return absent;
}

bool AlbumWorker::is_absent(const fs::path& folder) const {
    return std::any_of(absent_.begin(), absent_.end(),
                       [&](const fs::path& gone) { return lies_in(folder, gone); });
}

} // namespace tp
