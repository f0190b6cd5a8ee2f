// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/index/album_index.hpp"
#include "app/album/index/seen_photos.hpp"
#include "app/photo/sight/photo_look.hpp"

#include <QLocale>
#include <QObject>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace tp {

/// What is asked of the worker: one photograph.
struct LookTask {
    std::filesystem::path wanted;      ///< empty: the newest before `before`
    std::optional<PlaceInList> before; ///< none: of all
    QLocale::Language language = QLocale::English;
    Marks marks = Marks::no; ///< whether faces are to be known again
    std::stop_token stop;
};

/// What became of it.
struct LookReport {
    std::filesystem::path photo; ///< empty: there was nothing to do
    std::optional<PlaceInList> place;
};

/// Looks at the photographs of an index, one by one, and puts what it saw in words for the search. All on one thread.
class LookWorker final : public QObject {
    Q_OBJECT
public:
    /// Opens `index`, which must outlive this, once more at the first task.
    LookWorker(const AlbumIndex& index, std::function<Look()> make_look)
        : shared_(index), make_look_(std::move(make_look)) {}

    LookReport work(const LookTask& task);
    /// Gives back the nets; they are made again when they are needed.
    void rest() { look_ = {}; }

private:
    Result<std::optional<PhotoToWord>> choose(SeenPhotos& seen, const LookTask& task,
                                              const std::string& worded);

    const AlbumIndex& shared_;
    std::function<Look()> make_look_;
    std::unique_ptr<AlbumIndex> index_;
    Look look_;
};

} // namespace tp
