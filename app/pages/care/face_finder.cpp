// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/face_finder.hpp"

#include "app/photo/picture/overlay.hpp"
#include "app/photo/scene/corrections.hpp"
#include "core/files/file_system.hpp"
#include "faces/decode/picture.hpp"
#include "faces/extract/face_extractor.hpp"

#include <QMetaObject>

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

namespace tp {

namespace fs = std::filesystem;

namespace {

constexpr int longest_side_px = 2000; ///< of the picture that crops are cut from
constexpr std::size_t most_kept = 3;

std::string file_stamp(const fs::path& file) {
    const auto facts = facts_of(file);
    return facts ? std::to_string(facts->bytes) + " " + std::to_string(facts->written_ns) : "-";
}

/// Of everything that what is found depends on.
std::string faces_stamp(const fs::path& photo) {
    return file_stamp(photo) + " / " + file_stamp(correction_file(photo));
}

/// Reads and finds with an extractor that is made at the first photograph.
class PictureFaces {
public:
    FoundFaces operator()(const fs::path& photo, const std::stop_token& stop) {
        FoundFaces faces;
        const Result<cv::Mat> picture = read_picture(photo);
        if (!picture) {
            faces.extraction.problem = picture.error();
            return faces;
        }
        if (!extractor_) {
            Result<FaceExtractor> made = FaceExtractor::create();
            if (!made) {
                faces.extraction.problem = made.error();
                return faces;
            }
            extractor_ = std::make_shared<FaceExtractor>(std::move(made).value());
        }
        faces.extraction = with_corrections(extractor_->extract(*picture, stop), photo);
        faces.image =
            to_image(not_larger_than(turned(*picture, faces.extraction.turned_degrees), longest_side_px));
        return faces;
    }

private:
    std::shared_ptr<FaceExtractor> extractor_;
};

} // namespace

FaceJudgement judgement_of(const Extraction& extraction) {
    FaceJudgement judgement;
    judgement.faces = extraction.faces.size();
    for (const Face& face : extraction.faces) {
        const auto placed_by_a_person = [&](std::size_t contour) {
            return contour < face.contours.size() &&
                   std::find(face.mended.begin(), face.mended.end(), face.contours[contour].name) !=
                       face.mended.end();
        };
        for (std::size_t i = 0; i < face.quality.size(); ++i)
            if (!placed_by_a_person(i))
                judgement.expected_error_percent =
                    std::max(judgement.expected_error_percent, face.quality[i].expected_error_percent);
        judgement.doubtful = judgement.doubtful || (!face.problem.empty() && face.mended.empty());
    }
    return judgement;
}

FaceFinder::FaceFinder(Find find, QObject* parent)
    : QObject(parent), find_(find ? std::move(find) : Find(PictureFaces())), worker_(new QObject) {
    thread_.setObjectName("care faces");
    worker_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, worker_, &QObject::deleteLater);
    thread_.start();
}

FaceFinder::~FaceFinder() {
    stop_.request_stop();
    thread_.quit();
    thread_.wait();
}

void FaceFinder::want(const fs::path& photo) {
    wanted_ = photo;
    if (photo.empty())
        return;
    const auto kept =
        std::find_if(kept_.begin(), kept_.end(), [&](const auto& one) { return one.second->photo == photo; });
    if (kept != kept_.end() && kept->first == faces_stamp(photo)) {
        wanted_.clear();
        emit found(kept->second);
        return;
    }
    if (!at_work_.empty() && at_work_ != photo)
        stop_.request_stop(); // nothing takes the time of the one that a person waits for
    go_on();
}

void FaceFinder::judge(std::deque<fs::path> photos) {
    ++wish_;
    to_judge_.clear();
    to_compare_.clear();
    for (fs::path& photo : photos)
        if (!judging_ || photo != at_work_)
            (judged_.contains(photo) ? to_compare_ : to_judge_).push_back(std::move(photo));
    go_on();
}

/// The disk may be slow, so it is asked on the finder's thread.
void FaceFinder::compare_stamps() {
    constexpr std::size_t at_a_time = 200; // a wish of a person waits for no more
    std::vector<std::pair<fs::path, std::string>> known;
    while (!to_compare_.empty() && known.size() < at_a_time) {
        if (const auto judged = judged_.find(to_compare_.front()); judged != judged_.end())
            known.emplace_back(judged->first, judged->second.stamp);
        to_compare_.pop_front();
    }
    comparing_ = true;
    QMetaObject::invokeMethod(worker_, [this, known = std::move(known), wish = wish_] {
        std::vector<fs::path> changed;
        for (const auto& [photo, stamp] : known)
            if (faces_stamp(photo) != stamp)
                changed.push_back(photo);
        QMetaObject::invokeMethod(this, [this, changed = std::move(changed), wish] {
            comparing_ = false;
            if (wish == wish_)
                to_judge_.insert(to_judge_.end(), changed.begin(), changed.end());
            go_on();
        });
    });
}

std::optional<FaceJudgement> FaceFinder::last_judgement(const fs::path& photo) const {
    const auto known = judged_.find(photo);
    return known == judged_.end() ? std::nullopt : std::optional(known->second.judgement);
}

void FaceFinder::go_on() {
    if (!at_work_.empty() || comparing_)
        return;
    judging_ = wanted_.empty();
    if (!judging_) {
        start(wanted_);
    } else if (!to_compare_.empty()) {
        judging_ = false;
        compare_stamps();
    } else if (!to_judge_.empty()) {
        const fs::path next = to_judge_.front();
        to_judge_.pop_front();
        start(next);
    } else {
        judging_ = false;
    }
}

void FaceFinder::start(const fs::path& photo) {
    at_work_ = photo;
    stop_ = std::stop_source();
    QMetaObject::invokeMethod(worker_, [this, photo, stop = stop_.get_token()] {
        auto faces = std::make_shared<FoundFaces>();
        const std::string stamp = faces_stamp(photo); // before it is read: a change meanwhile shows
        try {
            *faces = find_(photo, stop);
        } catch (const std::exception&) { // out of memory, mostly
            faces->extraction = {};
            faces->extraction.problem =
                "This picture could not be worked on. It may be too large for this computer.";
        }
        faces->photo = photo;
        const bool stopped = stop.stop_requested();
        QMetaObject::invokeMethod(this, [this, stamp, faces, stopped] { take(stamp, faces, stopped); });
    });
}

void FaceFinder::take(const std::string& stamp, std::shared_ptr<const FoundFaces> faces, bool stopped) {
    const bool again = std::exchange(judging_, false) && stopped;
    at_work_.clear();
    if (!stopped) {
        judged_[faces->photo] = {stamp, judgement_of(faces->extraction)};
        std::erase_if(kept_, [&](const auto& one) { return one.second->photo == faces->photo; });
        kept_.emplace_front(stamp, faces);
        if (kept_.size() > most_kept)
            kept_.pop_back();
        if (faces->photo == wanted_) {
            wanted_.clear();
            emit found(faces);
        }
        emit judged(faces->photo);
    } else if (again) {
        to_judge_.push_front(faces->photo);
    }
    go_on();
}

} // namespace tp
