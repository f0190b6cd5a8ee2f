// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <functional>
#include <vector>

namespace tp {

/// Changes of what a person has chosen: each is said, kept at once and can be taken back.
class SettingSteps final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    /// What undo() takes back, in words; empty: nothing.
    Q_PROPERTY(QString undoable READ undoable NOTIFY changed)
public:
    /// Both must outlive it.
    SettingSteps(Narrator& narrator, Preferences& preferences);

    QString undoable() const { return history_.empty() ? QString() : history_.back().what; }
    const Choices& now() const { return preferences_.choices(); }

    Q_INVOKABLE void undo();
    /// Everything as it was at first, but the album's folders, which stay.
    Q_INVOKABLE void reset();
    /// Makes one change, remembers it for undo under `what`, and tells `said`. The same `what` again is one
    /// step with the last.
    void make(const QString& what, const QString& said, const std::function<void(Choices&)>& change);
    /// An answer to what a hand does now.
    void tell(const QString& sentence) { narrator_.tell(sentence, Priority::touch); }

signals:
    /// What a person has chosen is something else, or what can be taken back.
    void changed();

private:
    struct Step {
        QString what;
        Choices before;
    };

    Narrator& narrator_;
    Preferences& preferences_;
    std::vector<Step> history_;
};

} // namespace tp
