// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/write_sidecar.hpp"
#include "app/pages/explore/photo_loader.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace photo_loader_test {

using namespace tp;

namespace {
const QString samples = tp::test::in_source("resources/samples/");
}

class PhotoLoaderTest : public QObject {
    Q_OBJECT
private slots:
    void a_portrait() {
        PhotoLoader loader;
        std::shared_ptr<const LoadedPhoto> got;
        connect(&loader, &PhotoLoader::loaded, this, [&](auto photo) { got = photo; });
        loader.load(samples + "anna_smiling.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(got != nullptr, 60000);
        QCOMPARE(got->name, QString("anna_smiling.jpg"));
        QCOMPARE(got->image.size(), QSize(900, 1100));
        QCOMPARE(got->extraction.faces.size(), 1u);
    }
    void people_are_known_from_the_sidecar() {
        QTemporaryDir folder;
        const QString photo = folder.filePath("two.jpg");
        QVERIFY(QFile::copy(samples + "ben_and_clara.jpg", photo));
        PhotoLoader loader;
        std::shared_ptr<const LoadedPhoto> got;
        connect(&loader, &PhotoLoader::loaded, this, [&](auto one) { got = one; });
        loader.load(photo);
        QTRY_VERIFY_WITH_TIMEOUT(got != nullptr, 60000);
        QCOMPARE(got->names, (std::vector<QString>{"", ""}));
        const Extraction& found = got->extraction;
        const auto marked = [&](std::size_t face, const char* name) {
            const Rect& box = found.faces[face].box;
            return FaceRegion{box.centre().x / found.width, box.centre().y / found.height,
                              1.2 * box.width() / found.width, 1.3 * box.height() / found.height, name};
        };
        SidecarChanges changes;
        changes.faces = {marked(1, "Clara"), marked(0, "Ben")};
        QCOMPARE(write_sidecar(photo.toStdString(), changes), std::string());
        got.reset();
        loader.load(photo);
        QTRY_VERIFY_WITH_TIMEOUT(got != nullptr, 60000);
        QCOMPARE(got->names, (std::vector<QString>{"Ben", "Clara"}));
    }
    void only_the_newest_wish_is_answered() {
        PhotoLoader loader;
        QStringList answered;
        connect(&loader, &PhotoLoader::loaded, this, [&](auto photo) { answered << photo->name; });
        loader.load(samples + "anna_smiling.jpg");
        loader.load(samples + "ben_angry.jpg");
        loader.load(samples + "clara_sad.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(answered.contains("clara_sad.jpg"), 60000);
        QCOMPARE(answered, QStringList("clara_sad.jpg"));
    }
    void what_was_cancelled_is_not_answered() {
        PhotoLoader loader;
        QStringList answered;
        connect(&loader, &PhotoLoader::loaded, this, [&](auto photo) { answered << photo->name; });
        loader.load(samples + "anna_smiling.jpg");
        loader.cancel();
        loader.load(samples + "ben_angry.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(!answered.isEmpty(), 60000);
        QCOMPARE(answered, QStringList("ben_angry.jpg"));
    }
    void no_such_file() {
        PhotoLoader loader;
        std::shared_ptr<const LoadedPhoto> got;
        connect(&loader, &PhotoLoader::loaded, this, [&](auto photo) { got = photo; });
        loader.load("/nowhere/at all.jpg");
        QTRY_VERIFY_WITH_TIMEOUT(got != nullptr, 60000);
        QVERIFY(got->image.isNull());
        QVERIFY(!got->extraction.problem.empty());
    }
    void it_can_go_away_while_it_works() {
        PhotoLoader loader;
        loader.load(samples + "anna_smiling.jpg");
    }
};

} // namespace photo_loader_test

TP_TEST(photo_loader_test, PhotoLoaderTest, event_loop)
#include "photo_loader_test.moc"
