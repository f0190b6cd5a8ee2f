// SPDX-License-Identifier: Apache-2.0
#include "care_page.hpp"
#include "page_test.hpp"
#include "test_program.hpp"

#include <QAccessible>
#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPoint>
#include <QPointF>
#include <QQuickItem>
#include <QQuickView>
#include <QRectF>
#include <QSet>

namespace care_page_test {

using namespace tp;
namespace fs = std::filesystem;

class CarePageTest : public PageTest {
    Q_OBJECT
private slots:
    void it_loads_with_the_photographs_and_a_word_on_what_to_do() {
        Page page;
        QCOMPARE(page.window.status(), QQuickView::Ready);
        QVERIFY(named(page, "Photographs of the album") != nullptr);
        QVERIFY(named(page, "Choose a photograph to look after it.") != nullptr);
        QVERIFY(beginning(page, "a.png") != nullptr);
        QVERIFY(beginning(page, "c.png")->text(QAccessible::Name).endsWith(" of 3"));
    }

    void an_album_without_a_folder_says_so() {
        Page page({}, {1280, 800}, false);
        QVERIFY(named(page, "The album has no folder yet. You will be asked for one when you import.") !=
                nullptr);
        page.key(Qt::Key_Tab);
        QVERIFY(!page.focused().isEmpty());
    }

    void sections_are_headings() {
        Page page;
        page.session().openRow(0);
        QVERIFY(page.bench.rests());
        QStringList headings;
        for (QAccessibleInterface* one : everything(page))
            if (one->role() == QAccessible::Heading)
                headings << one->text(QAccessible::Name);
        QCOMPARE(headings, QStringList({"Photographs of the album", page.session().photoName(), "Faces", "Recordings",
                                        "Description", "The photograph"}));
    }

    void everything_can_be_named_found_and_hit() {
        for (const QSize size : {QSize(1280, 800), QSize(600, 1000), QSize(480, 560)})
            for (const double scale : {1.0, 2.0}) {
                Page page({"a.png", "b.png", "c.png"}, size);
                page.set_text_scale(scale);
                check_operable(page);
                page.session().openRow(0);
                QVERIFY(page.bench.rests());
                page.bench.add_sound("a.png", 1.0, 300.0);
                page.session().open_photo(page.bench.photo("a.png"));
                QVERIFY(page.bench.rests());
                QCOMPARE(page.session().recordings()->count(), 1);
                check_operable(page);
                press(named(page, "Label…"));
                check_operable(page);
            }
    }

    void what_the_keyboard_comes_to_is_in_view_and_nothing_traps_it() {
        for (const QSize size : {QSize(1280, 800), QSize(600, 700)}) {
            Page page({"a.png", "b.png", "c.png"}, size);
            page.bench.add_sound("a.png", 1.0, 300.0);
            page.session().open_photo(page.bench.photo("a.png"));
            QVERIFY(page.bench.rests());
            QVERIFY(page.tab_to("Back to the photographs"));
            QSet<QQuickItem*> seen;
            QQuickItem* const first = page.window.activeFocusItem();
            bool round = false;
            for (int i = 0; i < 100 && !round; ++i) {
                page.key(Qt::Key_Tab);
                const QQuickItem* focused = page.window.activeFocusItem();
                seen << page.window.activeFocusItem();
                const QRectF place = focused->mapRectToScene(focused->boundingRect());
                QVERIFY2(place.top() >= -1.0 && place.top() + std::min(place.height(), 300.0) <= page.window.height() + 1.0,
                         qPrintable(page.focused() + QString(" at %1 … %2").arg(place.top()).arg(place.bottom())));
                round = page.window.activeFocusItem() == first;
            }
            QVERIFY(round);
            QVERIFY(seen.size() > 20);
        }
    }

    void arrow_keys_go_through_the_photographs_and_return_opens_one() {
        Page page;
        while (!page.focused().endsWith(" of 3"))
            page.key(Qt::Key_Tab);
        QVERIFY(page.focused().endsWith("1 of 3"));
        page.key(Qt::Key_Down);
        QVERIFY(page.focused().endsWith("2 of 3"));
        page.key(Qt::Key_End);
        QVERIFY(page.focused().endsWith("3 of 3"));
        page.key(Qt::Key_Up);
        const QString name = page.focused().section(',', 0, 0);
        page.key(Qt::Key_Return);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.session().photoName(), name);
        QCOMPARE(page.focused(), QString("Back to the photographs"));
    }

    void back_from_a_far_row_the_controls_above_are_in_view_again() {
        std::vector<std::string> names;
        for (char letter = 'a'; letter <= 'z'; ++letter)
            names.push_back(std::string(1, letter) + ".png");
        Page page(names, {1280, 500});
        while (!page.focused().endsWith(" of 26"))
            page.key(Qt::Key_Tab);
        page.key(Qt::Key_End);
        QVERIFY2(page.focused().endsWith("26 of 26"), qPrintable(page.focused()));
        QVERIFY(page.item("photoList")->property("contentY").toDouble() > 500.0);
        page.key(Qt::Key_Tab, Qt::ShiftModifier);
        const auto in_view = [&page] {
            const QQuickItem* const focused = page.window.activeFocusItem();
            const QRectF place = focused->mapRectToScene(focused->boundingRect());
            return place.top() >= 0.0 && place.bottom() <= page.window.height();
        };
        QTRY_VERIFY(in_view());
        QVERIFY(!page.focused().contains(" of 26"));
        while (page.focused() != "Import a folder…") {
            page.key(Qt::Key_Tab, Qt::ShiftModifier);
            QTRY_VERIFY2(in_view(), qPrintable(page.focused()));
        }
    }

    void on_a_tall_window_one_comes_after_the_other_and_back_again() {
        Page page({"a.png", "b.png", "c.png"}, {600, 1000});
        while (!page.focused().endsWith(" of 3"))
            page.key(Qt::Key_Tab);
        page.key(Qt::Key_Down);
        page.key(Qt::Key_Space);
        QVERIFY(page.bench.rests());
        QVERIFY(named(page, "Photographs of the album") == nullptr);
        QCOMPARE(page.focused(), QString("Back to the photographs"));
        page.key(Qt::Key_Return);
        QVERIFY(!page.session().photoOpen());
        QVERIFY(named(page, "Photographs of the album") != nullptr);
        QVERIFY(page.focused().endsWith("2 of 3"));
    }

    void the_keyboard_stays_on_undo_and_redo_as_long_as_there_is_one() {
        Page page({"a.png"});
        page.session().openRow(0);
        QVERIFY(page.bench.rests());
        page.session().descriptions()->typeAltText("A garden");
        page.session().descriptions()->save();
        QVERIFY(page.bench.rests());
        page.item("back")->forceActiveFocus();
        QVERIFY(page.tab_to("Undo: a.png was described"));
        page.key(Qt::Key_Return);
        QVERIFY(page.bench.rests());
        CARE_TRY_COMPARE(page.focused(), QString("Redo: a.png was described"));
        page.key(Qt::Key_Space);
        QVERIFY(page.bench.rests());
        CARE_TRY_COMPARE(page.focused(), QString("Undo: a.png was described"));
    }

    void an_unfinished_import_goes_on_and_the_keyboard_is_on_its_stop() {
        Page page({"a.png"});
        for (int i = 0; i < 20; ++i)
            a_photo(page.bench.folder, "card/" + std::to_string(i) + ".jpg", 50 + i);
        page.session().importing()->import({QUrl::fromLocalFile(QString::fromStdString((page.bench.folder / "card").string()))});
        QVERIFY(named(page, "Stop the import") != nullptr);
        QVERIFY(press(named(page, "Stop the import")));
        CARE_TRY_VERIFY(named(page, "Continue the unfinished import") != nullptr);
        QVERIFY(page.tab_to("Continue the unfinished import"));
        page.key(Qt::Key_Return);
        QVERIFY(page.focused() == "Stop the import" || page.focused() == "Import photographs…");
        CARE_TRY_VERIFY(!page.session().importing()->running());
        CARE_TRY_COMPARE(page.session().photos()->total(), 21);
        QCOMPARE(page.focused(), QString("Import photographs…"));
    }

    void a_deleted_photograph_leaves_the_keyboard_in_the_list_and_undo_opens_it_again() {
        Page page({"a.png", "b.png"});
        page.session().open_photo(page.bench.photo("a.png"));
        QVERIFY(page.bench.rests());
        QVERIFY(page.tab_to("Delete the photograph"));
        page.key(Qt::Key_Return);
        QVERIFY(page.bench.rests());
        CARE_TRY_VERIFY(page.focused().startsWith("b.png"));
        QVERIFY(named(page, "Undo: a.png was deleted") != nullptr);
        page.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(page.bench.rests());
        QCOMPARE(page.session().photoName(), QString("a.png"));
        QCOMPARE(page.focused(), QString("Back to the photographs"));
    }

    void escape_stops_what_sounds_and_is_else_left_to_the_program() {
        Page page({"a.png"});
        page.bench.add_sound("a.png", 4.0, 300.0);
        page.session().open_photo(page.bench.photo("a.png"));
        QVERIFY(page.bench.rests());
        QVERIFY(press(named(page, "Play")));
        QVERIFY(page.session().trimming()->playing());
        page.window.rootObject()->forceActiveFocus();
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QCoreApplication::sendEvent(&page.window, &escape);
        QVERIFY(escape.isAccepted());
        QVERIFY(!page.session().trimming()->playing());
        QKeyEvent again(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QCoreApplication::sendEvent(&page.window, &again);
        QVERIFY(!again.isAccepted());
    }

    void photographs_dropped_on_the_window_are_imported() {
        Page page({"a.png"});
        const fs::path dropped = a_picture(page.bench.folder, "card/new.png", 5);
        QMimeData mime;
        mime.setUrls({QUrl::fromLocalFile(QString::fromStdString(dropped.string()))});
        const QPointF middle(page.window.width() / 2.0, page.window.height() / 2.0);
        QDragEnterEvent enter(middle.toPoint(), Qt::CopyAction, &mime, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&page.window, &enter);
        QDropEvent drop(middle, Qt::CopyAction, &mime, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&page.window, &drop);
        CARE_TRY_VERIFY(named(page, "1 photograph(s) imported.") != nullptr);
        CARE_TRY_VERIFY(beginning(page, "new.png") != nullptr);
    }

    void each_dialog_opens_and_closes() {
        Page page({"a.png"});
        page.session().openRow(0);
        QVERIFY(page.bench.rests());
        const std::pair<const char*, const char*> dialogs[] = {{"Import photographs…", "photosDialog"},
                                                               {"Add a sound file…", "soundsDialog"}};
        for (const auto& [button, name] : dialogs) {
            QVERIFY2(press(named(page, button)), button);
            auto* const dialog = page.item(name)->property("item").value<QObject*>();
            QVERIFY2(dialog != nullptr, name);
            CARE_TRY_VERIFY(dialog->property("visible").toBool());
            QMetaObject::invokeMethod(dialog, "reject");
            CARE_TRY_VERIFY(!dialog->property("visible").toBool());
        }
    }

    void a_folder_is_imported_by_a_screen_readers_actions_alone() {
        Page page({"a.png"});
        a_picture(page.bench.folder, "card/new.png", 5);
        QVERIFY(press(named(page, "Import a folder…")));
        page.session().folders()->chooser()->begin_in(
            QString::fromStdString(page.bench.folder.path().string()));
        CARE_TRY_VERIFY(beginning(page, "card") != nullptr);
        QVERIFY(press(beginning(page, "card")));
        QVERIFY(press(named(page, "Choose this folder")));
        QVERIFY(!page.session().folders()->choosing());
        CARE_TRY_VERIFY(named(page, "1 photograph(s) imported.") != nullptr);
        CARE_TRY_VERIFY(beginning(page, "new.png") != nullptr);
    }

    void a_folder_for_the_album_is_chosen_on_the_page_and_escape_ends_that() {
        Page page({"a.png"});
        emit page.session().importing()->folderWanted();
        CARE_TRY_VERIFY(named(page, "Choose this folder") != nullptr);
        QVERIFY(page.window.activeFocusItem() != nullptr);
        page.key(Qt::Key_Escape);
        QVERIFY(!page.session().folders()->choosing());
        CARE_TRY_VERIFY(named(page, "Choose this folder") == nullptr);
    }

    void mending_and_printing_are_asked_for() {
        Page page({"a.png"});
        page.session().openRow(0);
        QVERIFY(page.bench.rests());
        QStringList asked;
        QObject::connect(&page.session(), &CareSession::mendAsked, &page.window, [&](const QString& photo) { asked << photo; });
        QObject::connect(&page.session(), &CareSession::printAsked, &page.window, [&](const QString& photo) { asked << photo; });
        QVERIFY(press(named(page, "Mend contours…")));
        QVERIFY(press(named(page, "Print a tactile sheet…")));
        const QString photo = QString::fromStdString(page.bench.photo("a.png").string());
        QCOMPARE(asked, QStringList({photo, photo}));
    }
};

} // namespace care_page_test

TP_TEST(care_page_test, CarePageTest, window)
#include "care_page_test.moc"
