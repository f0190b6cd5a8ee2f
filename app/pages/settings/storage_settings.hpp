// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/setting_steps.hpp"
#include "app/parts/folders/folder_chooser.hpp"
#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>

namespace tp {

/// The album's folders, and what the program keeps about its user.
class StorageSettings final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(QStringList folders READ folders NOTIFY changed)
    Q_PROPERTY(bool choosing READ choosing NOTIFY choosingChanged)
    Q_PROPERTY(tp::FolderChooser* chooser READ chooser CONSTANT)
    Q_PROPERTY(bool knowFaces READ knowFaces NOTIFY changed) ///< Choices::know_faces
    /// What the program keeps about its user on this computer, in sentences.
    Q_PROPERTY(QStringList stored READ stored NOTIFY storedChanged)
public:
    /// What the program keeps besides the album: where, and how to throw it away.
    struct Stored {
        std::filesystem::path preferences; ///< file
        std::filesystem::path cache;       ///< folder of the album's index
        /// Has the index thrown away when the program ends.
        std::function<void()> discard_index;
    };

    /// Steps and narrator must outlive it. `calibrations`: file of the force devices.
    StorageSettings(SettingSteps& steps, Narrator& narrator, Stored stored,
                    std::filesystem::path calibrations);

    QStringList folders() const { return steps_.now().folders; }
    bool knowFaces() const { return steps_.now().know_faces; }
    bool choosing() const { return choosing_; }
    FolderChooser* chooser() { return &chooser_; }
    QStringList stored() const;

    Q_INVOKABLE void addFolder();
    Q_INVOKABLE void removeFolder(int index);
    Q_INVOKABLE void setKnowFaces(bool on);
    Q_INVOKABLE void discardIndex();
    /// Looks again at what is kept.
    void enter() { emit storedChanged(); }
    /// No folder is chosen any more.
    void leave() { set_choosing(false); }
    /// Ends choosing a folder, and says so; false where none is being chosen.
    bool cancel();

signals:
    void changed();
    void choosingChanged();
    void storedChanged();

private:
    void set_choosing(bool choosing);

    SettingSteps& steps_;
    Narrator& narrator_;
    Stored stored_;
    std::filesystem::path calibrations_;
    FolderChooser chooser_;
    bool choosing_ = false;
};

} // namespace tp
