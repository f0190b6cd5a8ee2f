// SPDX-License-Identifier: Apache-2.0
// What a person does on one page, in the whole program: failing_pages_worker PAGE. Its folder lies in TMPDIR and stays there.
// Each deed is a line on stdout: its name, then, after tabs, the sentences that were said until the program was at rest.
// From the first deed on calls that go to the disk count (failing_files.cpp).
#include "app/album/keeper/album_keeper.hpp"
#include "sound_files.hpp"
#include "whole_program.hpp"

#include <QGuiApplication>
#include <QTest>
#include <QTimer>

#include <cstdio>
#include <dlfcn.h>
#include <fstream>
#include <functional>
#include <map>

using namespace tp;
namespace fs = std::filesystem;

namespace {

constexpr int patience_ms = 30'000; ///< for a step that the disk's fault may have ended

Choices caregiver() {
    Choices choices = WholeProgram::asked();
    choices.user = Choices::User::caregiver;
    choices.descriptions = Choices::Descriptions::none; // they come when they are ready, not with a deed
    return choices;
}

class Visitor {
public:
    Visitor() : whole(caregiver()) {
        whole.folder.setAutoRemove(false);
        fs::create_directory(whole.file("Card"));
        fs::create_directory(whole.file("Documents"));
        fs::copy_file(test::in_source("resources/samples/clara_sad.jpg"), whole.file("Card/clara_sad.jpg"));
        std::ofstream(whole.file("own.study"))
            << "experiment: shapes\ntitle: Two shapes\ntask: name\nfactor shape: circle, square\n"
               "answer: shape\nrepetitions: 2\nbreak after: 2\nlongest trial: 30 s\n";
        const fs::path sound = whole.file("tone.wav");
        testing::write_wav(sound, testing::tone(660.0, 2.0, 48'000), 48'000);
        AlbumKeeper keeper(whole.file("Family"));
        if (!keeper.add_recording(photo, sound, {RecordingKind::memo, {}, {}, {}, {}, {}}))
            qFatal("the album cannot be made");
        if (!whole.shown() || !QTest::qWaitFor([&] { return whole.complete(); }, patience_ms))
            qFatal("the program does not begin");
    }

    void does(const char* name, const std::function<void()>& deed) {
        const qsizetype before = whole.voice.said().size();
        deed();
        waits_for([&] { return at_rest(); });
        QTest::qWait(30); // what was asked for by a signal
        waits_for([&] { return at_rest(); });
        std::printf("%s", name);
        for (const QString& sentence : whole.voice.said().mid(before))
            std::printf("\t%s", qPrintable(QString(sentence).simplified()));
        std::printf("\n");
        std::fflush(stdout);
    }
    /// A fault may keep it from coming: then the deed ends so.
    bool waits_for(const std::function<bool()>& state) { return QTest::qWaitFor(state, patience_ms); }
    /// Into the microphone, while it is on.
    void speaks(double seconds, const std::function<bool()>& recording) {
        bool heard = false;
        waits_for([&] {
            if (testing::FakeMicrophone* const made = whole.microphone)
                QMetaObject::invokeMethod(
                    made,
                    [&] {
                        if ((heard = made->on()))
                            made->hear(testing::tone(440.0, seconds, sound_rate));
                    },
                    Qt::BlockingQueuedConnection);
            return heard || !recording();
        });
    }

    void cares() {
        CareSession& care = whole.program->care();
        keeping_ = [&] { return care.keeping(); };
        does("open", [&] {
            whole.program->open_page("care");
            care.open_photo(photo);
            waits_for([&] { return !care.faces()->looking(); });
        });
        does("record", [&] {
            care.take()->start();
            speaks(3.0, [&] { return care.take()->running(); });
            care.take()->finish();
        });
        does("label", [&] {
            care.recordings()->choose(0);
            care.recordings()->setPerson("Otto");
        });
        does("trim", [&] {
            care.recordings()->choose(0);
            waits_for([&] { return care.recordings()->chosen() < 0 || care.trimming()->duration() > 1.0; });
            care.trimming()->setEnd(1.0);
            care.trimming()->cut();
        });
        does("delete the recording", [&] {
            care.recordings()->choose(0);
            care.recordings()->remove();
        });
        const auto undo_deleting = [&] { // where it was not done, nothing else is undone
            if (care.history()->undoText().contains("deleted"))
                care.history()->undo();
        };
        does("undo", undo_deleting);
        does("describe", [&] {
            care.descriptions()->typeDescription("By the lake");
            care.descriptions()->save();
        });
        does("name", [&] {
            care.faces()->choose(0);
            care.faces()->name("Otto");
        });
        does("import", [&] {
            care.importing()->import({QUrl::fromLocalFile(whole.folder.filePath("Card"))});
            waits_for([&] { return !care.importing()->running(); });
        });
        does("delete the photograph", [&] { care.deletePhoto(); });
        does("undo that", undo_deleting);
    }
    void mends() {
        MendSession& mend = whole.program->mend();
        does("open", [&] {
            whole.program->open_page("mend");
            mend.open_file(QString::fromStdString(photo.string()));
            waits_for([&] { return mend.photo()->state() != MendedPhoto::State::Looking; });
        });
        does("move a point", [&] {
            mend.selection()->take_handle(0);
            mend.editing()->nudge(3.0, 0.0);
        });
        does("save", [&] { mend.file()->save(); });
        does("leave", [&] { whole.program->open_page("start"); });
    }
    void takes_a_photograph() {
        CaptureSession& capture = whole.program->capture();
        keeping_ = [&] { return capture.keeping(); };
        does("open", [&] {
            whole.program->open_page("capture");
            waits_for([&] { return capture.camera()->state() == CaptureCamera::On; });
        });
        does("take", [&] {
            capture.take();
            waits_for([&] { return !capture.keeping(); });
        });
        std::printf("taken\t%s\n", capture.shutter()->photo().c_str());
        does("memo", [&] {
            capture.recordMemo();
            speaks(2.0, [&] { return capture.memo()->running(); });
            if (capture.memo()->running())
                capture.recordMemo();
        });
    }
    void prints() {
        PrintSession& print = whole.program->print();
        does("open", [&] {
            print.open_photo(photo);
            whole.program->open_page("print");
            waits_for([&] { return !print.photo()->looking(); });
        });
        does("store", [&] { print.store("pdf"); });
    }
    void looks() {
        BrowseSession& browse = whole.program->browse();
        does("open", [&] { whole.program->open_page("browse"); });
        does("next", [&] { browse.trail()->next(); });
        does("search", [&] {
            browse.lists()->openSearch();
            browse.lists()->type("anna");
            QTest::qWait(50);
            browse.lists()->choose(0);
        });
        does("first", [&] { browse.trail()->first(); });
        does("play", [&] { browse.playback()->play(); });
        does("feel", [&] {
            whole.program->open_page("explore");
            whole.program->explore().open_file(QString::fromStdString(photo.string()));
        });
    }
    void chooses() {
        SettingsSession& settings = whole.program->settings();
        does("open", [&] { whole.program->open_page("settings"); });
        does("limit", [&] { settings.feeling()->setMaxForce(0.7); });
        does("discard the index", [&] { settings.storage()->discardIndex(); });
        does("look", [&] { whole.program->open_page("browse"); });
    }

    void measures() {
        LabSession& lab = whole.program->lab();
        does("open", [&] { whole.program->open_page("lab"); });
        does("measure", [&] {
            lab.files()->toggleRecording();
            QTest::qWait(300);
            lab.stop();
        });
        does("table", [&] {
            lab.servo()->start();
            waits_for([&] { return !lab.plots()->trace().points().empty() || !lab.activity()->running(); });
            lab.stop();
            lab.files()->writeTable();
        });
        does("replay", [&] {
            const QStringList recordings = lab.files()->recordings();
            if (!recordings.isEmpty())
                lab.playback()->replay(0);
        });
    }
    void takes_part() {
        StudySession& study = whole.program->study();
        StudyRun& run = *study.run();
        using State = StudyRun::State;
        keeping_ = [&] { return run.state() == State::Opening || run.state() == State::Keeping; };
        does("open", [&] {
            whole.program->open_page("study");
            study.setup()->openFile(QUrl::fromLocalFile(whole.folder.filePath("own.study")));
            waits_for([&] { return study.setup()->problem().isEmpty(); });
        });
        does("agree", [&] {
            study.begin();
            run.agree();
        });
        const auto feels = [&] {
            if (run.state() == State::Paused)
                run.goOn();
            waits_for([&] { return run.state() != State::Opening; });
            if (run.state() != State::Ready)
                return;
            run.goOn();
            QTest::qWait(50);
            run.goOn();
            run.answer(0);
        };
        does("first trial", feels);
        does("second trial", feels);
        does("end", [&] {
            while (run.running() && run.stop())
                ;
        });
        does("look", [&] { study.overview()->look(); });
        does("report", [&] {
            study.overview()->makeReport();
            const qsizetype said = whole.voice.said().size();
            waits_for([&] { return said < whole.voice.said().size(); });
        });
    }

    WholeProgram whole;

private:
    bool at_rest() { return whole.complete() && !keeping_(); }

    const fs::path photo = whole.file("Family/anna_smiling.jpg");
    std::function<bool()> keeping_ = [] { return false; }; ///< the page's
};

} // namespace

int main(int argc, char** argv) {
    const QGuiApplication application(argc, argv);
    const std::map<std::string, void (Visitor::*)()> pages{{"care", &Visitor::cares},
                                                           {"mend", &Visitor::mends},
                                                           {"capture", &Visitor::takes_a_photograph},
                                                           {"print", &Visitor::prints},
                                                           {"browse", &Visitor::looks},
                                                           {"settings", &Visitor::chooses},
                                                           {"lab", &Visitor::measures},
                                                           {"study", &Visitor::takes_part}};
    const auto page = pages.find(argc > 1 ? argv[1] : "");
    if (page == pages.end())
        qFatal("which page?");
    Visitor visitor;
    if (const auto count = reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "tp_count_calls_from_here")))
        count();
    (visitor.*page->second)();
    visitor.does("close", [&] { visitor.whole.window->close(); });
    visitor.whole.window.reset();
    visitor.whole.program.reset();
    std::puts("ended");
    return 0;
}
