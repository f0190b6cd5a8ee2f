// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/mend/mend_selection.hpp"
#include "app/pages/mend/mended_photo.hpp"
#include "app/parts/narration/narrator.hpp"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <cstddef>
#include <deque>
#include <functional>

namespace tp {

/// What a person did to the contours and can take back: whole states, so that one that comes back is what it
/// was to the last bit. A step that goes on with the one before (`run`, such as keys that move one point) is
/// taken back with it.
class MendHistory final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(bool canUndo READ canUndo NOTIFY changed)
    Q_PROPERTY(bool canRedo READ canRedo NOTIFY changed)
public:
    static constexpr std::size_t most_steps = 200;

    /// All must outlive it.
    MendHistory(MendedPhoto& photo, const MendSelection& selection, Narrator& narrator);

    bool canUndo() const { return !steps_.empty(); }
    bool canRedo() const { return !undone_.empty(); }
    Q_INVOKABLE void undo();
    Q_INVOKABLE void redo();

    /// Changes the contours by a step that can be taken back. `what`: in words that follow "Undone:"; `run`
    /// empty: a step of its own.
    void step(const QString& what, const std::function<void(MendWork&)>& change, const QString& run = {});
    /// Puts other contours in the place of all, by one step.
    void replace(const QString& what, const MendWork& work);
    /// The next step is one of its own.
    void end_run() { run_.clear(); }
    /// Takes the newest step back, as if it had never been done.
    void forget_newest();

signals:
    void changed();
    /// Before other contours come in the place of all: what is under way is to be put back.
    void turning();

private:
    struct Step {
        QString what;
        MendWork work;
    };
    QString turn(std::deque<Step>& from, std::deque<Step>& to);

    MendedPhoto& photo_;
    Narrator& narrator_;
    std::deque<Step> steps_, undone_;
    QString run_;
};

} // namespace tp
