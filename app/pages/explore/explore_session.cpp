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
      touch_(servo_, view_, tour_, ear_, choices_, words_, device_, settings),
      watch_(servo_, view_, finger_, tour_, ear_, device_, touch_, now_),
      gestures_(view_, walk_, finger_, tour_, zoom_, device_) {
    connect(&walk_, &ExploreWalk::setting_out, this, &ExploreSession::stop_everything);
    connect(&hand_, &ExploreHand::meant, &gestures_, &ExploreGestures::perform);
    connect(&gestures_, &ExploreGestures::stop_or_start_asked, this, &ExploreSession::stopOrStart);
    connect(&device_, &ExploreDevice::disabled, this, &ExploreSession::stop_everything);
    QCoreApplication::instance()->installEventFilter(this);
}

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
    watch_.enter();
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
    watch_.leave();
}

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

} // namespace tp
