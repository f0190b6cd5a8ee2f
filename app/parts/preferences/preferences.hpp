// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/preferences/choices.hpp"

#include <QObject>
#include <QString>
#include <QTimer>

#include <filesystem>

namespace tp {

/// The person's choices, and the file that keeps them between starts. Every page reads them here and hears of changes;
/// one place changes them, `change`. Belongs to the page's thread.
class Preferences final : public QObject {
    Q_OBJECT
public:
    /// Reads `file`; where there is none the choices are those of somebody new. One that makes no sense is set aside
    /// as preferences.json.aside and told in `notice`. An empty path keeps nothing, for tests.
    explicit Preferences(std::filesystem::path file = {}, QObject* parent = nullptr);
    /// Keeps what is not kept yet.
    ~Preferences() override;
    /// preferences.json in the user's folder for settings of this program.
    static std::filesystem::path usual_file();

    const Choices& choices() const { return choices_; }
    /// preferences.change([&](Choices& choices) { choices.motion = false; });
    template <typename Change>
    void change(Change change) {
        Choices changed = choices_;
        change(changed);
        set(changed);
    }
    void set(const Choices& choices);

    /// A sentence about the file, for the start: it was spoilt and set aside. Empty: nothing to tell.
    const QString& notice() const { return notice_; }
    /// Writes now what is not kept yet; the sentence that says why not, else empty.
    QString keep();

signals:
    void changed();
    /// The choices could not be kept; a sentence. They hold until the program ends.
    void not_kept(const QString& sentence);

private:
    std::filesystem::path file_;
    Choices choices_, kept_;
    QString notice_;
    QTimer soon_; ///< one write for many changes, so that moving a slider does not wait for the disk
};

} // namespace tp
