// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/album_faces.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/group_faces.hpp"
#include "app/pages/care/group_rows.hpp"
#include "app/pages/care/keeper_steps.hpp"
#include "app/pages/care/thumbnails.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace tp {

/// The people of the album, by their faces: each is named once, and what was guessed wrongly is put right. A name goes
/// into the sidecars of the photographs; nothing does without a person's word.
///
/// | state  | show | choose a row | named, somebody is left | named, nobody is left | back | hide   |
/// |--------|------|--------------|-------------------------|-----------------------|------|--------|
/// | hidden | list |              |                         |                       |      |        |
/// | list   |      | person       |                         |                       |      | hidden |
/// | person |      | person       | person: the next one    | list                  | list | hidden |
class GroupCare final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool on READ on NOTIFY changed)       ///< faces are compared at all
    Q_PROPERTY(bool shown READ shown NOTIFY changed) ///< in place of the photographs
    Q_PROPERTY(tp::GroupRows* rows READ rows CONSTANT)
    Q_PROPERTY(tp::GroupFaces* faces READ faces CONSTANT) ///< of the person who is open
    Q_PROPERTY(int row READ row NOTIFY changed)           ///< of that person; −1: none
    Q_PROPERTY(QString summary READ summary NOTIFY changed)
    Q_PROPERTY(QString title READ title NOTIFY changed)     ///< the open person's
    Q_PROPERTY(QString details READ details NOTIFY changed) ///< likewise
    Q_PROPERTY(QString name READ name NOTIFY changed)       ///< likewise; empty: nobody has said it
    Q_PROPERTY(QString offer READ offer NOTIFY
                   changed) ///< who the faces may be of whom nobody has said it; empty: nobody
    Q_PROPERTY(int selected READ selected NOTIFY changed) ///< of `faces`; −1: none
public:
    /// As FaceCare's.
    using Suggest = std::function<QStringList(const QString& typed)>;

    /// All but `suggest` must outlive it.
    GroupCare(OpenAlbum& album, AlbumFaces& groups, KeeperSteps& steps, CareTeller& teller, Suggest suggest);

    bool on() const { return groups_.on(); }
    bool shown() const { return shown_; }
    GroupRows* rows() { return &rows_; }
    GroupFaces* faces() { return &faces_; }
    int row() const { return rows_.row_of(open_); }
    QString summary() const;
    QString title() const;
    QString details() const;
    QString name() const;
    QString offer() const;
    int selected() const { return selected_; }

    Q_INVOKABLE void show();
    Q_INVOKABLE void hide();
    /// Opens a person, or none (-1).
    Q_INVOKABLE void choose(int row);
    /// From the person to the list, from there to the photographs; false: it was there already.
    bool back();
    /// Who the open person is: on all photographs. Goes on to the next one of whom nobody has said it.
    Q_INVOKABLE void nameAll(const QString& name);
    /// Yes: the faces are those of `offer`.
    Q_INVOKABLE void confirm();
    /// Selects a face of the open person, or none (-1).
    Q_INVOKABLE void select(int face);
    /// This face of the open person is somebody else's.
    Q_INVOKABLE void notThisPerson(int face);
    Q_INVOKABLE void openPhoto();
    Q_INVOKABLE QStringList suggestions(const QString& typed) const;

signals:
    void changed();
    /// Another person is open, or none: the words in the field are for another one.
    void personChosen();
    void photoAsked(const std::filesystem::path& photo);

private:
    using Answer = std::set<GroupId>; ///< the groups of one person whose name is on its way to the disk
    /// Each album folder has a keeper of its own.
    using Steps = std::map<AlbumKeeper*, std::function<std::string(AlbumKeeper&)>>;

    void open(int row);
    const Person* open_person() const { return rows_.person(row()); }
    void take(const std::shared_ptr<const People>& people);
    /// The name that is shown as these words, where somebody has it already: it may have what is not shown, such as a mark for the
    /// direction of writing. Else the words.
    std::string name_meant(const QString& words) const;
    void name_them(const std::vector<PersonFace>& faces, const std::string& name);
    void rename(const Person& person, const std::string& name);
    void write(const Steps& steps, const QString& name, const std::set<std::filesystem::path>& photos);
    /// A name is on its way for the open person: the next one is asked for meanwhile, so that nobody who types on names the last
    /// one anew.
    Answer answered();
    void named(const Answer& answer, const QString& name, const std::set<std::filesystem::path>& photos,
               const QString& problem);
    int next_without_a_name() const;

    OpenAlbum& album_;
    AlbumFaces& groups_;
    KeeperSteps& steps_;
    CareTeller& teller_;
    Suggest suggest_;
    Thumbnails pictures_;
    GroupRows rows_{pictures_};
    GroupFaces faces_{pictures_};
    std::shared_ptr<const People> people_; ///< null: they have not come yet
    Answer answered_;                      ///< of all whose name is on its way to the disk and the index
    int on_the_way_ = 0;                   ///< names
    GroupId open_ = 0;                     ///< the open person's; 0: none
    int selected_ = -1;
    bool shown_ = false;
};

} // namespace tp
