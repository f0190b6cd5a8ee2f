// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// A folder chosen by going from one to the next, in a list that a screen reader and a key can use; a system's own
/// dialog cannot be used without sight everywhere.
class FolderChooser final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// Where one is, absolute, as the system writes it.
    Q_PROPERTY(QString folder READ folder NOTIFY moved)
    /// The folders in it by name; hidden ones are left out.
    Q_PROPERTY(QStringList below READ below NOTIFY moved)
    Q_PROPERTY(bool hasAbove READ hasAbove NOTIFY moved)
    /// How many photographs lie in it itself, as words.
    Q_PROPERTY(QString content READ content NOTIFY moved)
public:
    /// The narrator must outlive it.
    explicit FolderChooser(Narrator& narrator, QObject* parent = nullptr);

    QString folder() const { return folder_; }
    QStringList below() const { return below_; }
    bool hasAbove() const;
    QString content() const;

    /// Begins in the user's pictures, or home where there are none.
    Q_INVOKABLE void begin();
    void begin_in(const QString& folder);
    Q_INVOKABLE void goInto(int index);
    Q_INVOKABLE void goUp();
    /// Takes the one where one is.
    Q_INVOKABLE void choose();
    Q_INVOKABLE void cancel();

    /// The user's pictures where there is such a folder, else empty.
    static QString pictures_folder();

signals:
    void moved();
    void chosen(const QString& folder);
    void cancelled();

private:
    bool look(const QString& folder);
    void tell_place();

    Narrator& narrator_;
    QString folder_;
    QStringList below_;
    int photos_ = 0;
};

} // namespace tp
