// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/study/study_ear.hpp"
#include "app/pages/study/study_finger.hpp"
#include "app/pages/study/study_keeping.hpp"
#include "app/pages/study/study_overview.hpp"
#include "app/pages/study/study_run.hpp"
#include "app/pages/study/study_settings.hpp"
#include "app/pages/study/study_setup.hpp"
#include "app/pages/study/study_teller.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "audio/guide/sonified_guide.hpp"
#include "audio/sound/earcon_player.hpp"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace tp {

/// An experiment with people: its parts, each with one thing to care for, and what concerns several of them. A part knows those
/// before it.
class StudySession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(tp::StudyTeller* teller READ teller CONSTANT)
    Q_PROPERTY(tp::StudySetup* setup READ setup CONSTANT)
    Q_PROPERTY(tp::StudyOverview* overview READ overview CONSTANT)
    Q_PROPERTY(tp::StudyRun* run READ run CONSTANT)
public:
    /// All must outlive the session.
    StudySession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide, Preferences& preferences,
                 StudySettings settings);

    StudyTeller* teller() { return &teller_; }
    StudySetup* setup() { return &setup_; }
    StudyOverview* overview() { return &overview_; }
    StudyRun* run() { return &run_; }
    StudyFinger& finger() { return finger_; }

    void enter();
    void leave();
    /// Whether the window has the keyboard: a person who works elsewhere is not in a trial.
    Q_INVOKABLE void setActive(bool active);
    /// Asks the participant who is set up for consent; where that cannot be, says why.
    Q_INVOKABLE void begin();
    /// What Escape does; false where nothing runs.
    Q_INVOKABLE bool stop();
    /// Tells where one is.
    Q_INVOKABLE void tellWhere();
    /// The hand moves by so many millimetres, x right, y down, as pages have it.
    Q_INVOKABLE void moveBy(double dx, double dy) { run_.move_by({dx, -dy}); }

    /// Puts the mouse there on the screen, where the system lets it be put.
    Q_INVOKABLE void putMouse(double x, double y);

    /// So much time passes, in a test's own time.
    void advance(double seconds);

private:
    StudySettings settings_;
    StudyTeller teller_;
    StudyEar ear_;
    StudyFinger finger_;
    StudyKeeping keeping_;
    StudySetup setup_;
    StudyOverview overview_;
    StudyRun run_;
    bool here_ = false;
};

} // namespace tp
