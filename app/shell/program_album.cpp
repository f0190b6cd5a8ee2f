// SPDX-License-Identifier: Apache-2.0
// The album that pages share, and who works on it beside them.
#include "app/album/index/album_news.hpp"
#include "app/shell/program.hpp"
#include "core/files/file_name.hpp"

#include <QByteArray>
#include <QDir>
#include <QStandardPaths>

#include <optional>

namespace tp {

OpenAlbum& Program::album() {
    if (!album_) {
        album_ = std::make_unique<OpenAlbum>(parts_.cache, preferences_);
        connect(album_.get(), &OpenAlbum::said, this,
                [this](const QString& sentence) { narrator_.tell(sentence, Priority::message); });
        connect(album_.get(), &OpenAlbum::album_changed, this, [this] {
            if (explore_ && explore_->device()->here())
                explore_->walk()->album_changed();
        });
        connect(album_.get(), &OpenAlbum::scanning_changed, this, [this] {
            if (!album_->scanning())
                voice_names_.read();
            know_news();
        });
        looks_ = std::make_unique<AlbumLooks>(*album_);
        album_faces_ = std::make_unique<AlbumFaces>(*album_);
        connect(looks_.get(), &AlbumLooks::looked, this, [this](const std::filesystem::path& photo) {
            album_faces_->go_on();
            know_news();
            show_looked(photo);
        });
        connect(looks_.get(), &AlbumLooks::rested, this, &Program::know_news);
        look_as_chosen();
    }
    return *album_;
}

/// Of the person's album; whoever has none gets one among their pictures.
std::filesystem::path Program::folder_for_photographs() {
    if (!album().has_folders())
        preferences_.change([](Choices& choices) {
            const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
            choices.folders = {pictures + "/TouchPhoto"};
            QDir().mkpath(choices.folders.front());
        });
    if (album().has_folders())
        return album().folders().front();
    return path_named(preferences_.choices().folders.front().toStdString());
}

/// As ExploreSettings::Beside says.
QString Program::beside(const QString& file, bool forward) {
    if (preferences_.choices().folders.isEmpty())
        return {};
    AlbumQueries queries = album().queries();
    const Direction direction = forward ? Direction::forward : Direction::backward;
    std::optional<PlaceInList> from;
    if (const auto here = queries.find(path_named(file.toStdString())); here && *here)
        from = (*here)->place;
    for (;;) {
        const auto next = queries.page(AllByTime{}, from, 1, direction);
        if (!next || next->empty())
            return {};
        const std::string name = name_in_utf8(next->front().path);
        if (const QString text = QString::fromStdString(name); text.toStdString() == name)
            return text;
        from = next->front().place; // its name is no text: it cannot be asked for
    }
}

AlbumFaces& Program::album_faces() {
    album();
    return *album_faces_;
}

/// Who wants neither descriptions nor names offered has nobody look through the album.
void Program::look_as_chosen() {
    if (!looks_)
        return;
    looks_->set_language(QLocale(languages_.current()).language());
    const bool know_faces = preferences_.choices().know_faces;
    looks_->set_on(know_faces || preferences_.choices().descriptions != Choices::Descriptions::none);
    looks_->set_marks(know_faces ? Marks::yes : Marks::no);
    album_faces_->set_on(know_faces);
}

/// To be told on the start page, which an album that is still read has not got yet.
void Program::know_news() {
    if (album_->scanning())
        return;
    if (const auto news = AlbumNews(album_->index()).news())
        start_.know(*news, looks_->looking());
}

/// Who goes to the photographs finds the new ones there.
void Program::news_told() {
    AlbumNews(album().index()).told();
    start_.know({}, false);
}

} // namespace tp
