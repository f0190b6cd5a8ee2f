// SPDX-License-Identifier: Apache-2.0
#include "album_parts.hpp"
#include "app/pages/care/face_finder.hpp"
#include "test_program.hpp"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <mutex>
#include <stdexcept>

namespace face_finder_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

Extraction extraction_with(double error, const std::string& problem = {}) {
    Extraction extraction;
    extraction.width = 100;
    extraction.height = 100;
    Face face;
    face.problem = problem;
    face.contours = {Contour{feature::left_eye, {}, false}, Contour{feature::outline, {}, false}};
    face.quality = {{error, {}}, {0.2, {}}};
    extraction.faces.push_back(face);
    return extraction;
}

/// Remembers what it was asked for; a photograph named "slow" waits until it is stopped or let go.
struct Finder {
    std::mutex mutex;
    std::vector<std::string> asked;
    QSemaphore begun, go;
    FaceFinder finder{[this](const fs::path& photo, const std::stop_token& stop) {
        {
            const std::lock_guard lock(mutex);
            asked.push_back(photo.filename().string());
        }
        if (photo.filename() == "slow.jpg") {
            begun.release();
            while (!stop.stop_requested() && !go.tryAcquire(1, 1)) {
            }
        }
        if (photo.filename() == "throws.jpg")
            throw std::runtime_error("no memory");
        return FoundFaces{{}, QImage(10, 10, QImage::Format_RGB32), extraction_with(1.5)};
    }};
    QSignalSpy found{&finder, &FaceFinder::found};
    QSignalSpy judged{&finder, &FaceFinder::judged};

    std::vector<std::string> order() {
        const std::lock_guard lock(mutex);
        return asked;
    }
};

using Names = std::vector<std::string>;

} // namespace

class FaceFinderTest : public QObject {
    Q_OBJECT
private slots:
    void the_judgement_is_the_worst_contour_that_no_person_placed() {
        Extraction extraction = extraction_with(2.5);
        QCOMPARE(judgement_of(extraction), (FaceJudgement{1, 2.5, false}));
        extraction.faces[0].mended = {feature::left_eye};
        QCOMPARE(judgement_of(extraction), (FaceJudgement{1, 0.2, false}));
        QCOMPARE(judgement_of(extraction_with(1.0, "The head is turned.")), (FaceJudgement{1, 1.0, true}));
        QCOMPARE(judgement_of({}), (FaceJudgement{0, 0.0, false}));
    }

    void a_wanted_photograph_is_found_and_kept() {
        const AlbumFolder folder;
        const fs::path photo = a_photo(folder, "a.jpg", 1);
        Finder bench;
        bench.finder.want(photo);
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 1, 60'000);
        bench.finder.want(photo);
        QCOMPARE(bench.found.size(), 2);
        QCOMPARE(bench.order(), Names{"a.jpg"});
        QCOMPARE(bench.finder.last_judgement(photo), (FaceJudgement{1, 1.5, false}));
    }

    void corrections_beside_it_make_it_looked_at_again() {
        const AlbumFolder folder;
        const fs::path photo = a_photo(folder, "a.jpg", 1);
        Finder bench;
        bench.finder.want(photo);
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 1, 60'000);
        folder.write("a.jpg.contours.svg", "<svg/>");
        QVERIFY(bench.finder.last_judgement(photo).has_value());
        bench.finder.want(photo);
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 2, 60'000);
        QCOMPARE(bench.order(), (Names{"a.jpg", "a.jpg"}));
    }

    void only_what_has_changed_since_is_judged_again() {
        const AlbumFolder folder;
        std::deque<fs::path> photos;
        for (int i = 0; i < 450; ++i) // more than are compared at a time
            photos.push_back(a_photo(folder, "p" + std::to_string(i) + ".jpg", i % 200));
        Finder bench;
        bench.finder.judge(photos);
        QTRY_COMPARE_WITH_TIMEOUT(bench.judged.size(), 450, 60'000);
        folder.write("p3.jpg.contours.svg", "<svg/>");
        folder.write("p449.jpg.contours.svg", "<svg/>");
        bench.finder.judge(photos);
        QTRY_COMPARE_WITH_TIMEOUT(bench.judged.size(), 452, 60'000);
        bench.finder.want(a_photo(folder, "last.jpg", 1)); // comes when all has been compared, or between
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 1, 60'000);
        const Names asked = bench.order();
        QCOMPARE(asked.size(), std::size_t{453});
        QCOMPARE(Names(asked.begin() + 450, asked.end()), (Names{"p3.jpg", "p449.jpg", "last.jpg"}));
        bench.finder.judge(photos);
        bench.finder.judge({});
        folder.write("p5.jpg.contours.svg", "<svg/>");
        bench.finder.judge({photos[5]});
        QTRY_COMPARE_WITH_TIMEOUT(bench.judged.size(), 454, 60'000);
        QCOMPARE(bench.order().back(), std::string("p5.jpg"));
        QCOMPARE(bench.finder.left_to_judge(), std::size_t{0});
    }

    void the_photograph_that_a_person_waits_for_goes_before_all_judgements() {
        const AlbumFolder folder;
        const fs::path slow = a_photo(folder, "slow.jpg", 1), b = a_photo(folder, "b.jpg", 2),
                       c = a_photo(folder, "c.jpg", 3);
        Finder bench;
        bench.finder.judge({slow, b});
        bench.begun.acquire();
        QCOMPARE(bench.finder.left_to_judge(), std::size_t{2});
        bench.finder.want(c);
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 1, 60'000);
        bench.go.release();
        QTRY_COMPARE_WITH_TIMEOUT(bench.judged.size(), 3, 60'000);
        QCOMPARE(bench.order(),
                 (Names{"slow.jpg", "c.jpg", "slow.jpg", "b.jpg"})); // the stopped one comes again
        QCOMPARE(bench.finder.left_to_judge(), std::size_t{0});
    }

    void only_the_newest_wish_is_answered() {
        const AlbumFolder folder;
        const fs::path slow = a_photo(folder, "slow.jpg", 1), b = a_photo(folder, "b.jpg", 2);
        Finder bench;
        bench.finder.want(slow);
        bench.begun.acquire();
        bench.finder.want(b);
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 1, 60'000);
        QCOMPARE(bench.found.at(0).at(0).value<std::shared_ptr<const FoundFaces>>()->photo, b);
        bench.finder.want({});
        QCOMPARE(bench.order(), (Names{"slow.jpg", "b.jpg"}));
    }

    void a_picture_that_breaks_the_search_is_a_sentence_and_the_next_one_is_found() {
        const AlbumFolder folder;
        Finder bench;
        bench.finder.want(a_photo(folder, "throws.jpg", 1));
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 1, 60'000);
        QVERIFY(
            !bench.found.at(0).at(0).value<std::shared_ptr<const FoundFaces>>()->extraction.problem.empty());
        bench.finder.want(a_photo(folder, "b.jpg", 2));
        QTRY_COMPARE_WITH_TIMEOUT(bench.found.size(), 2, 60'000);
    }

    void the_real_search_says_what_is_wrong_with_a_file() {
        const AlbumFolder folder;
        FaceFinder finder;
        QSignalSpy found(&finder, &FaceFinder::found);
        finder.want(folder.write("no.jpg", "no picture"));
        QTRY_COMPARE_WITH_TIMEOUT(found.size(), 1, 60'000);
        QVERIFY(!found.at(0).at(0).value<std::shared_ptr<const FoundFaces>>()->extraction.problem.empty());
    }
};

} // namespace face_finder_test

TP_TEST(face_finder_test, FaceFinderTest, event_loop)
#include "face_finder_test.moc"
