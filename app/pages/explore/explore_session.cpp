// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/explore_session.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace tp {

ExploreSession::ExploreSession(Narrator& narrator, EarconPlayer& earcons, SonifiedGuide& guide,
                               Preferences& preferences, ExploreSettings settings)
    : now_(settings.now),
      servo_({settings.surface.width_mm, settings.surface.height_mm}, settings.servo, settings.plant),
      words_(narrator, earcons, preferences, now_), choices_(preferences, servo_, words_, settings),
      view_(settings, servo_, words_, choices_), walk_(settings, view_, words_),
      finger_(servo_, view_, words_, now_, settings.dwell_s), tour_(servo_, view_, finger_, words_, now_),
      zoom_(servo_, view_, finger_, tour_, words_, now_),
      ear_(servo_, view_, finger_, tour_, zoom_, choices_, words_, earcons, guide, now_),
      hand_(servo_, view_, finger_, tour_, ear_, words_, now_),
      device_(servo_, view_, finger_, tour_, ear_, choices_, words_, settings),
      touch_(servo_, view_, tour_, ear_, choices_, words_, device_, settings) {
    timer_.setInterval(poll_ms);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &ExploreSession::poll);
    connect(&view_, &ExploreView::replaced, this, &ExploreSession::stir);
    connect(&walk_, &ExploreWalk::setting_out, this, &ExploreSession::stop_everything);
    connect(&hand_, &ExploreHand::meant, this, &ExploreSession::perform);
    connect(&device_, &ExploreDevice::disabled, this, &ExploreSession::stop_everything);
    servo_.when_stirred([this] { stir(); });
    connect(&tour_, &ExploreTour::changed, this, [this] { servo_.stir(); }); // its names are told by the poll
    QCoreApplication::instance()->installEventFilter(this);
}

ExploreSession::~ExploreSession() { servo_.when_stirred({}); }

/// The texts are asked for anew in another language.
bool ExploreSession::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LanguageChange && watched == QCoreApplication::instance()) {
        view_.retranslate();
        emit finger_.featureChanged();
        emit device_.changed();
        emit touch_.changed();
        emit choices_.changed();
    }
    return QObject::eventFilter(watched, event);
}

void ExploreSession::enter() {
    const bool was_here = device_.here();
    away_ = false;
    servo_.wake();
    stir();
    words_.enter();
    ear_.enter();
    device_.enter();
    touch_.enter();
    if (was_here && view_.state() == ExploreView::State::Looking)
        return; // just told
    words_.tell(
        view_.ready()
            ? tr("Explore. %1 Move a finger over the picture; W says where it is.").arg(view_.where_one_is())
            : tr("Explore. %1").arg(view_.where_one_is()),
        Priority::message);
}

void ExploreSession::leave() {
    if (!device_.here())
        return;
    device_.leave();
    touch_.leave();
    stop_everything();
    ear_.leave();
    words_.leave();
    away_ = true;
    servo_.rest();
    follow_view();
}

void ExploreSession::follow_view() { view_.ready() && !away_ ? timer_.start() : timer_.stop(); }

// --- the photograph ---

void ExploreSession::open(const QUrl& file) {
    if (file.isLocalFile())
        open_file(file.toLocalFile());
    else
        words_.tellProblem(tr("Only a photograph that is a file on this computer can be opened."));
}

void ExploreSession::open_file(const QString& file) {
    stop_everything();
    view_.load(file);
}

QUrl ExploreSession::picturesFolder() const {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QUrl::fromLocalFile(QFileInfo(pictures).isDir() ? pictures : QDir::homePath());
}

void ExploreSession::stop_everything() {
    device_.disengage();
    tour_.end();
    ear_.hush();
    words_.hush();
}

bool ExploreSession::stop() {
    if (view_.state() == ExploreView::State::Looking) {
        const QString sentence = view_.give_up();
        stop_everything();
        words_.tell(sentence, Priority::touch);
        return true;
    }
    if (!view_.ready() || !(device_.engaged() || tour_.touring() || ear_.sounds())) {
        words_.hush();
        return false;
    }
    stop_everything();
    words_.tell(servo_.by_touch() ? tr("Stopped. Ticks are off. Press Enter to switch them on.")
                                  : tr("Stopped. The force is off. Press Enter to switch it on."),
                Priority::touch);
    return true;
}

void ExploreSession::stopOrStart() {
    if (!stop())
        device_.engage();
}

void ExploreSession::perform(TouchGestures::Gesture gesture) {
    using enum TouchGestures::Gesture;
    switch (gesture) {
    case none:
        return;
    case double_tap:
    case three_finger_tap:
        return finger_.whereAmI();
    case double_tap_and_hold: {
        const QPointF place = view_.frame().from_surface(finger_.felt_place());
        return zoom_.zoomHere(place.x(), place.y());
    }
    case two_finger_tap:
        toured_before_tap_ = tour_.touring();
        return stopOrStart();
    case two_finger_double_tap: // its first tap has stopped or started the force already
        if (toured_before_tap_)
            return;
        if (!device_.engaged())
            device_.engage();
        return tour_.toggle();
    case two_finger_swipe_right: // as in Browse, where one finger to the right is the next photograph
        return walk_.next();
    case two_finger_swipe_left:
        return walk_.previous();
    }
}

void ExploreSession::stir() {
    quiet_.stir();
    follow_view();
}

/// A finger that is only drawn, up for a while, with nothing left to tell: the threads of the servo end.
void ExploreSession::rest_where_quiet(const ServoSnapshot& seen, double now) {
    const bool quiet = finger_.up() && !tour_.touring() && device_.shows(seen.fault);
    if (!quiet_.due(quiet, now) || !servo_.park())
        return;
    timer_.stop();
    device_.watch(servo_.snapshot().fault, now); // of its last tick
}

void ExploreSession::poll() {
    const ServoSnapshot seen = servo_.snapshot();
    const double now = now_();
    finger_.poll(seen, now);
    device_.watch(seen.fault, now);
    touch_.watch();
    tour_.follow(seen.tour_progress, now);
    ear_.hear();
    rest_where_quiet(seen, now);
}

} // namespace tp
