// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/open/open_album.hpp"
#include "app/pages/browse/photo_trail.hpp"
#include "app/pages/browse/photo_words.hpp"
#include "app/pages/browse/tag_playback.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "app/photo/picture/picture_ahead.hpp"
#include "audio/sound/earcon_player.hpp"
#include "audio/sound/player.hpp"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tp {

/// The album, one photograph at a time: everything that the browse page decides. The page only binds and
/// draws.
///
/// A person is on one of several levels: all photographs; a list of names, years, places or keywords, or the
/// search; and the photographs that were chosen there. `back` goes one level up.
class BrowseSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(View view READ view NOTIFY levelChanged)
    Q_PROPERTY(QString title READ title NOTIFY levelChanged)
    /// Rows of a list, {text, detail} each.
    Q_PROPERTY(QVariantList rows READ rows NOTIFY rowsChanged)
    /// The row that was chosen last, for coming back; −1: none.
    Q_PROPERTY(int chosenRow READ chosenRow NOTIFY rowsChanged)
    Q_PROPERTY(QString typed READ typed NOTIFY rowsChanged)
    /// With which letters what is found goes on after `typed`, for who spells by touch.
    Q_PROPERTY(QStringList letters READ letters NOTIFY rowsChanged)
    /// How many of what is in the list; empty: nothing to say.
    Q_PROPERTY(QString found READ found NOTIFY rowsChanged)

    Q_PROPERTY(State state READ state NOTIFY stateChanged)
    Q_PROPERTY(QString emptyText READ emptyText NOTIFY stateChanged)
    Q_PROPERTY(bool scanning READ scanning NOTIFY scanChanged)
    Q_PROPERTY(QString scanText READ scanText NOTIFY scanChanged)
    Q_PROPERTY(double scanValue READ scanValue NOTIFY scanChanged)

    Q_PROPERTY(QString photo READ photo NOTIFY photoChanged)
    Q_PROPERTY(QString placeText READ placeText NOTIFY photoChanged)
    Q_PROPERTY(QString summary READ summary NOTIFY photoChanged)
    /// What up and down have gone to; the summary at first.
    Q_PROPERTY(QString detail READ detail NOTIFY detailChanged)
    Q_PROPERTY(QImage picture READ picture NOTIFY pictureChanged)
    Q_PROPERTY(QString pictureProblem READ pictureProblem NOTIFY pictureChanged)

    Q_PROPERTY(bool playing READ playing NOTIFY playbackChanged)
    /// Of the recording that is heard or paused: what it is and where; empty: none is.
    Q_PROPERTY(QString heard READ heard NOTIFY progressChanged)
    Q_PROPERTY(double heardValue READ heardValue NOTIFY progressChanged)
    Q_PROPERTY(QString speedText READ speedText NOTIFY speedChanged)
    /// Every key of the page, and the gestures.
    Q_PROPERTY(QString keys READ keys CONSTANT)
    /// What went wrong with this photograph's recordings; empty: nothing.
    Q_PROPERTY(QString notice READ notice NOTIFY noticeChanged)
public:
    enum class View { Photos, Names, Search };
    Q_ENUM(View)
    enum class State {
        NoFolders, ///< a person has chosen no folder yet
        Looking,   ///< none was found yet, and the scan goes on
        Empty,     ///< there is no photograph in the folders
        Ready
    };
    Q_ENUM(State)
    enum class Topic { People, Years, Places, Keywords };
    Q_ENUM(Topic)

    /// All must outlive the session; `player` and what it sounds through are its own. Pictures are read to
    /// fit `screen`.
    BrowseSession(OpenAlbum& album, Narrator& narrator, EarconPlayer& earcons, Player& player,
                  Preferences& preferences, QSize screen = {1920, 1200});
    ~BrowseSession() override;

    View view() const { return level().view; }
    QString title() const { return level().title; }
    const QVariantList& rows() const { return rows_; }
    int chosenRow() const { return level().chosen_row; }
    QString typed() const { return level().typed; }
    const QStringList& letters() const { return letters_; }
    const QString& found() const { return found_; }
    State state() const { return state_; }
    QString emptyText() const;
    bool scanning() const { return album_.scanning(); }
    QString scanText() const;
    double scanValue() const;
    QString photo() const;
    int position() const { return static_cast<int>(trail().position()); }
    int count() const { return static_cast<int>(trail().count()); }
    QString placeText() const;
    const QString& summary() const { return summary_; }
    QString detail() const;
    const QImage& picture() const { return picture_; }
    const QString& pictureProblem() const { return picture_problem_; }
    bool hasRecordings() const { return !playback_.tags().empty(); }
    bool playing() const { return playback_.playing(); }
    QString heard() const;
    double heardValue() const;
    QString speedText() const;
    QString keys() const;
    const QString& notice() const { return notice_; }

    /// The photograph that is shown; none where there is none.
    const std::optional<PhotoEntry>& here() const { return trail().here(); }

    /// The page is shown: tells where one is and what can be done.
    Q_INVOKABLE void enter();
    /// Another page is shown.
    Q_INVOKABLE void leave();

    Q_INVOKABLE void next();
    Q_INVOKABLE void previous();
    Q_INVOKABLE void first();
    Q_INVOKABLE void last();
    Q_INVOKABLE void surprise();
    /// Shows and tells this photograph among all; false where the album does not have it.
    Q_INVOKABLE bool show(const QString& photo);

    Q_INVOKABLE void nextDetail() { step_detail(1); }
    Q_INVOKABLE void previousDetail() { step_detail(-1); }
    /// Tells again what `detail` is; what plays is paused for it.
    Q_INVOKABLE void tellDetail();
    /// One finger on the photograph: tells what `detail` is, but disturbs no recording, for a second tap may
    /// follow.
    Q_INVOKABLE void tap();
    /// Two fingers: what sounds stops. Twice: the recordings are heard, or stop.
    Q_INVOKABLE void twoFingerTap();
    Q_INVOKABLE void twoFingerDoubleTap();
    Q_INVOKABLE void whereAmI();
    /// Plays, pauses and goes on; on the detail of a recording that one alone.
    Q_INVOKABLE void play();
    /// What sounds or is said ends; false where it is quiet already.
    Q_INVOKABLE bool stop();
    Q_INVOKABLE void faster() { change_speed(1); }
    Q_INVOKABLE void slower() { change_speed(-1); }

    Q_INVOKABLE void allPhotos();
    Q_INVOKABLE void openTopic(Topic topic);
    Q_INVOKABLE void openSearch();
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
    Q_INVOKABLE void choose(int row);
    /// The keyboard is on this row.
    Q_INVOKABLE void reach(int row);
    Q_INVOKABLE void back();
    Q_INVOKABLE void tellKeys();

    Q_INVOKABLE void askExplore();
    Q_INVOKABLE void askCare();

signals:
    void levelChanged();
    void rowsChanged();
    void stateChanged();
    void scanChanged();
    void photoChanged();
    void detailChanged();
    void pictureChanged();
    void playbackChanged();
    void progressChanged();
    void speedChanged();
    void noticeChanged();

    void exploreAsked(const QString& photo);
    void careAsked(const QString& photo);
    /// Folders are to be chosen.
    void settingsAsked();
    void importAsked();

private:
    struct Level {
        View view = View::Photos;
        QString title;
        std::optional<PhotoTrail> trail; ///< of photographs
        std::string kind;                ///< of names: "person", "year", "place", "keyword"
        QString typed;                   ///< of a search
        int chosen_row = -1;
    };
    /// What a row leads to.
    struct More {};
    using Choice = std::variant<TopicEntry, int, PhotoEntry, More>;

    Level& level() { return levels_.back(); }
    const Level& level() const { return levels_.back(); }
    PhotoTrail& trail();
    const PhotoTrail& trail() const;
    void look_at_album();
    void begin();
    bool checked(const Result<bool>& moved);
    void step(bool forward);
    void jump(const Result<bool>& moved);
    void show_here(bool backwards = false);
    void forget_photo();
    void read_record();
    void tell_here(Priority priority);
    void step_detail(int by);
    std::optional<std::size_t> chosen_recording() const;
    void change_speed(int by);
    void set_state();
    void set_notice(const QString& notice);
    void open_photos(const QString& title, PhotoTrail trail, const std::optional<PhotoEntry>& at);
    void enter_level();
    void list_rows();
    void fill_rows();
    double speed() const { return preferences_.choices().playback_speed; }
    void list_names(std::size_t most);
    void list_matches();
    void spell(const QString& words);
    void add_row(const QString& text, const QString& detail, Choice choice);
    void tell_list();
    QString list_words() const;
    void refuse(const QString& sentence);
    QString topic_words(const TopicEntry& topic) const;
    QString title_of(const std::string& kind) const;

    OpenAlbum& album_;
    Narrator& narrator_;
    EarconPlayer& earcons_;
    Preferences& preferences_;
    TagPlayback playback_;
    PictureAhead pictures_;

    std::vector<Level> levels_; ///< never empty; the first has all photographs
    QVariantList rows_;
    std::vector<Choice> choices_; ///< one a row
    QString found_;
    QStringList letters_;
    std::size_t most_rows_ = 0;

    State state_ = State::Looking;
    bool active_ = false;         ///< the page is shown
    bool begun_ = false;          ///< one is where one was when the program ended, or has gone on from there
    bool tap_stopped_ = false;    ///< the first of two taps of two fingers
    std::filesystem::path shown_; ///< the photograph that the words below are about
    std::string sha256_;
    PhotoRecord record_;
    QString summary_;
    std::vector<PhotoDetail> details_;
    int detail_ = -1; ///< −1: the summary
    QImage picture_;
    QString picture_problem_, notice_;
};

} // namespace tp
