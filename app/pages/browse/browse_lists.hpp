// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/browse/browse_album.hpp"
#include "app/pages/browse/browse_details.hpp"
#include "app/pages/browse/browse_teller.hpp"
#include "app/pages/browse/browse_trail.hpp"
#include "app/pages/browse/tag_playback.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace tp {

/// The lists of names, years, places and keywords, and the search: their rows, and the ways down to what they
/// name and up again.
class BrowseLists final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the session.")

    /// {text, detail} each.
    Q_PROPERTY(QVariantList rows READ rows NOTIFY rowsChanged)
    /// The row that was chosen last, for coming back; −1: none.
    Q_PROPERTY(int chosenRow READ chosenRow NOTIFY rowsChanged)
    Q_PROPERTY(QString typed READ typed NOTIFY rowsChanged)
    /// With which letters what is found goes on after `typed`, for who spells by touch.
    Q_PROPERTY(QStringList letters READ letters NOTIFY rowsChanged)
    /// How many of what is in the list; empty: nothing to say.
    Q_PROPERTY(QString found READ found NOTIFY rowsChanged)
public:
    enum class Topic { People, Years, Places, Keywords };
    Q_ENUM(Topic)

    /// All must outlive this.
    BrowseLists(BrowseAlbum& album, BrowseTrail& trail, BrowseDetails& details, BrowseTeller& teller,
                TagPlayback& tags);

    const QVariantList& rows() const { return rows_; }
    int chosenRow() const { return trail_.level().chosen_row; }
    QString typed() const { return trail_.level().typed; }
    const QStringList& letters() const { return letters_; }
    const QString& found() const { return found_; }

    Q_INVOKABLE void allPhotos();
    Q_INVOKABLE void openTopic(Topic topic);
    Q_INVOKABLE void openSearch();
    /// One level up.
    Q_INVOKABLE void back();

    /// The keyboard is on this row.
    Q_INVOKABLE void reach(int row);
    Q_INVOKABLE void choose(int row);

    /// Words are being typed: the rows follow.
    Q_INVOKABLE void type(const QString& words);
    /// Says how much was found.
    Q_INVOKABLE void tellFound();
    /// A finger or the keyboard is on this letter of `letters`.
    Q_INVOKABLE void reachLetter(int letter);
    /// Types it, and says what that finds.
    Q_INVOKABLE void addLetter(int letter);
    /// Takes the last letter away, and says what is left.
    Q_INVOKABLE void takeLetterBack();

    /// The page is shown again, or the album has changed: the rows follow.
    void refresh();
    /// Says what the list is and how much is in it.
    void tell();

signals:
    void rowsChanged();

private:
    /// What a row leads to.
    struct More {};
    using Choice = std::variant<TopicEntry, int, PhotoEntry, More>;
    using View = BrowseTrail::View;

    void open_list(BrowseTrail::Level level);
    void open_photos(const QString& title, PhotoTrail trail, const std::optional<PhotoEntry>& at);
    void enter_level();
    void fill();
    void list_years();
    void list_names();
    void list_matches();
    void spell(const QString& words);
    void add_row(const QString& text, const QString& detail, Choice choice);
    QString words() const;

    BrowseAlbum& album_;
    BrowseTrail& trail_;
    BrowseDetails& details_;
    BrowseTeller& teller_;
    TagPlayback& tags_;
    QVariantList rows_;
    std::vector<Choice> choices_; ///< one a row
    QString found_;
    QStringList letters_;
    std::size_t most_rows_ = 0;
};

} // namespace tp
