// SPDX-License-Identifier: Apache-2.0
// What rooms without languages really say is in the list, whole.
#include "album_folder.hpp"
#include "album_parts.hpp"
#include "app/album/keeper/album_keeper.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/recording_file.hpp"
#include "audio/sentences/sentences.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"
#include "core/servo/fault.hpp"
#include "core/svg/contour_sheet.hpp"
#include "device/open_problem.hpp"
#include "faces/decode/picture.hpp"
#include "faces/judge/face_problem.hpp"
#include "marked_sentences.hpp"
#include "sound_files.hpp"

#include <QCoreApplication>
#include <QTest>

#include <cerrno>
#include <filesystem>
#include <initializer_list>
#include <string>

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

/// The sentence where some of its words are in no bracket; empty: all are.
QString unknown_of(const std::string& english) {
    Brackets brackets;
    QCoreApplication::installTranslator(&brackets);
    const QString told = in_persons_language(english);
    QCoreApplication::removeTranslator(&brackets);
    QString outside;
    int depth = 0;
    for (const QChar c : told) {
        depth += (c == u'⟦' ? 1 : 0) - (c == u'⟧' ? 1 : 0);
        if (depth == 0 && c.isLetter())
            outside += c;
    }
    return english.empty() ? "nothing was said" : outside.isEmpty() ? QString() : QString::fromStdString(english);
}

template <typename T>
std::string error_of(const Result<T>& result) {
    return result.error();
}

} // namespace

#define KNOWN(sentence) QCOMPARE(unknown_of(sentence), QString())

class RoomsTest : public QObject {
    Q_OBJECT
private slots:
    void files() {
        const AlbumFolder folder;
        KNOWN(error_of(read_whole(folder / "gone.jpg", 10)));
        KNOWN(error_of(read_whole(folder.path(), 10)));
        KNOWN(error_of(read_whole(folder.write("large", std::string(100, 'a')), 10)));
        for (const int error : {EACCES, ENOSPC, EIO, ENAMETOOLONG, ENOENT, EEXIST})
            KNOWN(reason_of(error));
    }

    void drawings() {
        for (const char* text : {"", "no drawing", "<html/>", "<svg/>", "<svg width='0' height='1'/>", "<svg width='a' height='1'/>",
                                 "<svg viewBox='0 0 a 1'/>", "<svg width='9' height='9'><g style='transform:scale(2)'><path d='M0 0L1 1'/></g></svg>",
                                 "<svg width='9' height='9'><path id='lip' transform='turn(2)' d='M0 0L1 1'/></svg>",
                                 "<svg width='9' height='9'><path transform='scale(1e300)' d='M0 0L1e300 1'/></svg>"})
            KNOWN(error_of(sheet_from_svg(text)));
        KNOWN(error_of(write_sheet("/nowhere/at/all.svg", {10.0, 10.0, ContourSheet::Unit::millimetre, {}})));
    }

    void pictures_and_faces() {
        const AlbumFolder folder;
        KNOWN(error_of(read_picture(folder / "gone.jpg")));
        KNOWN(error_of(read_picture(folder.path())));
        KNOWN(error_of(read_picture(folder.write("empty.jpg", ""))));
        KNOWN(error_of(read_picture(folder.write("text.jpg", "text"))));
        KNOWN(error_of(read_picture(folder.write("cut.jpg", "\xff\xd8\xff\xe0"))));
        for (const double from : {-40.0, 10.0})
            for (const double to : {190.0, 240.0}) {
                Landmarks points;
                points.right_eye = points.left_eye = points.outer_lip = points.outline = {Vec2(from, from), Vec2(to, to)};
                const Detection face{{Vec2(from, from), Vec2(to, to)}, {}, {}, 1.0};
                if (const std::string problem = problem_of(face, points, {200, 200}); !problem.empty())
                    KNOWN(problem);
            }
        QualitySigns signs;
        signs.unit_px = 5.0;
        signs.turn = 0.9;
        signs.between_nets.fill(60.0);
        signs.between_passes.fill(60.0);
        KNOWN(problem_of(signs));
    }

    void devices() {
        for (int i = 1; i <= static_cast<int>(Fault::device_lost); ++i)
            KNOWN(std::string(sentence(static_cast<Fault>(i))));
        for (const System system : {System::linux_system, System::windows, System::macos})
            for (int i = 0; i <= static_cast<int>(OpenProblem::other); ++i)
                KNOWN(sentence(static_cast<OpenProblem>(i), system, "force pad"));
    }

    void albums_and_what_can_be_undone() {
        const AlbumFolder folder;
        const fs::path photo = a_photo(folder, "a.jpg", 1);
        AlbumKeeper keeper(folder.path());
        KNOWN(keeper.delete_photo(folder / "gone.jpg"));
        KNOWN(keeper.delete_photo("/elsewhere/b.jpg"));
        KNOWN(keeper.delete_recording(photo, "gone.flac"));
        KNOWN(keeper.history().undo());
        KNOWN(keeper.history().redo());
        KNOWN(error_of(read_record(folder / "gone.jpg")));
        KNOWN(error_of(about_recording(folder.write("no.flac", "fLaC"))));
        KNOWN(error_of(keeper.add_recording(photo, folder.write("no.wav", "text"), {})));

        write_wav(folder / "sound.wav", tone(440.0, 1.0, 48000), 48000);
        for (const RecordingKind kind : {RecordingKind::memo, RecordingKind::person, RecordingKind::place, RecordingKind::story,
                                         RecordingKind::ambient})
            for (const char* person : {"", "Anna"}) {
                RecordingLabel label;
                label.kind = kind;
                label.person = person;
                const auto added = keeper.add_recording(photo, folder / "sound.wav", label);
                QVERIFY2(added.ok(), added.error().c_str());
                KNOWN(keeper.history().next_undo());
                QVERIFY(keeper.history().next_undo().starts_with("the "));
                QCOMPARE(keeper.delete_recording(photo, added->tag.file), std::string());
                KNOWN(keeper.history().next_undo());
            }
        QCOMPARE(keeper.name_face(photo, {0.5, 0.5, 0.2, 0.2, "Anna"}), std::string());
        KNOWN(keeper.history().next_undo());
        QCOMPARE(keeper.describe(photo, "en", "Anna", ""), std::string());
        KNOWN(keeper.history().next_undo());
        QCOMPARE(keeper.delete_photo(photo), std::string());
        KNOWN(keeper.history().next_undo());
    }
};

QTEST_GUILESS_MAIN(RoomsTest)
#include "rooms_test.moc"
