// SPDX-License-Identifier: Apache-2.0
// What is weighed against time must be weighed rightly. No time is asserted.
#include "app/figures/bench/face_bench.hpp"
#include "places.hpp"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace tp;

namespace {

void nobody(const std::string&) {}

const std::filesystem::path shared_faces = std::filesystem::path(tp::test::in_shared("faces"));

/// A few people with contours placed by hand; none where the portraits are not there.
std::vector<PlacedPortrait> some_people(std::size_t count) {
    auto people = read_placed_truth(shared_faces / "photos/london_truth.json", shared_faces / "photos");
    if (!people)
        return {};
    people->resize(std::min(count, people->size()));
    return *people;
}

} // namespace

class FaceBenchTest : public QObject {
    Q_OBJECT
private slots:
    void smaller_pictures_cost_accuracy_and_nets_alone_are_farther_off() {
        const std::vector<PlacedPortrait> people = some_people(16);
        if (people.empty())
            QSKIP("needs ../shared/faces/photos/london_truth.json");
        const std::vector<FaceContender> all = face_contenders();
        QVERIFY(all.size() >= 2);
        const auto rows = run_face_bench(people, {all[0], all[1]}, {0, 160}, nobody);
        QVERIFY2(rows.ok(), rows.error().c_str());
        QCOMPARE(rows->size(), std::size_t(4));
        for (const FaceBenchRow& row : *rows) {
            QCOMPARE(row.photos, 16);
            QCOMPARE(row.failures, 0);
            QVERIFY(row.decode_ms > 0.0 && row.detect_ms > 0.0 && row.landmarks_ms > 0.0);
            QVERIFY(row.worst_percent >= row.mean_error_percent());
        }
        const FaceBenchRow &whole = (*rows)[0], &small = (*rows)[1], &bare = (*rows)[2];
        QCOMPARE(whole.contender, std::string("embedded"));
        QVERIFY(whole.mean_error_percent() < 1.2);
        QVERIFY(small.mean_error_percent() > whole.mean_error_percent());
        QVERIFY(bare.error_percent[2] > whole.error_percent[2]); // the edges of the inner lip

        const QTemporaryDir folder;
        const std::filesystem::path out = folder.path().toStdString();
        QVERIFY(write_face_table(out, *rows).ok() && plot_faces(out, *rows).ok());
        QVERIFY(!QImage(folder.filePath("faces.png")).isNull());
        QFile csv(folder.filePath("faces.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll().count('\n'), qsizetype(5));
    }

    void each_refinement_costs_time_and_gains_accuracy() {
        const std::vector<PlacedPortrait> people = some_people(12);
        if (people.empty())
            QSKIP("needs ../shared/faces/photos/london_truth.json");
        std::vector<FaceContender> own = face_contenders();
        std::erase_if(own, [](const FaceContender& c) { return !c.name.starts_with("embedded"); });
        const auto rows = run_face_bench(people, own, {0}, nobody);
        QVERIFY2(rows.ok(), rows.error().c_str());
        const char* const names[] = {"embedded", "embedded_without_edges", "embedded_two_looks",
                                     "embedded_one_look"};
        QCOMPARE(rows->size(), std::size(names));
        for (std::size_t r = 0; r < rows->size(); ++r) {
            const FaceBenchRow& row = (*rows)[r];
            QCOMPARE(row.contender, std::string(names[r]));
            QCOMPARE(row.photos, 12);
            QCOMPARE(row.failures, 0);
            if (r > 0)
                QVERIFY2(row.mean_error_percent() > (*rows)[r - 1].mean_error_percent(), names[r]);
        }
    }

    /// A drawn portrait; its truth is what the embedded nets find in it.
    void the_face_mesh_has_rows_beside_ours() {
        const std::filesystem::path photo = tp::test::in_source("resources/samples/anna_smiling.jpg");
        const Extraction own = FaceExtractor::create().value().extract(photo);
        QCOMPARE(own.faces.size(), std::size_t(1));
        const std::vector<PlacedPortrait> portraits{{photo, own.faces[0].contours}};
        std::vector<FaceContender> others = face_contenders();
        std::erase_if(others, [](const FaceContender& c) { return c.name.starts_with("embedded"); });
        const char* const names[] = {"yunet_and_embedded", "mesh", "mesh_without_edges"};
        const auto rows = run_face_bench(portraits, others, {0}, nobody);
        QVERIFY2(rows.ok(), rows.error().c_str());
        QCOMPARE(rows->size(), std::size(names));
        for (std::size_t r = 0; r < rows->size(); ++r) {
            const FaceBenchRow& row = (*rows)[r];
            QCOMPARE(row.contender, std::string(names[r]));
            QCOMPARE(row.photos, 1);
            QVERIFY(row.detect_ms > 0.0);
        }
        const QTemporaryDir out;
        QVERIFY(write_face_table(out.path().toStdString(), *rows).ok());
        QVERIFY(plot_faces(out.path().toStdString(), *rows).ok());
        QFile csv(out.filePath("faces.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QByteArray table = csv.readAll();
        for (const FaceBenchRow& row : *rows)
            QVERIFY(table.contains('\n' + QByteArray::fromStdString(row.contender) + ",0,1,"));
    }

    void portraits_made_harder_are_compared_way_by_way() {
        const std::vector<PlacedPortrait> people = some_people(1);
        if (people.empty())
            QSKIP("needs ../shared/faces/photos/london_truth.json");
        const std::vector<FaceContender> all = face_contenders();
        const auto rows = run_harder_bench(people, {all[0], all[1]}, nobody);
        QVERIFY2(rows.ok(), rows.error().c_str());
        QVERIFY(rows->size() > 20 && rows->size() % 2 == 0);
        double plain = -1.0, blurred = -1.0;
        bool opened = false, shut = false;
        for (std::size_t i = 0; i < rows->size(); i += 2) {
            const HarderRow &own = (*rows)[i], &bare = (*rows)[i + 1];
            QCOMPARE(own.how, bare.how);
            QVERIFY(own.contender == "embedded" && bare.contender == "embedded_without_edges");
            QVERIFY(own.photos == 1 && own.found <= 1 && own.said <= own.found && own.failures <= 1);
            opened = opened || own.how.starts_with("mouth opened");
            shut = shut || own.how.starts_with("eyes shut");
            plain = own.how == "as it is" ? own.error_percent[0] : plain;
            blurred = own.how == "blur 50 ‰" ? own.error_percent[0] : blurred;
        }
        QVERIFY(opened && shut && plain > 0.0 && blurred > plain);
        const QTemporaryDir folder;
        QVERIFY(write_harder_table(folder.path().toStdString(), *rows).ok());
        QFile csv(folder.filePath("harder.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll().count('\n'), static_cast<qsizetype>(rows->size() + 1));
        QVERIFY(run_harder_bench({{"no/such/photo.jpg", {}}}, {all[0]}, nobody)
                    .error()
                    .find("no/such/photo.jpg") != std::string::npos);
    }

    void a_batch_takes_every_photograph() {
        const std::vector<PlacedPortrait> people = some_people(3);
        if (people.empty())
            QSKIP("needs ../shared/faces/photos/london_truth.json");
        const auto speeds = run_batch_bench(people);
        QVERIFY2(speeds.ok(), speeds.error().c_str());
        QCOMPARE(speeds->size(), std::size_t(2));
        QCOMPARE(speeds->front().threads, std::size_t(1));
        for (const BatchSpeed& speed : *speeds)
            QVERIFY(speed.photos_per_s > 0.0);
    }

    void a_photograph_that_is_missing_is_said() {
        const auto rows = run_face_bench({{"no/such/photo.jpg", {}}}, {{"embedded", {}}}, {0}, nobody);
        QVERIFY(rows.error().find("no/such/photo.jpg") != std::string::npos);
    }

    void a_model_that_is_missing_is_said() {
        QVERIFY(!run_face_bench({}, {{"other", {"embedded", "magic"}}}, {0}, nobody).error().empty());
    }
};

QTEST_MAIN(FaceBenchTest)
#include "face_bench_test.moc"
