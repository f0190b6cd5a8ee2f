// SPDX-License-Identifier: Apache-2.0
// The journeys of tests/e2e, by touch alone.
#include "app/album/keeper/album_keeper.hpp"
#include "page_test.hpp"
#include "page_window.hpp"
#include "places.hpp"
#include "sound_files.hpp"
#include "touch_hand.hpp"
#include "whole_program.hpp"

#include <QDir>
#include <QMetaObject>

#include <algorithm>
#include <vector>

using namespace tp;

namespace {

/// Somebody at the program with nothing but fingers, who hears what is said.
class ByTouch {
public:
    explicit ByTouch(const Choices& choices) : whole(choices), hand(*whole.window) {
        qputenv("HOME", whole.folder.path().toUtf8()); // where choosing a folder begins
    }
    bool exposed() { return whole.shown(); }
    /// Waits until each has been said, one after the other, after all that was heard before.
    bool hears(const QStringList& sentences) {
        for (const QString& sentence : sentences)
            if (!QTest::qWaitFor([&] { return heard(sentence); }, 60000)) {
                qWarning("\"%s\" was not said after \"%s\"; since then: %s", qPrintable(sentence), qPrintable(last_),
                         qPrintable(whole.voice.said().mid(next_).join(" | ")));
                return false;
            }
        return true;
    }
    QString photo(const char* name) const { return whole.folder.filePath(QString("Family/") + name); }

    WholeProgram whole;
    TouchHand hand;

private:
    bool heard(const QString& sentence) {
        const QStringList& said = whole.voice.said();
        for (qsizetype i = next_; i < said.size(); ++i)
            if (said[i].contains(sentence)) {
                next_ = i + 1;
                last_ = said[i];
                return true;
            }
        return false;
    }
    qsizetype next_ = 0; ///< what was said from here on was not asked for yet
    QString last_;
};

/// The person of the first journey: nobody was asked yet, and the album that is waiting has Anna with a recording.
struct Visitor : ByTouch {
    Visitor() : ByTouch(not_asked()) {
        const std::filesystem::path folder = whole.folder.filePath("Family").toStdString();
        const std::filesystem::path anna = photo("anna_smiling.jpg").toStdString();
        const std::filesystem::path sound = whole.folder.filePath("tone.wav").toStdString();
        tp::testing::write_wav(sound, tp::testing::tone(660.0, 2.0, 48'000), 48'000);
        AlbumKeeper keeper(folder);
        if (const std::string why = keeper.name_face(anna, {0.5, 0.4, 0.4, 0.5, "Anna"}); !why.empty())
            qFatal("%s", why.c_str());
        if (const auto added = keeper.add_recording(anna, sound, {RecordingKind::memo, {}, {}, {}, {}, {}}); !added)
            qFatal("%s", added.error().c_str());
    }
    static Choices not_asked() {
        Choices choices;
        choices.language = "en";
        return choices;
    }

    QQuickItem* pane() const { return hand.item("pane"); }
    void swipe(int dx, int dy) {
        const QPoint from = TouchHand::middle_of(*pane());
        hand.draw({from, from + QPoint(dx, dy)});
        TouchHand::rest();
    }
    /// The frequency of the next seconds that the loudspeaker of the page has to play.
    double hertz_heard(double seconds) {
        tp::testing::FakeLoudspeaker& speaker = *whole.loudspeakers.back();
        std::vector<float> sound;
        while (static_cast<double>(sound.size()) < seconds * sound_rate) { // CTest ends a test that waits for ever
            speaker.heard.clear();
            speaker.play(0.01);
            // What fills it is a thread of its own, which may be late.
            if (std::ranges::any_of(speaker.heard, [](float sample) { return sample != 0.0F; }))
                sound.insert(sound.end(), speaker.heard.begin(), speaker.heard.end());
            QTest::qWait(1);
        }
        return tp::testing::frequency_of(sound, sound_rate);
    }

    ExploreSession& explore() { return whole.program->explore(); }
    QPoint pixel(QPointF place) const {
        const QQuickItem* surface = hand.item("surface");
        return surface->mapToScene(surface->width() / whole.program->explore().view()->surfaceWidth() * place)
            .toPoint();
    }
    /// A point of the feature of this name.
    QPoint on_feature(const QString& name) {
        for (const QVariant& face : explore().view()->faces())
            for (const QVariant& feature : face.toMap()["features"].toList())
                if (feature.toMap()["name"].toString().contains(name))
                    return pixel(explore().view()->frame().from_surface(
                        explore()
                            .view()
                            ->felt()
                            .lines[static_cast<std::size_t>(feature.toMap()["index"].toInt())]
                            .points[0]));
        qFatal("there is no %s", qPrintable(name));
    }
    /// Slides over the letters from the first to this one, and lifts the finger there.
    bool spell(const QString& letter) {
        QQuickItem* board = nullptr;
        int index = -1;
        if (!QTest::qWaitFor([&] {
                board = hand.item("letters");
                index = static_cast<int>(whole.program->browse().lists()->letters().indexOf(letter));
                return board != nullptr && index >= 0;
            }) || !hand.rests(*board))
            return false;
        const double cell = board->property("cell").toDouble();
        const int columns = board->property("columns").toInt();
        const auto place = [&](int key) {
            return board->mapToScene({(key % columns + 0.5) * (cell + 6.0), (key / columns + 0.5) * (cell + 6.0)}).toPoint();
        };
        hand.draw({place(0), place(index)});
        return true;
    }
};

/// The caregiver of the second journey: the album knows Ben, and one more photograph waits on a card.
struct Caregiver : ByTouch {
    Caregiver() : ByTouch(looks_after()) {
        const QDir folder(whole.folder.path());
        folder.mkpath("Card");
        folder.mkpath("Documents");
        QFile::copy(tp::test::in_source("resources/samples/clara_sad.jpg"), folder.filePath("Card/clara_sad.jpg"));
        AlbumKeeper keeper(folder.filePath("Family").toStdString());
        if (const std::string why = keeper.name_face(photo("ben_smiling.jpg").toStdString(), {0.5, 0.4, 0.4, 0.5, "Ben"}); !why.empty())
            qFatal("%s", why.c_str());
    }
    static Choices looks_after() {
        Choices choices = WholeProgram::asked();
        choices.user = Choices::User::caregiver;
        return choices;
    }
    CareSession& care() { return whole.program->care(); }
    MendSession& mend() { return whole.program->mend(); }

    bool hears_microphone(double seconds) {
        tp::testing::FakeMicrophone* made = nullptr;
        if (!QTest::qWaitFor([&] { return (made = whole.microphone) != nullptr && care().take()->running(); }))
            return false;
        QMetaObject::invokeMethod(
            made, [made, seconds] { made->hear(tp::testing::tone(440.0, seconds, sound_rate)); }, Qt::BlockingQueuedConnection);
        return true;
    }
    /// Where a point of the contour in hand is drawn.
    QPoint point(int index) {
        HandleModel* points = mend().selection()->handles();
        const QPointF place = points->data(points->index(index), HandleModel::place_role).toPointF();
        return hand.item("surface")->mapToScene((place - mend().view()->origin()) * mend().view()->scale()).toPoint();
    }
    std::vector<std::filesystem::path> recordings() const {
        std::vector<std::filesystem::path> files;
        const std::filesystem::path tags = photo("ben_and_clara.jpg").toStdString() + ".tags";
        if (std::filesystem::exists(tags))
            for (const auto& entry : std::filesystem::directory_iterator(tags))
                if (entry.path().extension() == ".flac")
                    files.push_back(entry.path());
        return files;
    }
};

} // namespace

class TouchJourneysTest : public PageTest {
    Q_OBJECT
private slots:
    void a_blind_person_from_the_first_start_to_a_search() {
        Visitor person;
        TouchHand& hand = person.hand;
        QVERIFY(person.exposed());
        // What is seen comes when it is ready; described_test.cpp waits for it.
        person.whole.program->preferences().change(
            [](Choices& choices) { choices.descriptions = Choices::Descriptions::none; });

        // Five questions.
        QVERIFY(person.hears({"Question 1 of 5."}));
        QVERIFY(hand.tap("1: Yes"));
        QVERIFY(person.hears({"Question 2 of 5. How fast should it speak?"}));
        QVERIFY(hand.tap("4: Fast"));
        QVERIFY(person.hears({"Question 3 of 5."}));
        QVERIFY(hand.tap("1: …"));
        QVERIFY(person.hears({"Question 4 of 5. No force device was found."}));
        QVERIFY(hand.tap("1: …"));
        QVERIFY(person.hears({"Question 5 of 5. Where are your photographs?"}));
        QVERIFY(hand.tap("…In another folder"));
        QVERIFY(person.hears({"Folder "}));
        QVERIFY(hand.tap("Family…"));
        QVERIFY(person.hears({"Folder Family: 3 photographs in this folder itself"}));
        QVERIFY(hand.tap("Choose this folder"));
        QVERIFY(person.hears({"TouchPhoto, start page. 1: Listen to photographs. 2: Feel a face."}));

        // Photographs, by strokes and by buttons, and a recording.
        QVERIFY(hand.tap("1: Listen to photographs…"));
        QVERIFY(person.hears({"Anna; 1 recording."}));
        person.swipe(200, 0);
        QVERIFY(person.hears({"ben_and_clara.jpg"}));
        QVERIFY(hand.tap("Next"));
        QVERIFY(person.hears({"ben_smiling.jpg"}));
        QVERIFY(hand.tap("Previous"));
        QVERIFY(person.hears({"ben_and_clara.jpg"}));
        person.swipe(-200, 0);
        QVERIFY(person.hears({"Anna; 1 recording."}));
        person.swipe(0, 150);
        QVERIFY(person.hears({"Anna"}));
        person.swipe(0, -150);
        QVERIFY(person.hears({"Anna; 1 recording."}));
        const QPoint middle = TouchHand::middle_of(*person.pane());
        hand.tap_at(middle);
        hand.tap_at(middle);
        QTRY_VERIFY(person.whole.program->browse().playback()->playing());
        QVERIFY(std::abs(person.hertz_heard(1.0) - 660.0) < 20.0);
        TouchHand::rest();
        hand.tap_at(middle, 2);
        QVERIFY(!person.whole.program->browse().playback()->playing());
        TouchHand::rest();

        // A face.
        QVERIFY(hand.tap("Feel the face"));
        QVERIFY(person.hears({"Anna. One face. Eyes, mouth and outline can be felt."}));
        const QPoint eye = person.on_feature("left eye"), lips = person.on_feature("lips");
        hand.press(eye + QPoint(0, -60));
        hand.go(eye + QPoint(0, -60), eye);
        QVERIFY(person.hears({"left eye"}));
        hand.go(eye, lips);
        QVERIFY(person.hears({"lips"}));
        hand.release(lips);
        TouchHand::rest();
        hand.tap_at(lips);
        hand.tap_at(lips);
        QVERIFY(person.hears({"Anna. "}));
        TouchHand::rest();
        hand.tap_at(eye, 3);
        QVERIFY(person.hears({"Anna. "}));
        TouchHand::rest();
        hand.tap_at(lips);
        hand.press(lips);
        TouchHand::rest();
        hand.release(lips);
        QVERIFY(person.hears({"Zoomed to the mouth of Anna."}));
        QVERIFY(hand.tap("Zoom out"));
        QVERIFY(person.hears({"Zoomed out to the whole face."}));
        TouchHand::rest();

        // Its tour: begun and stopped by two fingers, and followed to its end.
        hand.tap_at(eye, 2);
        hand.tap_at(eye, 2);
        QVERIFY(person.hears({"Tour "}));
        TouchHand::rest();
        hand.tap_at(eye, 2);
        QVERIFY(person.hears({"Stopped."}));
        QVERIFY(hand.tap("Force on"));
        QVERIFY(person.hears({"The force is on."}));
        QVERIFY(hand.tap("Guided tour"));
        QVERIFY(person.hears({"Tour round the ", "Tour finished."}));

        // The next face of the album, and back, by two fingers.
        hand.draw({eye, eye + QPoint(200, 0)}, 2);
        QVERIFY(person.hears({"ben_and_clara.jpg. "}));
        hand.draw({eye, eye + QPoint(-200, 0)}, 2);
        QVERIFY(person.hears({"Anna. One face."}));
        QVERIFY(hand.tap("Home"));
        QVERIFY(person.hears({"TouchPhoto, start page."}));

        // A name that is spelt by a finger.
        QVERIFY(hand.tap("1: Listen to photographs…"));
        QVERIFY(person.hears({"1 of 3: Anna; 1 recording."}));
        QVERIFY(hand.tap("Search"));
        QVERIFY(person.hears({"Search. Type a name, a place or a word, or move a finger over the letters"}));
        QVERIFY(person.spell("C"));
        QVERIFY(person.hears(
            {"A", "C", "C: "})); // what is seen on photographs counts too, where they were looked at by now
        for (const char* letter : {"L", "A", "R"})
            QVERIFY2(person.spell(letter),
                     qPrintable(person.whole.program->browse().lists()->typed() + ": " +
                                person.whole.program->browse().lists()->letters().join(" ")));
        QVERIFY(person.hears({"Clar: 1 photograph."}));
        QVERIFY(hand.tap("Down"));
        QVERIFY(person.hears({"ben_and_clara.jpg"}));
        QVERIFY(hand.tap("Choose"));
        QVERIFY(person.hears({"Found: Clar, "}));

        // How fast is spoken.
        QVERIFY(hand.tap("Home"));
        QVERIFY(hand.tap("4: Settings…"));
        QVERIFY(person.hears({"Settings. "}));
        QVERIFY(hand.tap("Speed of speech: Slow"));
        QVERIFY(person.hears({"Slow. This is how fast I speak."}));
        QCOMPARE(person.whole.program->preferences().choices().rate, Choices::Rate::slow);
    }

    void a_stroke_that_begins_on_a_row_scrolls_and_presses_nothing() {
        ByTouch person(WholeProgram::asked());
        person.whole.window->resize(600, 560);
        QVERIFY(person.exposed());
        QVERIFY(person.hears({"TouchPhoto, start page."}));
        const QQuickItem* row = person.hand.item("destination2");
        QVERIFY(row != nullptr && person.hand.rests(*row));
        const QPoint from = TouchHand::middle_of(*row);
        person.hand.draw({from, from - QPoint(0, 150)});
        QTRY_VERIFY(TouchHand::middle_of(*row).y() < from.y() - 60);
        QCOMPARE(person.whole.shell().page(), QString("start"));
    }

    void a_caregiver_from_an_import_to_a_tactile_sheet() {
        Caregiver caregiver;
        TouchHand& hand = caregiver.hand;
        QVERIFY(caregiver.exposed());

        // A folder.
        QVERIFY(caregiver.hears({"TouchPhoto, start page. 1: Look after the album."}));
        QVERIFY(hand.tap("1: Look after the album…"));
        QVERIFY(caregiver.hears({"Look after the album."}));
        QVERIFY(hand.tap("Import a folder…"));
        QVERIFY(caregiver.hears({"Folder "}));
        QVERIFY(hand.tap("Card…"));
        QVERIFY(caregiver.hears({"Folder Card: 1 photograph in this folder itself"}));
        QVERIFY(hand.tap("Choose this folder"));
        QVERIFY(caregiver.hears({"1 photograph imported."}));

        // A name.
        QVERIFY(hand.tap("ben_and_clara.jpg…"));
        QVERIFY(hand.tap("Face without a name…"));
        QVERIFY(caregiver.hears({"Face without a name, 1 of 2. Type a name or choose one below."}));
        QVERIFY(hand.tap("Ben, 1 of 1"));
        QVERIFY(caregiver.hears({"Saved: Ben. Who is the next face?"}));
        QVERIFY(hand.tap("Close"));

        // A recording: made, cut at its end by dragging and at its begin by tapping, deleted and brought back.
        QVERIFY(hand.tap("Record"));
        QVERIFY(caregiver.hears_microphone(4.0));
        QVERIFY(hand.tap("Finish the recording"));
        QVERIFY(caregiver.hears({"Saved."}));
        QTRY_COMPARE(caregiver.recordings().size(), std::size_t{1});
        QVERIFY(hand.tap("Memo…"));
        QTRY_VERIFY(caregiver.care().trimming()->duration() > 3.9);
        QTRY_VERIFY(hand.item("trimEnd") != nullptr);
        QQuickItem* const end = hand.item("trimEnd");
        QVERIFY(hand.rests(*end) && hand.bring_into_view(*end));
        const QPoint grip = end->mapToScene({0.3 * end->width(), 0.5 * end->height()}).toPoint();
        hand.draw({grip, grip - QPoint(100, 0)});
        QVERIFY(caregiver.hears({"To "}));
        QVERIFY(caregiver.care().trimming()->end() < 3.8);
        const QQuickItem* const track = end->parentItem();
        hand.tap_at(track->mapToScene({0.25 * track->width(), 0.5 * track->height()}).toPoint());
        QVERIFY(caregiver.hears({"From "}));
        QVERIFY(caregiver.care().trimming()->begin() > 0.4);
        QVERIFY(hand.tap("Trim to this part"));
        QVERIFY(caregiver.hears({"Trimmed: "}));
        QVERIFY(hand.tap("Delete the recording"));
        QVERIFY(caregiver.hears({"Deleted: "}));
        QTRY_VERIFY(caregiver.recordings().empty());
        QVERIFY(hand.tap("Undo: …"));
        QVERIFY(caregiver.hears({"Undone: "}));
        QTRY_COMPARE(caregiver.recordings().size(), std::size_t{1});

        // A contour: a point dragged, and one moved by taps alone.
        QVERIFY(hand.tap("Mend contours…"));
        QTRY_COMPARE_WITH_TIMEOUT(caregiver.mend().photo()->state(), MendedPhoto::State::Ready, 60000);
        QVERIFY(caregiver.hears({"Contours of ben_and_clara.jpg."}));
        const QPoint first = caregiver.point(0);
        hand.draw({first, first + QPoint(-30, 12)});
        QVERIFY(caregiver.hears({" across, "}));
        QVERIFY((caregiver.point(0) - first - QPoint(-30, 12)).manhattanLength() <= 3);
        const QPointF before = caregiver.mend().selection()->handles()->data(caregiver.mend().selection()->handles()->index(2), HandleModel::place_role).toPointF();
        hand.tap_at(caregiver.point(2));
        QCOMPARE(caregiver.mend().selection()->handle(), 2);
        QVERIFY(hand.tap("Move right"));
        QVERIFY(caregiver.hears({" across, "}));
        const QPointF after = caregiver.mend().selection()->handles()->data(caregiver.mend().selection()->handles()->index(2), HandleModel::place_role).toPointF();
        QVERIFY(std::abs(after.x() - before.x() - 1.0) < 1e-6);
        QVERIFY(hand.tap("Home"));
        QTRY_VERIFY(QFile::exists(caregiver.photo("ben_and_clara.jpg") + ".contours.svg"));

        // A sheet.
        QVERIFY(hand.tap("1: Look after the album…"));
        QVERIFY(hand.tap("Print a tactile sheet…"));
        QVERIFY(caregiver.hears({"Print ben_and_clara.jpg on 210 by 297 millimetres."}));
        QVERIFY(hand.tap("Save as PDF"));
        QVERIFY(caregiver.hears({"The sheet is saved as "}));
        QCOMPARE(QDir(caregiver.whole.folder.filePath("Documents")).entryList({"*.pdf"}).size(), 1);
    }
};

QTEST_MAIN(TouchJourneysTest)
#include "touch_journeys_test.moc"
