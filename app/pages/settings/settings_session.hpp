// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/settings/device_settings.hpp"
#include "app/parts/folders/folder_chooser.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <vector>

namespace tp {

/// The settings page: what a person has chosen, each change said, kept and undoable.
class SettingsSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    // Each of these is an index into the options of its name.
    Q_PROPERTY(int voice READ voice NOTIFY changed)
    Q_PROPERTY(QStringList voices READ voices NOTIFY changed)
    Q_PROPERTY(int rate READ rate NOTIFY changed)
    Q_PROPERTY(QStringList rates READ rates NOTIFY changed)
    Q_PROPERTY(int language READ language NOTIFY changed)
    Q_PROPERTY(QStringList languages READ languages NOTIFY changed)
    Q_PROPERTY(int user READ user NOTIFY changed)
    Q_PROPERTY(QStringList users READ users NOTIFY changed)
    Q_PROPERTY(int theme READ theme NOTIFY changed)
    Q_PROPERTY(QStringList themes READ themes NOTIFY changed)
    Q_PROPERTY(int guide READ guide NOTIFY changed)
    Q_PROPERTY(QStringList guides READ guides NOTIFY changed)

    Q_PROPERTY(double textScale READ textScale NOTIFY changed)
    Q_PROPERTY(double playbackSpeed READ playbackSpeed NOTIFY changed)
    /// Newtons.
    Q_PROPERTY(double maxForce READ maxForce NOTIFY changed)
    Q_PROPERTY(bool motion READ motion NOTIFY changed)
    Q_PROPERTY(bool earcons READ earcons NOTIFY changed)
    Q_PROPERTY(bool brows READ brows NOTIFY changed)
    Q_PROPERTY(bool nose READ nose NOTIFY changed)
    Q_PROPERTY(bool irises READ irises NOTIFY changed)

    Q_PROPERTY(tp::DeviceSettings* devices READ devices CONSTANT)
    Q_PROPERTY(QStringList folders READ folders NOTIFY changed)
    Q_PROPERTY(bool choosing READ choosing NOTIFY choosingChanged)
    Q_PROPERTY(tp::FolderChooser* chooser READ chooser CONSTANT)
    /// What the program keeps about its user on this computer, in sentences.
    Q_PROPERTY(QStringList stored READ stored NOTIFY storedChanged)
    /// What undo() takes back, in words; empty: nothing.
    Q_PROPERTY(QString undoable READ undoable NOTIFY changed)
public:
    /// What the program keeps besides the preferences: where, and how to throw it away.
    struct Stored {
        std::filesystem::path preferences; ///< file
        std::filesystem::path cache;       ///< folder of the album's index
        /// Has the index thrown away when the program ends.
        std::function<void()> discard_index;
    };

    /// All must outlive the session.
    SettingsSession(Narrator& narrator, Preferences& preferences, Stored stored, DeviceSettings::Setup devices = {});

    int voice() const { return static_cast<int>(now().voice); }
    int rate() const { return static_cast<int>(now().rate); }
    int language() const;
    int user() const { return static_cast<int>(now().user); }
    int theme() const { return static_cast<int>(now().theme); }
    int guide() const { return static_cast<int>(now().guide); }
    double textScale() const { return now().text_scale; }
    double playbackSpeed() const { return now().playback_speed; }
    double maxForce() const { return now().max_force_n; }
    bool motion() const { return now().motion; }
    bool earcons() const { return now().earcons; }
    bool brows() const { return now().brows; }
    bool nose() const { return now().nose; }
    bool irises() const { return now().irises; }
    DeviceSettings* devices() { return &devices_; }
    QStringList folders() const { return now().folders; }
    QStringList voices() const;
    QStringList rates() const;
    QStringList languages() const;
    QStringList users() const;
    QStringList themes() const;
    QStringList guides() const;
    bool choosing() const { return choosing_; }
    FolderChooser* chooser() { return &chooser_; }
    QStringList stored() const;
    QString undoable() const { return history_.empty() ? QString() : history_.back().what; }

    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();

    Q_INVOKABLE void chooseVoice(int index);
    Q_INVOKABLE void chooseRate(int index);
    Q_INVOKABLE void chooseLanguage(int index);
    Q_INVOKABLE void chooseUser(int index);
    Q_INVOKABLE void chooseTheme(int index);
    Q_INVOKABLE void chooseGuide(int index);
    Q_INVOKABLE void setTextScale(double scale);
    Q_INVOKABLE void setPlaybackSpeed(double speed);
    Q_INVOKABLE void setMaxForce(double newtons);
    /// Index into the devices' names.
    Q_INVOKABLE void chooseDevice(int index);
    Q_INVOKABLE void setMotion(bool on);
    Q_INVOKABLE void setEarcons(bool on);
    Q_INVOKABLE void setBrows(bool on);
    Q_INVOKABLE void setNose(bool on);
    Q_INVOKABLE void setIrises(bool on);
    Q_INVOKABLE void addFolder();
    Q_INVOKABLE void removeFolder(int index);
    /// Everything as it was at first, but the album's folders, which stay.
    Q_INVOKABLE void reset();
    Q_INVOKABLE void undo();
    Q_INVOKABLE void discardIndex();
    /// Ends what is done with a device, or choosing a folder; false where there is nothing to end.
    Q_INVOKABLE bool back();

signals:
    void changed();
    void choosingChanged();
    void storedChanged();
    void pageAsked(const QString& page);
    /// The five questions of the first start are wanted once more.
    void questionsAsked();

private:
    struct Step {
        QString what;
        Choices before;
    };
    const Choices& now() const { return preferences_.choices(); }
    /// Makes one change, remembers it for undo under `what`, and tells `said`.
    template <typename Change>
    void make(const QString& what, const QString& said, Change change);
    void set_choosing(bool choosing);

    Narrator& narrator_;
    Preferences& preferences_;
    Stored stored_;
    FolderChooser chooser_;
    DeviceSettings devices_;
    std::vector<Step> history_;
    bool choosing_ = false;
};

} // namespace tp
