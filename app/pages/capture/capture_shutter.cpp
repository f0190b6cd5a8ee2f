// SPDX-License-Identifier: Apache-2.0
#include "app/pages/capture/capture_shutter.hpp"

#include "app/capture/camera/small_picture.hpp"
#include "app/photo/words/description.hpp"
#include "faces/extract/quick_faces.hpp"

#include <QDateTime>
#include <QLocale>

#include <system_error>
#include <utility>

namespace tp {

namespace {

constexpr int looked_at_px = 800; ///< longer side of what the page shows

PhotographFacts facts_now(const std::string& device) {
    PhotographFacts facts;
    facts.taken = QDateTime::currentDateTime();
    facts.model = device;
    return facts;
}

} // namespace

struct CaptureShutter::Nets {
    explicit Nets(std::shared_ptr<const KnownPeople> people) : look(std::move(people)) {}
    QuickFaces faces;
    TakenLook look;
};

/// On its way through the album's thread.
struct CaptureShutter::Work {
    std::shared_ptr<const Burst> burst;
    BurstOrder order;
    AlbumKeeper::AddedPhoto kept;
    QString words;
    quint64 run = 0;
};

CaptureShutter::CaptureShutter(CaptureAlbum& album, std::shared_ptr<const KnownPeople> people,
                               CaptureTeller& teller)
    : album_(album), teller_(teller), nets_(std::make_shared<Nets>(std::move(people))) {
    packing_.setMaxThreadCount(1);
    connect(&album_, &CaptureAlbum::changed, this, &CaptureShutter::changed);
}

void CaptureShutter::take(Moment moment) {
    if (taking_ || moment.frames.empty())
        return;
    forget();
    taking_ = true;
    device_ = moment.device;
    const auto work = std::make_shared<Work>();
    const double shutter_s = moment.frames.back().time_s;
    work->run = run_;
    work->burst = std::make_shared<const Burst>(std::move(moment.frames), moment.held, shutter_s);
    emit changed();
    album_.run(
        [work, nets = nets_, facts = facts_now(device_),
         language = QLocale().language()](AlbumKeeper&, PhotographStore& store) -> std::string {
            work->order = work->burst->choose(nets->faces);
            const cv::Mat best = work->burst->picture(work->order.frames.front());
            auto kept = store.keep(best, facts);
            if (!kept)
                return kept.error();
            work->kept = *kept;
            work->words = taken_words(taken_view(nets->look.see(best), language), language);
            return {};
        },
        [this, work](const QString& problem) { finish(work, problem); });
}

void CaptureShutter::finish(const std::shared_ptr<Work>& work, const QString& problem) {
    taking_ = false;
    if (!problem.isEmpty()) {
        emit changed();
        emit not_kept();
        return teller_.problem(problem);
    }
    photo_ = work->kept.photo;
    taken_ = work->words;
    if (work->run == run_) {
        burst_ = work->burst;
        order_ = work->order.frames;
        pack();
    }
    emit changed();
    emit touched(photo_);
    emit kept(photo_);
    teller_.did(Earcon::saved, taken_);
}

/// On a thread of its own, so that the next photograph does not wait for it.
void CaptureShutter::pack() {
    packing_.start([this, burst = burst_, run = run_] {
        const auto packed = std::make_shared<const Burst>(burst->packed());
        QMetaObject::invokeMethod(this, [this, packed, run] {
            if (run == run_)
                burst_ = packed;
        });
    });
}

void CaptureShutter::look(int step) {
    if (order_.size() < 2)
        return teller_.answer(tr("There is nothing to look through."));
    const int next = shown_ < 0 ? (step > 0 ? 1 : count() - 1) : shown_ + step;
    if (next < 0 || next >= count()) {
        teller_.sound(Earcon::list_end);
        return;
    }
    shown_ = next;
    const std::size_t frame = order_[static_cast<std::size_t>(next)];
    emit changed();
    teller_.sound(step > 0 ? Earcon::next : Earcon::previous);
    describe(frame);
}

void CaptureShutter::describe(std::size_t frame) {
    const auto words = std::make_shared<QString>();
    const auto small = std::make_shared<QImage>();
    const QString place = tr("Frame %1 of %2: %3.").arg(shown_ + 1).arg(count());
    album_.run(
        [words, small, nets = nets_, burst = burst_, frame,
         language = QLocale().language()](AlbumKeeper&, PhotographStore&) {
            const cv::Mat picture = burst->picture(frame);
            *small = small_picture(picture, looked_at_px);
            *words = short_description(taken_view(nets->look.see(picture), language), language);
            return std::string();
        },
        [this, words, small, place, run = run_, shown = shown_](const QString&) {
            if (run != run_ || shown != shown_)
                return;
            picture_ = *small;
            emit changed();
            teller_.answer(place.arg(*words));
        });
}

void CaptureShutter::keepShown() {
    if (shown_ < 0 || taking_)
        return;
    taking_ = true;
    const auto kept = std::make_shared<AlbumKeeper::AddedPhoto>();
    album_.run(
        [kept, burst = burst_, frame = order_[static_cast<std::size_t>(shown_)],
         facts = facts_now(device_)](AlbumKeeper&, PhotographStore& store) -> std::string {
            auto added = store.keep(burst->coded(frame), facts);
            if (!added)
                return added.error();
            *kept = *added;
            return {};
        },
        [this, kept](const QString& problem) {
            taking_ = false;
            emit changed();
            if (!problem.isEmpty())
                return teller_.problem(problem);
            photo_ = kept->photo;
            emit touched(photo_);
            teller_.did(Earcon::saved, tr("This one is kept too."));
        });
}

bool CaptureShutter::look_away() {
    if (shown_ < 0)
        return false;
    shown_ = -1;
    picture_ = {};
    emit changed();
    return true;
}

void CaptureShutter::undo() {
    if (!can_undo() || taking_)
        return teller_.answer(tr("There is nothing to undo."));
    album_.undo([this](const QString& what, const QString& problem) {
        if (!problem.isEmpty())
            return teller_.problem(problem);
        std::error_code error;
        emit touched(photo_);
        if (!std::filesystem::exists(photo_, error)) {
            photo_.clear();
            taken_.clear();
            emit changed();
        }
        teller_.did(Earcon::undone, tr("Undone: %1.").arg(what));
    });
}

void CaptureShutter::forget() {
    ++run_;
    look_away();
    burst_.reset();
    order_.clear();
    emit changed();
}

} // namespace tp
