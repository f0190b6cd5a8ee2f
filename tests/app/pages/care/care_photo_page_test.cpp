// SPDX-License-Identifier: Apache-2.0
#include "app/album/keeper/name_languages.hpp"
#include "app/album/keeper/photo_files.hpp"
#include "care_page.hpp"
#include "page_test.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QAccessible>
#include <QPoint>
#include <QPointingDevice>
#include <QQuickItem>
#include <QQuickView>

namespace care_photo_page_test {

using namespace tp;
namespace fs = std::filesystem;

/// What is done to one photograph on the page: recording, naming, telling.
class CarePhotoPageTest : public PageTest {
    Q_OBJECT
private slots:
    void by_keys_alone_one_records_trims_deletes_and_undoes() {
        Page page({"a.png"});
        QVERIFY(page.tab_to("a.png, No description., 1 of 1"));
        page.key(Qt::Key_Return);
        QVERIFY(page.bench.rests());
        QVERIFY(page.tab_to("What to record: Story"));
        page.key(Qt::Key_Space);
        QVERIFY(page.tab_to("Record"));
        page.key(Qt::Key_Return);
        page.bench.hear(2.0);
        QCOMPARE(page.focused(), QString("Finish the recording"));
        page.key(Qt::Key_Return);
        CARE_TRY_VERIFY(!page.session().take()->running());
        QVERIFY(page.bench.rests());
        QCOMPARE(page.focused(), QString("Record"));
        QCOMPARE(page.bench.last_said(), QString("Recorded: 2 seconds. Saved."));

        QVERIFY(page.tab_to("Start of the part to keep"));
        page.key(Qt::Key_Right);
        QCOMPARE(page.bench.last_said(), QString("From 0.1 seconds"));
        page.key(Qt::Key_Left);
        page.key(Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(page.bench.last_said(), QString("From 1.0 seconds"));
        page.key(Qt::Key_Tab);
        QCOMPARE(page.focused(), QString("End of the part to keep"));
        page.key(Qt::Key_Left);
        QCOMPARE(page.bench.last_said(), QString("To 1.9 seconds"));
        QVERIFY(page.tab_to("Trim to this part"));
        page.key(Qt::Key_Space);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.last_said(), QString("Trimmed: 0.9 seconds stay. Undo brings the rest back."));
        QCOMPARE(page.bench.record("a.png").tags.at(0).duration_s, 0.9);

        QVERIFY(page.tab_to("Delete the recording"));
        page.key(Qt::Key_Return);
        QVERIFY(page.bench.rests());
        QVERIFY(page.bench.record("a.png").tags.empty());
        QCOMPARE(page.focused(), QString("Record")); // with the last recording its buttons are gone
        page.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.last_said(), QString("Undone: the story was deleted."));
        page.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.record("a.png").tags.at(0).duration_s, 2.0);
        page.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.record("a.png").tags.at(0).duration_s, 0.9);
    }

    void by_a_screen_readers_actions_alone_one_records_trims_deletes_and_undoes() {
        Page page({"a.png"}, {600, 1000});
        QVERIFY(press(beginning(page, "a.png")));
        QVERIFY(page.bench.rests());
        QVERIFY(press(named(page, "What to record: Place")));
        QVERIFY(press(named(page, "Record")));
        page.bench.hear(2.0);
        CARE_TRY_VERIFY(beginning(page, "Recording 0:0") != nullptr);
        QVERIFY(press(named(page, "Pause")));
        CARE_TRY_VERIFY(named(page, "Continue") != nullptr);
        QVERIFY(press(named(page, "Finish the recording")));
        CARE_TRY_VERIFY(!page.session().take()->running());
        QVERIFY(page.bench.rests());
        QVERIFY(beginning(page, "Place, 2 seconds") != nullptr);

        QAccessibleInterface* const begin = named(page, "Start of the part to keep");
        QVERIFY(begin != nullptr && begin->valueInterface() != nullptr);
        QCOMPARE(begin->valueInterface()->maximumValue().toDouble(), 2.0);
        begin->valueInterface()->setCurrentValue(0.5);
        QCOMPARE(page.session().trimming()->begin(), 0.5);
        QCOMPARE(begin->valueInterface()->currentValue().toDouble(), 0.5);
        QAccessibleInterface* const end = named(page, "End of the part to keep");
        end->actionInterface()->doAction(QAccessibleActionInterface::decreaseAction());
        QVERIFY(std::abs(page.session().trimming()->end() - 1.9) < 1e-9);
        end->valueInterface()->setCurrentValue(0.0); // not before the begin
        QVERIFY(std::abs(end->valueInterface()->currentValue().toDouble() - 0.6) < 1e-9);
        QVERIFY(press(named(page, "Trim to this part")));
        QVERIFY(page.bench.rests());
        QVERIFY(std::abs(page.bench.record("a.png").tags.at(0).duration_s - 0.1) < 1e-9);

        QVERIFY(press(named(page, "Delete the recording")));
        QVERIFY(page.bench.rests());
        QVERIFY(page.bench.record("a.png").tags.empty());
        QVERIFY(press(named(page, "Undo: the recording of the place was deleted")));
        QVERIFY(page.bench.rests());
        QVERIFY(press(named(page, "Undo: the recording of the place was trimmed")));
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.record("a.png").tags.at(0).duration_s, 2.0);
        QVERIFY(beginning(page, "Redo: ") != nullptr);
    }

    void nothing_recorded_is_thrown_away_by_one_press() {
        Page page({"a.png"});
        QVERIFY(press(beginning(page, "a.png")));
        QVERIFY(press(named(page, "Record")));
        page.bench.hear(1.0);
        QVERIFY(press(named(page, "Discard…")));
        QCOMPARE(page.focused(), QString("Keep it"));
        QVERIFY(press(named(page, "Keep it")));
        QCOMPARE(page.focused(), QString("Finish the recording"));
        QVERIFY(press(named(page, "Discard…")));
        QVERIFY(press(named(page, "Yes, discard it")));
        QVERIFY(!page.session().take()->running());
        QCOMPARE(page.focused(), QString("Record"));
        CARE_TRY_COMPARE(page.bench.recorder.state(), RecorderState::idle);
    }

    void a_handle_is_dragged_by_a_finger_too() {
        Page page({"a.png"});
        page.bench.add_sound("a.png", 4.0, 300.0);
        page.session().open_photo(page.bench.photo("a.png"));
        QVERIFY(page.bench.rests());
        QVERIFY(page.tab_to("End of the part to keep")); // and so in view
        QQuickItem* const handle = page.item("trimEnd");
        QTRY_VERIFY(handle->x() > 100.0);
        const QPoint grip = handle->mapToScene({20.0, 0.5 * handle->height()}).toPoint();
        QPointingDevice* const screen = QTest::createTouchDevice();
        QTest::touchEvent(&page.window, screen).press(0, grip, &page.window);
        for (int moved = 10; moved <= 100; moved += 10)
            QTest::touchEvent(&page.window, screen).move(0, grip - QPoint(moved, 0), &page.window);
        QTest::touchEvent(&page.window, screen).release(0, grip - QPoint(100, 0), &page.window);
        const double span = handle->parentItem()->property("span").toDouble();
        QVERIFY2(std::abs(page.session().trimming()->end() - (4.0 - 400.0 / span)) < 0.06,
                 qPrintable(QString::number(page.session().trimming()->end())));
    }

    void faces_are_named_by_keys_and_by_choosing() {
        Page page({"a.png"});
        const fs::path portrait = page.bench.photo("anna.jpg");
        if (!fs::exists(tp::test::in_source("resources/samples/anna_smiling.jpg")))
            QSKIP("The sample portrait is not there.");
        fs::copy_file(tp::test::in_source("resources/samples/anna_smiling.jpg"), portrait);
        SidecarChanges changes;
        changes.persons = {"Anna"};
        QCOMPARE(write_sidecar(page.bench.photo("a.png"), changes), std::string());
        page.bench.album->rescan();
        CARE_TRY_COMPARE(page.session().people()->known(""), QStringList{"Anna"});
        page.session().open_photo(portrait);
        CARE_TRY_VERIFY(page.bench.rests() && !page.session().faces()->looking());
        QCOMPARE(page.session().faces()->count(), 1);
        QVERIFY(page.tab_to("Face without a name, Press to name this face, 1 of 1"));
        page.key(Qt::Key_Return);
        QCOMPARE(page.focused(), QString("Who is face 1?"));
        for (const char letter : std::string("Tom"))
            QTest::keyClick(&page.window, letter);
        QVERIFY(named(page, "Anna, 1 of 1") == nullptr); // only who may be meant
        page.key(Qt::Key_Return);
        QVERIFY(page.bench.rests());
        CARE_TRY_COMPARE(page.bench.record("anna.jpg").persons, std::vector<std::string>{"Tom"});
        CARE_TRY_COMPARE(page.focused(), QString("Tom, 1 of 1"));
        QVERIFY(press(named(page, "Tom, 1 of 1"))); // and by a screen reader's actions
        QVERIFY(press(named(page, "Anna, 1 of 2")) || press(named(page, "Anna, 1 of 1")));
        QVERIFY(page.bench.rests());
        CARE_TRY_COMPARE(page.bench.record("anna.jpg").persons, std::vector<std::string>{"Anna"});
        QVERIFY(press(named(page, "Anna, 1 of 1")));
        QVERIFY(press(named(page, "Nobody I know")));
        QVERIFY(page.bench.rests());
        CARE_TRY_COMPARE(page.bench.record("anna.jpg").persons, std::vector<std::string>{});
        page.session().closePhoto(); // with its faces
        QCOMPARE(page.session().faces()->count(), 0);
    }

    void the_language_of_a_name_is_chosen_by_keys_by_touch_and_by_a_screen_reader() {
        Page page({"a.png"});
        SidecarChanges changes;
        changes.faces = {{0.5, 0.5, 0.2, 0.2, "Giulia"}, {0.2, 0.5, 0.2, 0.2, ""}};
        QCOMPARE(write_sidecar(page.bench.photo("a.png"), changes), std::string());
        page.session().openRow(0);
        CARE_TRY_VERIFY(page.bench.rests() && !page.session().faces()->looking());
        const auto language = [&] {
            AlbumKeeper keeper(page.bench.root());
            const auto tag = NameLanguages(keeper).of("Giulia");
            return tag ? *tag : tag.error();
        };
        const auto option = [](const char* words) { return QString("Language of the name: ") + words; };
        page.session().faces()->choose(0);
        QVERIFY(named(page, option("italiano")) == nullptr); // this face has no name
        QVERIFY(page.tab_to("Giulia, 2 of 2"));
        page.key(Qt::Key_Return);
        QVERIFY(named(page, option("Same as the page"))->state().checked);
        QVERIFY(page.tab_to(option("italiano")));
        page.key(Qt::Key_Space);
        QVERIFY(page.bench.rests());
        QCOMPARE(language(), std::string("it"));
        QCOMPARE(page.focused(), option("italiano")); // the keyboard stays
        QVERIFY(named(page, option("italiano"))->state().checked);
        QVERIFY(!named(page, option("Same as the page"))->state().checked);
        QCOMPARE(page.bench.last_said(), QString("Saved: Giulia. Language of the name: italiano."));
        QVERIFY(press(named(page, option("polski"))));
        QVERIFY(page.bench.rests());
        QCOMPARE(language(), std::string("pl"));
        QVERIFY(page.tab_to(option("Türkçe"))); // and so in view
        QQuickItem* const turkish = page.window.activeFocusItem();
        const QPoint place = turkish->mapToScene({0.5 * turkish->width(), 0.5 * turkish->height()}).toPoint();
        QPointingDevice* const finger = QTest::createTouchDevice();
        QTest::touchEvent(&page.window, finger).press(0, place, &page.window);
        QTest::touchEvent(&page.window, finger).release(0, place, &page.window);
        QVERIFY(page.bench.rests());
        QCOMPARE(language(), std::string("tr"));
        page.session().history()->undo();
        QVERIFY(page.bench.rests());
        QCOMPARE(language(), std::string("pl"));
        CARE_TRY_VERIFY(named(page, option("polski"))->state().checked);
        QVERIFY(page.bench.last_said().startsWith("Undone: "));
        QVERIFY(press(named(page, option("Same as the page"))));
        QVERIFY(page.bench.rests());
        QCOMPARE(language(), std::string());
    }

    void a_description_is_saved_when_its_field_is_left() {
        Page page({"a.png"});
        page.session().openRow(0);
        QVERIFY(page.bench.rests());
        QVERIFY(page.tab_to("In one sentence (English)"));
        for (const char letter : std::string("a garden"))
            QTest::keyClick(&page.window, letter);
        QVERIFY(named(page, "8 of 250 characters") != nullptr);
        QVERIFY(named(page, "Save the description") != nullptr);
        page.key(Qt::Key_Tab);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.last_said(), QString("The description is saved."));
        QCOMPARE(page.bench.record("a.png").alt_text.at("en"), std::string("a garden"));
        QVERIFY(named(page, "The description is saved") != nullptr);
        page.session().history()->undo();
        QVERIFY(page.bench.rests());
        QVERIFY(named(page, "0 of 250 characters") != nullptr);
    }

    void a_label_is_given_by_choosing_and_by_typing() {
        Page page({"a.png"});
        page.bench.add_sound("a.png", 1.0, 300.0);
        SidecarChanges changes;
        changes.persons = {"Anna"};
        QCOMPARE(write_sidecar(page.bench.photo("a.png"), changes), std::string());
        page.bench.album->touched(page.bench.photo("a.png"));
        CARE_TRY_COMPARE(page.session().people()->known(""), QStringList{"Anna"});
        page.session().open_photo(page.bench.photo("a.png"));
        QVERIFY(page.bench.rests());
        QVERIFY(press(named(page, "Label…")));
        QVERIFY(press(named(page, "Anna, 1 of 1")));
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.record("a.png").tags.at(0).label.person, std::string("Anna"));
        QCOMPARE(page.focused(), QString("Who it is about"));
        QVERIFY(page.tab_to("Who speaks"));
        for (const char letter : std::string("Tom"))
            QTest::keyClick(&page.window, letter);
        page.key(Qt::Key_Tab); // leaving it alone gives no name
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.record("a.png").tags.at(0).label.speaker, std::string());
        page.key(Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(page.focused(), QString("Who speaks"));
        page.key(Qt::Key_Return);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.record("a.png").tags.at(0).label.speaker, std::string("Tom"));
        QVERIFY(press(named(page, "Language: Deutsch")));
        QVERIFY(page.bench.rests());
        QCOMPARE(page.bench.record("a.png").tags.at(0).label.language, std::string("de"));
    }
};

} // namespace care_photo_page_test

TP_TEST(care_photo_page_test, CarePhotoPageTest, window)
#include "care_photo_page_test.moc"
