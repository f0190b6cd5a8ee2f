// SPDX-License-Identifier: Apache-2.0
#include "drawn_pictures.hpp"
#include "effort.hpp"
#include "faces/extract/face_extractor.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <map>
#include <vector>

namespace detection_rate_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> every(int stride, const char* set) {
    std::vector<fs::path> all, chosen;
    for (const auto& entry : fs::directory_iterator(portraits::folder() / "photos" / set))
        all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(stride))
        chosen.push_back(all[i]);
    return chosen;
}

} // namespace

/// How many faces are found, how many found that are none: printed, with loose bounds.
class DetectionRateTest : public QObject {
    Q_OBJECT

private slots:
    void official_portraits_data() {
        QTest::addColumn<QString>("set");
        QTest::addColumn<int>("stride");
        QTest::newRow("congress") << "congress" << 9;
        QTest::newRow("ukmp") << "ukmp" << 15;
    }
    /// Exactly one face in the picture, none in what is left below its chin.
    void official_portraits() {
        NEEDS_PORTRAITS();
        QFETCH(QString, set);
        QFETCH(int, stride);
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        int pictures = 0, one = 0, problems = 0, below = 0, alarms = 0;
        for (const fs::path& file : every(stride, qPrintable(set))) {
            const auto picture = read_picture(file);
            QVERIFY2(picture.ok(), picture.error().c_str());
            const Extraction found = faces.extract(*picture);
            ++pictures;
            one += found.faces.size() == 1;
            problems += !found.problem.empty();
            const int chin =
                found.faces.empty() ? picture->rows : static_cast<int>(found.faces[0].box.max.y) + 10;
            if (picture->rows - chin < 30)
                continue;
            ++below;
            alarms += !faces.extract(picture->rowRange(chin, picture->rows)).faces.empty();
        }
        qInfo("%s: one face in %d of %d, problems in %d; below the chin %d false alarms in %d",
              qPrintable(set), one, pictures, problems, alarms, below);
        QVERIFY(one >= pictures * 97 / 100);
        QVERIFY(alarms <= below / 50);
    }

    /// Noise, clouds, shapes, stripes, bricks, wood, dots, cells, marble, leaves and letters, of every size
    /// and colour.
    void pictures_without_a_face_give_none() {
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        cv::RNG random(2);
        const std::vector<int> thirds = tp::test::thirds();
        int alarms = 0, pictures = 0;
        for (int round = 0; round < 77; ++round) {
            const cv::Size size(random.uniform(200, 700), random.uniform(200, 600));
            std::vector<cv::Mat> drawn = drawn::without_faces(random, size);
            for (cv::Mat& texture : drawn::textures(random, size))
                drawn.push_back(std::move(texture));
            if (std::ranges::count(thirds, round % 3) == 0)
                continue;
            for (const cv::Mat& picture : drawn) {
                ++pictures;
                alarms += !faces.extract(picture).faces.empty();
            }
        }
        qInfo("%d false alarms in %d pictures without a face", alarms, pictures);
        QVERIFY(alarms < static_cast<int>(thirds.size())); // two in a thousand
    }

    /// On their side and on their head, and nothing in the file about it.
    void turned_portraits() {
        NEEDS_PORTRAITS();
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        int pictures = 0, upright = 0;
        for (const fs::path& file : every(54, "congress")) {
            const cv::Mat portrait = *read_picture(file);
            for (const int degrees : {90, 180, 270}) {
                const Extraction found = faces.extract(turned(portrait, degrees));
                ++pictures;
                upright += found.faces.size() == 1 && found.turned_degrees == 360 - degrees;
            }
        }
        qInfo("turned portraits: stood upright again %d of %d", upright, pictures);
        QVERIFY(upright >= pictures * 95 / 100);
    }

    void small_faces_in_large_pictures_data() {
        QTest::addColumn<int>("face_px");
        QTest::addColumn<int>("longer_px");
        QTest::addColumn<int>("stride");
        for (int px : {20, 30, 40, 60, 100})
            QTest::addRow("%d px", px) << px << 1800 << 20;
        QTest::addRow("40 px in 50 megapixel") << 40 << 8165 << 90;
    }
    /// Portraits whose faces are `face_px` wide somewhere in clouds, four by three, one in each quarter.
    void small_faces_in_large_pictures() {
        NEEDS_PORTRAITS();
        QFETCH(int, face_px);
        QFETCH(int, longer_px);
        QFETCH(int, stride);
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        cv::RNG random(3);
        int pictures = 0, portraits = 0, found_there = 0, elsewhere = 0, named_small = 0;
        auto& lone = lone_[stride];
        if (lone.empty())
            lone = lone_faces(faces, stride);
        for (std::size_t first = 0; first < lone.size(); first += 4) {
            cv::Mat picture = drawn::clouds(random, {longer_px, longer_px * 3 / 4}, 80);
            std::vector<Vec2> centres;
            for (std::size_t i = first; i < std::min(first + 4, lone.size()); ++i) {
                const int quarter = static_cast<int>(i - first);
                centres.push_back(hidden(lone[i], face_px, quarter, random, picture));
            }
            ++pictures;
            portraits += static_cast<int>(centres.size());
            for (const Face& face : faces.extract(picture).faces) {
                const auto there = std::find_if(centres.begin(), centres.end(), [&](Vec2 centre) {
                    return length(face.box.centre() - centre) < 0.5 * face_px;
                });
                if (there == centres.end()) {
                    ++elsewhere;
                    continue;
                }
                centres.erase(there); // found twice it counts as elsewhere
                ++found_there;
                named_small += !face.problem.empty();
            }
        }
        qInfo("%d px: found %d of %d, said to be too small %d, false alarms %d in %d pictures", face_px,
              found_there, portraits, named_small, elsewhere, pictures);
        QVERIFY(elsewhere <= 1);
        if (face_px >= 40)
            QVERIFY(found_there >= portraits * 9 / 10);
    }

private:
    struct LoneFace {
        cv::Mat portrait;
        Rect box; ///< px of the portrait
    };

    /// Of every `stride`th portrait those in which one face is found.
    static std::vector<LoneFace> lone_faces(FaceExtractor& faces, int stride) {
        std::vector<LoneFace> lone;
        for (const fs::path& file : every(stride, "congress")) {
            const cv::Mat portrait = *read_picture(file);
            const Extraction found = faces.extract(portrait);
            if (found.faces.size() == 1)
                lone.push_back({portrait, found.faces[0].box});
        }
        return lone;
    }

    /// Puts the portrait, its face `face_px` wide, somewhere into a quarter (0 … 3) of the picture. The
    /// face's centre there, px.
    static Vec2 hidden(const LoneFace& lone, int face_px, int quarter, cv::RNG& random, cv::Mat& picture) {
        const double scale = face_px / lone.box.width();
        cv::Mat small;
        cv::resize(lone.portrait, small, {}, scale, scale, cv::INTER_AREA);
        const int width = picture.cols / 2, height = picture.rows / 2;
        const cv::Point at(quarter % 2 * width + random.uniform(0, width - small.cols),
                           quarter / 2 * height + random.uniform(0, height - small.rows));
        small.copyTo(picture(cv::Rect(at, small.size())));
        return lone.box.centre() * scale + Vec2(at.x, at.y);
    }

    std::map<int, std::vector<LoneFace>> lone_; ///< by stride: each row looks for the same faces
};

} // namespace detection_rate_test

TP_TEST(detection_rate_test, DetectionRateTest, event_loop)
#include "detection_rate_test.moc"
