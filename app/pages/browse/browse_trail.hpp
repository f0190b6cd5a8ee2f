// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/metadata/photo_record.hpp"
#include "app/pages/browse/browse_album.hpp"
#include "app/pages/browse/browse_teller.hpp"
#include "app/pages/browse/photo_trail.hpp"
#include "app/pages/browse/photo_words.hpp"
#include "app/pages/browse/tag_playback.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "core/base/result.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Where in the album one is, and the ways from photograph to photograph.
///
/// A person is on one of several levels: all photographs; a list of names, years, places or keywords, or the
/// search; and the photographs that were chosen there. What is shown is the photograph of the last level that
/// has some.
class BrowseTrail final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    Q_PROPERTY(View view READ view NOTIFY levelChanged)
    Q_PROPERTY(QString title READ title NOTIFY levelChanged)
    Q_PROPERTY(QString photo READ photo NOTIFY photoChanged)
    Q_PROPERTY(QString placeText READ placeText NOTIFY photoChanged)
public:
    enum class View { Photos, Names, Search };
    Q_ENUM(View)

    struct Level {
        View view = View::Photos;
        QString title;
        std::optional<PhotoTrail> trail; ///< of photographs
        std::string kind;                ///< of names: "person", "year", "place", "keyword"
        QString typed;                   ///< of a search
        int chosen_row = -1;
    };

    /// All must outlive this.
    BrowseTrail(BrowseAlbum& album, BrowseTeller& teller, TagPlayback& tags, Preferences& preferences);

    View view() const { return level().view; }
    QString title() const { return level().title; }
    QString photo() const;
    QString placeText() const;
    int position() const { return static_cast<int>(trail().position()); }
    int count() const { return static_cast<int>(trail().count()); }

    Q_INVOKABLE void next() { step(true); }
    Q_INVOKABLE void previous() { step(false); }
    Q_INVOKABLE void first();
    Q_INVOKABLE void last();
    Q_INVOKABLE void surprise();
    /// Shows and tells this photograph among all; false where the album does not have it.
    Q_INVOKABLE bool show(const QString& photo);

    /// The page is shown: from now on what happens is told. The texts may be in another language than before.
    void enter();
    void leave() { active_ = false; }
    /// Goes by what the album has now.
    void look_at_album();
    /// What is on this photograph was looked at.
    void looked_at(const std::filesystem::path& photo);

    /// A photograph is shown, and the level has photographs.
    bool ready() const { return album_.ready(); }
    /// The same, and where not, refuses.
    bool ready_or_refuse();
    /// The photograph that is shown, what the index knows of it, and those that may come next.
    const std::optional<PhotoEntry>& here() const { return trail().here(); }
    const std::filesystem::path& shown() const { return shown_; }
    const PhotoRecord& record() const { return record_; }
    const std::optional<SeenPhoto>& seen() const { return seen_; }
    PhotoWords words() const;
    std::vector<std::filesystem::path> ahead(bool backwards) const { return trail().ahead(backwards); }

    Level& level() { return levels_.back(); }
    const Level& level() const { return levels_.back(); }
    bool at_the_top() const { return levels_.size() == 1; }
    void to_the_top() { levels_.resize(1); }
    /// One level down, or up. Whoever goes says so: emits levelChanged when all is in its place.
    void go_down(Level level) { levels_.push_back(std::move(level)); }
    void go_up() { levels_.pop_back(); }
    /// Goes there on this level; false, and told, where the index cannot be read.
    bool go_to(const PhotoEntry& photo);
    /// Shows the photograph that one is at. `backwards`: one came from the one behind it.
    void show_here(bool backwards = false);

signals:
    void levelChanged();
    void photoChanged();
    /// The photograph is another, or what is known of it may be; before photoChanged.
    void shown_anew(bool another, bool backwards);
    /// One has come to a photograph: it is to be told.
    void arrived(tp::Priority priority);
    /// What is on the photograph that is shown is known now, and was not when one came to it.
    void seen_now();
    /// The photograph of that name is gone from the list, and another is shown.
    void lost(const QString& name);
    /// The index has changed; lists follow.
    void album_changed();

private:
    PhotoTrail& trail();
    const PhotoTrail& trail() const;
    void begin();
    void read_record();
    void set_state();
    void step(bool forward);
    void jump(const Result<bool>& moved);

    BrowseAlbum& album_;
    BrowseTeller& teller_;
    TagPlayback& tags_;
    Preferences& preferences_;
    std::vector<Level> levels_; ///< never empty; the first has all photographs
    bool active_ = false;       ///< the page is shown
    bool begun_ = false;        ///< one is where one was when the program ended, or has gone on from there
    std::filesystem::path shown_;
    std::string sha256_; ///< of that photograph
    PhotoRecord record_;
    std::optional<SeenPhoto> seen_;
};

} // namespace tp
