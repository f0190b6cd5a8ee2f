// SPDX-License-Identifier: Apache-2.0
#include "app/album/looking/look_worker.hpp"

#include "app/album/open/polite_thread.hpp"
#include "app/photo/words/description.hpp"

#include <string>
#include <system_error>
#include <utility>

namespace tp {

namespace {

constexpr int words_version = 1; ///< larger whenever descriptions are put in other words

/// A photograph that is worded so is done with.
std::string wording(const LookTask& task) {
    return QLocale::languageToCode(task.language).toStdString() + " " + std::to_string(look_version) + "." +
           std::to_string(words_version) + (task.marks == Marks::yes ? " marked" : "");
}

} // namespace

LookReport LookWorker::work(const LookTask& task) {
    if (!index_) {
        make_thread_polite();
        Result<AlbumIndex> index = shared_.another();
        if (!index)
            return {}; // whoever scans tells
        index_ = std::make_unique<AlbumIndex>(std::move(*index));
    }
    SeenPhotos photos(*index_, look_version, task.marks == Marks::yes);
    const std::string worded = wording(task);
    const Result<std::optional<PhotoToWord>> chosen = choose(photos, task, worded);
    if (!chosen || !*chosen)
        return {};
    PhotoSummary photo = (*chosen)->summary;
    if ((*chosen)->to_look) {
        if (!look_)
            look_ = make_look_();
        if (!photos.begin(photo.sha256).empty())
            return {};
        Looked looked = look_(photo.entry.path, task.marks, task.stop);
        std::error_code error;
        const bool gone = looked.seen.width == 0 &&
                          !std::filesystem::exists(photo.entry.path, error); // a stick was pulled out
        if (task.stop.stop_requested() || gone) {
            photos.forget(photo.sha256);
            return {};
        }
        if (!photos.put(photo.sha256, looked).empty())
            return {};
        photo.seen = std::move(looked.seen);
    }
    const PhotoView view = view_of(photo.seen, photo.record, task.language);
    const bool seen = view.seen;
    const std::string words = seen ? full_description(view, task.language).toStdString() : std::string();
    if (!photos.put_words(photo.entry.id, worded, words).empty())
        return {};
    return {photo.entry.path, photo.entry.place};
}

Result<std::optional<PhotoToWord>> LookWorker::choose(SeenPhotos& seen, const LookTask& task,
                                                      const std::string& worded) {
    if (task.wanted.empty())
        return seen.next(worded, task.before);
    const auto entry = AlbumQueries(*index_).find(task.wanted);
    if (!entry)
        return Error{entry.error()};
    return *entry ? seen.of((*entry)->id, worded) : std::optional<PhotoToWord>();
}

} // namespace tp
