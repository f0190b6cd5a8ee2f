// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "faces/base/face.hpp"

#include <QImage>
#include <QObject>
#include <QString>
#include <QThread>

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace tp {

class FaceExtractor;

/// A photograph with the faces that were found on it, corrections of people included.
struct FoundFaces {
    std::filesystem::path photo;
    QImage image;          ///< upright as the faces stand, shrunk; null where it could not be read
    Extraction extraction; ///< in pixels of the whole picture
};

/// How likely the contours of a photograph are wrong.
struct FaceJudgement {
    std::size_t faces = 0;
    double expected_error_percent =
        0.0;               ///< the worst of its contours, people's own left out; 0 without a face
    bool doubtful = false; ///< a reason is known why a face's contours may be wrong
    bool operator==(const FaceJudgement&) const = default;
};
FaceJudgement judgement_of(const Extraction& extraction);

/// Finds faces on a thread of its own: first those of the photograph that is wanted now, then, as time allows, of
/// those of which only a judgement is asked. What was found is remembered as long as the file and the corrections
/// beside it are as they were.
class FaceFinder final : public QObject {
    Q_OBJECT
public:
    using Find = std::function<FoundFaces(const std::filesystem::path&, const std::stop_token&)>;

    /// `find` is for tests; called on the finder's thread.
    explicit FaceFinder(Find find = {}, QObject* parent = nullptr);
    ~FaceFinder() override;

    /// `found` follows, unless a newer wish comes first.
    void want(const std::filesystem::path& photo);
    /// `judged` follows for each that is not judged yet, or whose file or corrections have changed since; replaces what was
    /// asked for before.
    void judge(std::deque<std::filesystem::path> photos);
    /// What was known last, without asking the disk whether it still holds.
    std::optional<FaceJudgement> last_judgement(const std::filesystem::path& photo) const;
    /// Photographs that still wait for their judgement.
    std::size_t left_to_judge() const { return to_judge_.size() + (judging_ ? 1 : 0); }

signals:
    void found(std::shared_ptr<const tp::FoundFaces> faces);
    void judged(const std::filesystem::path& photo);

private:
    struct Judged {
        std::string stamp;
        FaceJudgement judgement;
    };
    void go_on();
    void start(const std::filesystem::path& photo);
    void compare_stamps();
    void take(const std::string& stamp, std::shared_ptr<const FoundFaces> faces, bool stopped);

    Find find_;
    QThread thread_;
    QObject* worker_; ///< the place on thread_ where work is done; thread_ deletes it
    std::filesystem::path wanted_;
    std::deque<std::filesystem::path> to_judge_;
    std::deque<std::filesystem::path> to_compare_; ///< judged, and perhaps changed since
    bool comparing_ = false;                       ///< some of those
    unsigned wish_ = 0;             ///< of judgements, counted: what an earlier one asked for is dropped
    std::filesystem::path at_work_; ///< empty: nothing
    bool judging_ = false;          ///< at_work_ is only judged
    std::stop_source stop_;
    std::map<std::filesystem::path, Judged> judged_;
    std::deque<std::pair<std::string, std::shared_ptr<const FoundFaces>>>
        kept_; ///< the last few, with their stamps
};

} // namespace tp
