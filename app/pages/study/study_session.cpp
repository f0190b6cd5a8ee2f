// SPDX-License-Identifier: Apache-2.0
#include "app/pages/study/study_session.hpp"

#include <QCursor>

#include <utility>

namespace tp {

namespace {
constexpr double step_s = 0.005; ///< of a test's time between two looks at the finger
}

StudySession::StudySession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide,
                           Preferences& preferences, StudySettings settings)
    : settings_(std::move(settings)), teller_(narrator, earcons), ear_(guide),
      finger_(settings_, preferences), setup_(settings_, finger_, keeping_, teller_, narrator),
      overview_(setup_, teller_), run_(settings_, finger_, keeping_, ear_, teller_) {
    connect(&preferences, &Preferences::changed, this, [this] { // the language may be another
        emit setup_.changed();
        emit run_.changed();
    });
    connect(&run_, &StudyRun::ended, &setup_, &StudySetup::enter);
}

void StudySession::enter() {
    here_ = true;
    teller_.set_here(true);
    finger_.look(true);
    if (!run_.running())
        setup_.enter();
    tellWhere();
}

void StudySession::leave() {
    if (!std::exchange(here_, false))
        return;
    run_.leave();
    setup_.leave();
    overview_.hide();
    finger_.look(false);
    teller_.hush();
    teller_.set_here(false);
}

void StudySession::setActive(bool active) {
    if (!active)
        run_.pause_because({});
    else if (here_ && run_.state() == StudyRun::State::Paused)
        tellWhere();
}

void StudySession::begin() {
    if (run_.running() || setup_.choosing())
        return;
    if (const auto plan = setup_.plan()) {
        overview_.hide();
        return run_.begin(*plan);
    }
    teller_.problem(setup_.problem());
}

bool StudySession::stop() { return setup_.cancel() || run_.stop(); }

void StudySession::tellWhere() { run_.running() ? run_.tell_where() : setup_.tell_where(); }

void StudySession::putMouse(double x, double y) { QCursor::setPos(qRound(x), qRound(y)); }

void StudySession::advance(double seconds) {
    for (double left = seconds; left > 0.5 * step_s; left -= step_s) {
        finger_.pass(step_s);
        run_.poll();
    }
}

} // namespace tp
