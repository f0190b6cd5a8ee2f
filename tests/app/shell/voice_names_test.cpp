// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "app/shell/voice_names.hpp"
#include "audio/speech/recording_voice.hpp"

#include <QSignalSpy>
#include <QTest>

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Bench {
    AlbumFolder place;
    fs::path one = made("one"), other = made("other");
    Preferences preferences;
    RecordingVoice voice;

    fs::path made(const char* name) {
        fs::create_directories(place / name);
        return fs::canonical(place / name);
    }
    void choose(const std::vector<fs::path>& folders) {
        preferences.change([&](Choices& choices) {
            choices.folders.clear();
            for (const fs::path& folder : folders)
                choices.folders << QString::fromStdString(folder.string());
        });
    }
    static void say(const fs::path& album, const std::string& person, const std::string& language) {
        AlbumKeeper keeper(album);
        QCOMPARE(NameLanguages(keeper).choose(person, language), std::string());
    }
};

} // namespace

class VoiceNamesTest : public QObject {
    Q_OBJECT
private slots:
    void the_voice_knows_the_albums_names_before_any_page() {
        Bench bench;
        bench.say(bench.one, "Giulia", "it");
        bench.say(bench.other, "José", "es");
        bench.choose({bench.one, bench.other, bench.place / "not there"});
        const VoiceNames names(bench.voice, bench.preferences);
        QTRY_COMPARE(bench.voice.name_languages(),
                     (SpokenNames{{"Giulia", "it"}, {QString::fromUtf8("José"), "es"}}));
        QVERIFY(bench.voice.said().isEmpty());
    }

    void who_speaks_before_any_event_waits_for_the_names() {
        Bench bench;
        bench.say(bench.one, "Giulia", "it");
        bench.choose({bench.one});
        VoiceNames names(bench.voice, bench.preferences);
        names.settle(60000);
        QCOMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "it"}}));
    }

    void other_folders_have_other_names() {
        Bench bench;
        bench.say(bench.one, "Giulia", "it");
        bench.say(bench.other, "Giulia", "en");
        bench.choose({bench.one});
        const VoiceNames names(bench.voice, bench.preferences);
        QTRY_COMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "it"}}));
        bench.choose({bench.other});
        QTRY_COMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "en"}}));
        bench.choose({bench.other, bench.one}); // the first in the order of paths
        QTRY_COMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "it"}}));
        bench.choose({});
        QTRY_COMPARE(bench.voice.name_languages(), SpokenNames{});
    }

    void what_changed_in_an_album_is_read_when_asked_for() {
        Bench bench;
        bench.choose({bench.one});
        VoiceNames names(bench.voice, bench.preferences);
        bench.say(bench.one, "Giulia", "it");
        names.read();
        QTRY_COMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "it"}}));
        bench.say(bench.one, "Giulia", "");
        names.read();
        QTRY_COMPARE(bench.voice.name_languages(), SpokenNames{});
    }

    void what_a_page_knows_is_told_at_once_and_is_not_lost_to_an_older_reading() {
        Bench bench;
        bench.choose({bench.one});
        VoiceNames names(bench.voice, bench.preferences); // reads
        bench.say(bench.one, "Giulia", "it");
        names.know(bench.one, {{"Giulia", "it"}});
        QCOMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "it"}}));
        bench.say(bench.one, "Luca", "it"); // so that it is known when that was read
        names.read();
        QTRY_COMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "it"}, {"Luca", "it"}}));
    }

    void a_file_that_cannot_be_read_is_said_once() {
        Bench bench;
        bench.say(bench.one, "Giulia", "it");
        bench.place.write("one/.touchphoto/people/Tom.language", "?");
        bench.choose({bench.one});
        VoiceNames names(bench.voice, bench.preferences);
        QSignalSpy said(&names, &VoiceNames::said);
        QTRY_COMPARE(said.size(), 1);
        QVERIFY(said[0][0].toString().contains("Tom.language"));
        QCOMPARE(bench.voice.name_languages(), (SpokenNames{{"Giulia", "it"}}));
        bench.say(bench.one, "Luca", "it");
        names.read();
        QTRY_COMPARE(bench.voice.name_languages().size(), std::size_t{2});
        QCOMPARE(said.size(), 1);
    }
};

QTEST_GUILESS_MAIN(VoiceNamesTest)
#include "voice_names_test.moc"
