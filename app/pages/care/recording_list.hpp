// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/care/care_teller.hpp"
#include "app/pages/care/cared_photo.hpp"

#include <QStringList>
#include <QUrl>
#include <QVariantList>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <string>
#include <vector>

namespace tp {

/// The recordings of the photograph in the order in which they are played, one of them chosen, and what can be done to
/// that one: moved, labelled, deleted. Sound files are taken in too.
class RecordingList final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// One entry a recording: {text, detail, chosen}.
    Q_PROPERTY(QVariantList rows READ rows NOTIFY changed)
    Q_PROPERTY(int count READ count NOTIFY changed)
    Q_PROPERTY(int chosen READ chosen NOTIFY changed) ///< index; -1: none
    Q_PROPERTY(QString chosenText READ chosenText NOTIFY changed)
    Q_PROPERTY(bool canMoveUp READ canMoveUp NOTIFY changed)
    Q_PROPERTY(bool canMoveDown READ canMoveDown NOTIFY changed)
    Q_PROPERTY(QStringList kinds READ kinds CONSTANT)
    Q_PROPERTY(QStringList languageNames READ languageNames NOTIFY changed)

    // The label of the chosen one.
    Q_PROPERTY(int kind READ kind NOTIFY changed) ///< index in `kinds`
    Q_PROPERTY(QString person READ person NOTIFY changed)
    Q_PROPERTY(QString speaker READ speaker NOTIFY changed)
    Q_PROPERTY(int language READ language NOTIFY changed) ///< index in `languageNames`
public:
    /// Both must outlive it.
    RecordingList(CaredPhoto& photo, CareTeller& teller);

    QVariantList rows() const;
    int count() const { return static_cast<int>(tags_.size()); }
    int chosen() const { return chosen_; }
    QString chosenText() const;
    bool canMoveUp() const { return chosen_ > 0; }
    bool canMoveDown() const { return chosen_ >= 0 && chosen_ + 1 < count(); }
    QStringList kinds() const;
    QStringList languageNames() const;
    int kind() const;
    QString person() const;
    QString speaker() const;
    int language() const;

    /// The chosen one as the sidecar lists it; null: none.
    const Tag* chosen_tag() const;
    /// Chooses the recording with that file; nothing where another photograph was opened meanwhile.
    void choose_file(const PhotoPlace& place, const std::string& file);

    Q_INVOKABLE void choose(int recording);
    /// One place nearer to the beginning (-1) or the end (+1).
    Q_INVOKABLE void move(int by);
    Q_INVOKABLE void remove();
    Q_INVOKABLE void setKind(int kind);
    Q_INVOKABLE void setPerson(const QString& name);
    Q_INVOKABLE void setSpeaker(const QString& name);
    Q_INVOKABLE void setLanguage(int language);
    /// Takes sound files in as recordings of that kind.
    Q_INVOKABLE void addFiles(const QList<QUrl>& sounds, int kind);

signals:
    void changed();
    /// Another recording was chosen, or none.
    void chosenChanged();

private:
    void list();
    void become(int chosen);
    void relabel(std::function<void(RecordingLabel&)> change);
    int index_of(const std::string& file) const;
    QStringList languages() const;
    QString words_of(int recording) const;

    CaredPhoto& photo_;
    CareTeller& teller_;
    std::vector<Tag> tags_; ///< as they are played
    int chosen_ = -1;
    std::string chosen_file_; ///< empty: none
    int moves_ = 0;           ///< on their way to the disk
    std::string moving_;      ///< the file that is being moved
    int moves_by_ = 0;        ///< so many places, which the list does not show yet
    int relabelling_ = 0;     ///< labels on their way to the disk
};

} // namespace tp
