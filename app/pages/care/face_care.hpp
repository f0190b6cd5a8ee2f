// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/album/grouping/album_faces.hpp"
#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"
#include "app/pages/care/face_finder.hpp"
#include "app/photo/people/region_place.hpp"

#include <QImage>
#include <QString>
#include <QStringList>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <memory>
#include <vector>

namespace tp {

/// Who is on a photograph: its faces, found and marked, those without a name first, and naming them.
class FaceCare final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// One entry a face: {text, problem, named, offer (who it may be), picture (a QImage), chosen}.
    Q_PROPERTY(QVariantList faces READ faces NOTIFY changed)
    Q_PROPERTY(int count READ count NOTIFY changed)
    /// Index of the face that is being named; -1: none.
    Q_PROPERTY(int chosen READ chosen NOTIFY changed)
    Q_PROPERTY(QString chosenName READ chosenName NOTIFY changed)
    /// The languages that a name can be read in, each in its own words.
    Q_PROPERTY(QStringList languages READ languages NOTIFY languagesChanged)
    /// Of `languages`, that of the chosen face's name; -1: none, it is read as the page is.
    Q_PROPERTY(int language READ language NOTIFY changed)
    /// "Three faces, one without a name.", or why there are none.
    Q_PROPERTY(QString summary READ summary NOTIFY changed)
    Q_PROPERTY(bool looking READ looking NOTIFY changed)
    Q_PROPERTY(QImage picture READ picture NOTIFY changed) ///< the whole photograph; null until it was read
public:
    /// People whom the album knows, and who may be meant by what was typed so far, the likeliest first.
    using Suggest = std::function<QStringList(const QString& typed)>;

    /// All but `suggest` must outlive it.
    FaceCare(CaredPhoto& photo, FaceFinder& finder, AlbumFaces& groups, CareTeller& teller, Suggest suggest);

    QVariantList faces() const;
    int count() const { return static_cast<int>(faces_.size()); }
    int chosen() const { return chosen_; }
    QString chosenName() const;
    QStringList languages() const;
    int language() const;
    QString summary() const;
    QImage picture() const { return found_ ? found_->image : QImage(); }
    bool looking() const { return photo_.is_open() && !found_; }

    /// Opens a face for naming, or none (-1).
    Q_INVOKABLE void choose(int face);
    /// Names the chosen face and goes on to the next one without a name; empty: nobody knows who it is.
    Q_INVOKABLE void name(const QString& name);
    /// Yes: this face is who was offered.
    Q_INVOKABLE void accept(int face);
    /// From now on the name of the chosen face is read in one of `languages`, on all of the album's photographs; -1: as
    /// the page is. Says the name so.
    Q_INVOKABLE void readNameIn(int language);
    /// Known people for what was typed; those on this photograph already come last.
    Q_INVOKABLE QStringList suggestions(const QString& typed) const;

signals:
    void changed();
    void languagesChanged();
    /// A face was opened for naming, or none is any more: the words in the field are for another one.
    void faceChosen();

private:
    struct KnownFace {
        Rect part;         ///< of the picture in which faces were found, 0 … 1
        FaceRegion region; ///< stored picture; with the name
        QString problem;   ///< why its contours may be wrong, in a sentence
        std::string offer; ///< who it may be; empty: nobody knows
    };
    void list_faces();
    void ask();
    std::string offer_for(const Rect& part) const;
    void open_for_naming(int face);
    void keep_name(const KnownFace& face, const QString& name, std::function<void()> then);
    PictureTurn turn() const;
    int next_without_a_name() const;
    QString face_words(int face) const;
    std::string chosen_language() const;
    void list_languages();

    CaredPhoto& photo_;
    FaceFinder& finder_;
    AlbumFaces& groups_;
    CareTeller& teller_;
    Suggest suggest_;
    std::shared_ptr<const FoundFaces> found_; ///< of the photograph that is open; null: still looked for
    std::vector<KnownFace> faces_;
    std::vector<FaceOffer> offers_; ///< for the photograph that is open
    int chosen_ = -1;
    quint64 choice_ = 0;    ///< changes with each face and each photograph that is opened
    QStringList languages_; ///< BCP 47
};

} // namespace tp
