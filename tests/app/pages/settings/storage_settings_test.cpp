// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/storage_settings.hpp"
#include "setting_ground.hpp"
#include "test_program.hpp"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <filesystem>

namespace storage_settings_test {

using namespace tp;

namespace {

struct StorageBench : SettingGround {
    QTemporaryDir kept;
    const QString calibrations = kept.filePath("calibrations.txt");
    int discarded = 0;
    StorageSettings storage{steps,
                            narrator,
                            {"/home/x/preferences.json", "/nowhere", [this] { ++discarded; }},
                            calibrations.toStdString()};

    void choose(const QString& folder) {
        storage.addFolder();
        QVERIFY(storage.choosing());
        storage.chooser()->begin_in(folder);
        storage.chooser()->choose();
        QVERIFY(!storage.choosing());
    }
};

} // namespace

class StorageSettingsTest : public QObject {
    Q_OBJECT
private slots:
    void folders_come_and_go_and_come_back() {
        const QTemporaryDir folder;
        StorageBench bench;
        bench.choose(folder.path());
        QCOMPARE(bench.storage.folders(), QStringList(QDir(folder.path()).absolutePath()));
        bench.choose(folder.path());
        QCOMPARE(bench.storage.folders().size(), 1);
        QCOMPARE(bench.last(), QString("This folder is already in the album."));
        for (const int index : {-1, 99})
            bench.storage.removeFolder(index);
        bench.storage.removeFolder(0);
        QVERIFY(bench.now().folders.isEmpty());
        QVERIFY(bench.last().contains("stay where they are"));
        bench.steps.undo();
        QCOMPARE(bench.now().folders.size(), 1);
    }
    void choosing_can_be_given_up() {
        StorageBench bench;
        QVERIFY(!bench.storage.cancel());
        bench.storage.addFolder();
        QVERIFY(bench.storage.cancel());
        QVERIFY(!bench.storage.choosing());
        QCOMPARE(bench.last(), QString("No folder was chosen."));
        bench.storage.addFolder();
        bench.storage.leave(); // without a word
        QVERIFY(!bench.storage.choosing());
    }
    void what_is_stored_is_said_and_the_index_can_go() {
        StorageBench bench;
        bench.preferences.change([](Choices& choices) {
            choices.folders = QStringList{"/photos"};
            choices.last_photo = "/photos/2.jpg";
        });
        const QString all = bench.storage.stored().join('\n');
        for (const char* part :
             {"preferences.json", "/nowhere", "/photos", "/photos/2.jpg", "Nothing leaves this computer"})
            QVERIFY2(all.contains(part), part);
        QVERIFY(!all.contains(bench.calibrations));
        QFile file(bench.calibrations);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(bench.storage.stored().join('\n').contains(bench.calibrations));
        bench.storage.discardIndex();
        QCOMPARE(bench.discarded, 1);
        QVERIFY(bench.last().contains("deleted when TouchPhoto ends"));
    }
};

} // namespace storage_settings_test

TP_TEST(storage_settings_test, StorageSettingsTest, event_loop)
#include "storage_settings_test.moc"
