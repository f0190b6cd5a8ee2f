// SPDX-License-Identifier: Apache-2.0
#include "app/photo/study_faces/folder_faces.hpp"
#include "core/experiment/experiment_file.hpp"
#include "places.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace tp;

namespace {

Experiment four_expressions(const char* faces = "set face: 1") {
    const auto read = read_experiment(std::string("experiment: faces\ntask: name\n"
                                                  "factor expression: smiling, surprised, sad, angry\n") +
                                      faces + "\nanswer: expression\n");
    return read ? *read : Experiment{};
}

/// Anna's four drawings and what else is wanted, in a folder of their own.
struct Folder {
    QTemporaryDir dir;
    std::filesystem::path path() const { return dir.path().toStdString(); }
    void add(const QString& sample, const QString& name) const {
        QVERIFY(QFile::copy(QString::fromStdString(test::in_source("resources/samples/")) + sample,
                            dir.filePath(name)));
    }
    void add_anna(const QString& ending = ".svg") const {
        for (const char* how : {"smiling", "surprised", "sad", "angry"})
            add(QString("anna_%1%2").arg(how, ending == ".svg" ? ".truth.svg" : ".jpg"),
                QString("anna_%1%2").arg(how, ending));
    }
};

} // namespace

class FolderFacesTest : public QObject {
    Q_OBJECT
private slots:
    void every_expression_of_a_person_is_taken_from_its_drawing() {
        const Folder folder;
        folder.add_anna();
        const auto faces = FolderFaces::read(folder.path(), four_expressions());
        QVERIFY2(bool(faces), faces ? "" : faces.error().c_str());
        QCOMPARE((*faces)->count(), std::size_t(4));
        const auto smiling = (*faces)->contours("smiling", "1"), sad = (*faces)->contours("sad", "1");
        QVERIFY(smiling && sad);
        QVERIFY(smiling->size() >= 4);
        QVERIFY(!(*faces)->contours("smiling", "2"));
        const Experiment experiment = four_expressions();
        QVERIFY(trial_of(experiment, {0, 0, false, 1}, faces->get()));
    }

    void a_photograph_is_felt_as_the_extraction_finds_it() {
        const Folder folder;
        folder.add_anna(".jpg");
        const auto faces = FolderFaces::read(folder.path(), four_expressions());
        QVERIFY2(bool(faces), faces ? "" : faces.error().c_str());
        QVERIFY((*faces)->contours("angry", "1")->size() >= 4);
    }

    void who_lacks_an_expression_is_left_out() {
        const Folder folder;
        folder.add_anna();
        folder.add("ben_smiling.truth.svg", "ben_smiling.svg");
        const auto faces = FolderFaces::read(folder.path(), four_expressions("factor face: 1, 2"));
        QVERIFY(!faces);
        QVERIFY2(faces.error().find("too few people with every expression: 1") != std::string::npos,
                 faces.error().c_str());
    }

    void a_folder_that_is_not_there_or_a_picture_without_a_face_is_said() {
        QVERIFY(!FolderFaces::read("/nowhere/at/all", four_expressions()));
        const Folder folder;
        folder.add_anna();
        QVERIFY(QFile::remove(folder.dir.filePath("anna_sad.svg")));
        QFile empty(folder.dir.filePath("anna_sad.jpg"));
        QVERIFY(empty.open(QIODevice::WriteOnly));
        empty.close();
        const auto faces = FolderFaces::read(folder.path(), four_expressions());
        QVERIFY(!faces);
        QVERIFY2(faces.error().find("anna_sad.jpg") != std::string::npos, faces.error().c_str());
    }

    void only_expressions_and_faces_need_a_folder() {
        QVERIFY(needs_faces(four_expressions()));
        const auto shapes =
            read_experiment("experiment: a\ntask: name\nfactor shape: circle, square\nanswer: shape\n");
        QVERIFY(shapes && !needs_faces(*shapes));
    }
};

QTEST_GUILESS_MAIN(FolderFacesTest)
#include "folder_faces_test.moc"
