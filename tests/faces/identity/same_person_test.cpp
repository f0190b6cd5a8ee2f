// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"
#include "faces/evaluation/contour_error.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/identity/face_describer.hpp"
#include "faces/identity/face_groups.hpp"
#include "faces/identity/same_person.hpp"
#include "faces/identity/unfit.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace same_person_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Portrait {
    std::string person;
    FaceNumbers numbers{};
    Unfit unfit = Unfit::no;
};

fs::path london() { return portraits::folder() / "photos/london"; }

/// Share of the pairs that are taken for what they are not, percent: of one person's, the farther ones; of others', the
/// nearer ones; where both are as large.
double equal_error_percent(const std::vector<Portrait>& some, const std::vector<Portrait>& others) {
    std::vector<std::pair<double, bool>> pairs; // distance, and whether of one person
    double same = 0.0, different = 0.0;
    for (const Portrait& one : some)
        for (const Portrait& other : others) {
            pairs.emplace_back(distance(one.numbers, other.numbers), one.person == other.person);
            (pairs.back().second ? same : different) += 1.0;
        }
    std::ranges::sort(pairs);
    double refused = same, accepted = 0.0;
    for (const auto& [_, is_same] : pairs) {
        (is_same ? refused : accepted) += is_same ? -1.0 : 1.0;
        if (accepted / different >= refused / same)
            break;
    }
    return 50.0 * (accepted / different + refused / same);
}

} // namespace

/// People of the London set, neutral (_03) and smiling (_08).
class SamePersonTest : public QObject {
    Q_OBJECT

    FaceExtractor extractor_ = std::move(FaceExtractor::create()).value();
    FaceDescriber describer_;
    std::vector<Portrait> neutral_, smiling_, small_, blurred_;

    std::optional<Portrait> described(const cv::Mat& picture, const std::string& person) {
        const Extraction found = extractor_.extract(picture);
        if (found.faces.empty())
            return std::nullopt;
        const auto numbers = describer_.describe(picture, found.faces.front());
        return numbers ? std::optional(
                             Portrait{person, *numbers, unfit_for_guessing(picture, found.faces.front())})
                       : std::nullopt;
    }

private slots:
    void initTestCase() {
        NEEDS_PORTRAITS();
        std::set<fs::path> files;
        for (const auto& entry : fs::directory_iterator(london()))
            files.insert(entry.path());
        for (const fs::path& file : files) {
            const std::string name = file.stem().string();
            const cv::Mat picture = portraits::one(("london/" + name + ".jpg").c_str());
            const auto portrait = described(picture, name.substr(0, 3));
            QVERIFY2(portrait, name.c_str());
            (name.ends_with("_03") ? neutral_ : smiling_).push_back(*portrait);
            if (!name.ends_with("_08"))
                continue;
            const Face face = extractor_.extract(picture).faces.at(0);
            const double scale = 40.0 / std::max(face.box.width(), face.box.height());
            cv::Mat shrunk;
            cv::resize(picture, shrunk, {}, scale, scale, cv::INTER_AREA);
            const auto small = described(shrunk, name.substr(0, 3));
            QVERIFY2(small, name.c_str());
            small_.push_back(*small);
            cv::Mat soft;
            cv::GaussianBlur(picture, soft, {}, 0.05 * outer_inter_ocular_distance(face.contours));
            const auto blurred = described(soft, name.substr(0, 3));
            QVERIFY2(blurred, name.c_str());
            blurred_.push_back(*blurred);
        }
        QVERIFY(neutral_.size() == 68 && smiling_.size() == 68);
    }
    void smiling_people_are_known() { QVERIFY(equal_error_percent(neutral_, smiling_) <= 0.01); }
    void faces_of_40_px_are_known() {
        const double percent = equal_error_percent(neutral_, small_);
        QVERIFY2(percent <= 0.1, std::to_string(percent).c_str());
        for (const Portrait& portrait : small_)
            QVERIFY(portrait.unfit == Unfit::no);
    }
    void heavily_blurred_people_are_known_though_nobody_guesses() {
        const double percent = equal_error_percent(neutral_, blurred_);
        QVERIFY2(percent <= 0.1, std::to_string(percent).c_str());
        QVERIFY(std::ranges::count(blurred_, Unfit::blurred, &Portrait::unfit) >= 60);
    }
    void a_byte_a_number_is_as_good() {
        for (auto* const portraits : {&neutral_, &smiling_})
            for (Portrait& portrait : *portraits) {
                const FaceDescriptor bytes = *descriptor_of(portrait.numbers);
                for (std::size_t i = 0; i < bytes.size(); ++i)
                    QVERIFY(std::abs(bytes[i] * descriptor_step - static_cast<double>(portrait.numbers[i])) <=
                            0.5 * descriptor_step + 1e-9); // none was too large for a byte
            }
        double most = 0.0;
        for (const Portrait& one : neutral_)
            for (const Portrait& other : smiling_)
                most = std::max(
                    most, std::abs(distance(one.numbers, other.numbers) -
                                   distance(*descriptor_of(one.numbers), *descriptor_of(other.numbers))));
        QVERIFY2(most < 0.015, std::to_string(most).c_str());
    }
    void each_group_is_one_person_and_each_person_one_group() {
        FaceGroups groups;
        std::map<FaceId, std::string> who;
        for (const auto* const portraits : {&neutral_, &smiling_})
            for (const Portrait& portrait : *portraits) {
                QVERIFY(portrait.unfit == Unfit::no);
                ComingFace face;
                face.id = face.photo = static_cast<FaceId>(who.size());
                face.descriptor = *descriptor_of(portrait.numbers);
                who[face.id] = portrait.person;
                QVERIFY(groups.add({face}));
            }
        for (const FaceGroup& group : groups.groups())
            for (const FaceId face : group.faces)
                QCOMPARE(who[face], who[group.faces[0]]);
        QVERIFY2(groups.groups().size() <= 71,
                 std::to_string(groups.groups().size()).c_str()); // 1.05 a person
    }
};

} // namespace same_person_test

TP_TEST(same_person_test, SamePersonTest, event_loop)
#include "same_person_test.moc"
