// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/recording_announcer.hpp"
#include "app/parts/folders/folder_chooser.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace tp;

class FolderChooserTest : public QObject {
    Q_OBJECT
private slots:
    void one_goes_in_and_up_and_hears_where_one_is() {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath("family/2026") && QDir(folder.path()).mkpath("family/Älter"));
        QVERIFY(QDir(folder.path()).mkpath("family/.hidden"));
        for (const char* name : {"family/2026/1.jpg", "family/2026/2.JPG", "family/2026/IMG_3.HEIC", "family/2026/4.dng",
                                 "family/2026/notes.txt"}) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        FolderChooser chooser(narrator_);
        QSignalSpy chosen(&chooser, &FolderChooser::chosen);
        chooser.begin_in(folder.filePath("family"));
        QCOMPARE(chooser.below(), QStringList({"2026", "Älter"}));
        QCOMPARE(voice_.said().back(),
                 QString("Folder family: no photographs in this folder itself, 2 subfolder(s)."));
        chooser.goInto(0);
        QCOMPARE(chooser.folder(), folder.filePath("family/2026"));
        QVERIFY(voice_.said().back().contains("4 photograph(s) in this folder itself, no subfolders"));
        chooser.goInto(0);
        chooser.goInto(-1);
        QCOMPARE(chooser.folder(), folder.filePath("family/2026"));
        chooser.goUp();
        chooser.choose();
        QCOMPARE(chosen.takeFirst().first().toString(), folder.filePath("family"));
    }

    void the_way_up_ends_at_the_root() {
        FolderChooser chooser(narrator_);
        chooser.begin_in("/usr/lib");
        for (int i = 0; i < 5; ++i)
            chooser.goUp();
        QCOMPARE(chooser.folder(), QString("/"));
        QVERIFY(!chooser.hasAbove());
    }

    void a_folder_that_is_gone_is_told_and_one_stays_where_one_is() {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkpath("here/gone"));
        FolderChooser chooser(narrator_);
        chooser.begin_in(folder.filePath("here"));
        QVERIFY(QDir(folder.path()).rmdir("here/gone"));
        chooser.goInto(0);
        QCOMPARE(chooser.folder(), folder.filePath("here"));
        QCOMPARE(voice_.said().back(), QString("The folder gone cannot be read."));
    }

private:
    RecordingVoice voice_;
    RecordingAnnouncer announcer_;
    Narrator narrator_{voice_, announcer_};
};

QTEST_GUILESS_MAIN(FolderChooserTest)
#include "folder_chooser_test.moc"
