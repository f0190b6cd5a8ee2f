// SPDX-License-Identifier: Apache-2.0
#include "app/parts/controls/controls_module.hpp"
#include "core/files/photo_endings.hpp"
#include "places.hpp"

#include <QAccessible>
#include <QColor>
#include <QPoint>
#include <QPointingDevice>
#include <QQuickItem>
#include <QQuickView>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QStringList>
#include <QTest>
#include <QUrl>
#include <QVariant>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

namespace {

QQuickItem* item(QQuickView& view, const char* name) {
    return view.rootObject()->findChild<QQuickItem*>(name);
}

QAccessibleInterface* accessible(QQuickView& view, const char* name) {
    return QAccessible::queryAccessibleInterface(item(view, name));
}

/// What a screen reader does when its user presses, toggles and so on.
void act(QAccessibleInterface* interface, const QString& action) {
    interface->actionInterface()->doAction(action);
}

/// WCAG 2.2: relative luminance of an sRGB colour, and the ratio of two.
double luminance(const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}
double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

} // namespace

class ControlsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QAccessible::setActive(true);
        tp::register_controls();
    }
    void init() {
        view_ = std::make_unique<QQuickView>(QUrl::fromLocalFile(tp::test::in_source("tests/app/parts/controls/Gallery.qml")));
        QCOMPARE(view_->status(), QQuickView::Ready);
        view_->show();
        view_->requestActivate();
        QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    }
    void cleanup() { view_.reset(); }

    void file_dialogs_show_what_the_album_takes() {
        const QStringList patterns = view_->rootObject()->property("photos").toString().split(' ');
        for (const std::string_view ending : tp::photo_endings)
            QVERIFY(patterns.contains("*" + QString::fromStdString(std::string(ending))));
        QVERIFY(patterns.contains("*.bmp") && patterns.contains("*.jp2")); // which open, though the album leaves them
    }

    void every_control_has_role_name_and_a_target_of_64_pixels() {
        struct Expected {
            const char* object;
            const char* name;
            QAccessible::Role role;
        };
        for (const Expected& expected : {Expected{"button", "A button", QAccessible::Button},
                                         Expected{"toggle", "A toggle", QAccessible::CheckBox},
                                         Expected{"slider", "A slider", QAccessible::Slider}}) {
            QAccessibleInterface* control = accessible(*view_, expected.object);
            QVERIFY2(control != nullptr, expected.object);
            QCOMPARE(control->role(), expected.role);
            QCOMPARE(control->text(QAccessible::Name), QString(expected.name));
            QVERIFY(control->state().focusable);
            QVERIFY(item(*view_, expected.object)->height() >= 64.0);
            QVERIFY(item(*view_, expected.object)->width() >= 64.0);
        }
        QCOMPARE(accessible(*view_, "button")->text(QAccessible::Description), QString("What it does"));
    }

    void words_have_roles() {
        QStringList headings;
        for (QQuickItem* child : view_->rootObject()->childItems())
            if (QAccessibleInterface* words = QAccessible::queryAccessibleInterface(child);
                words != nullptr && words->role() == QAccessible::Heading)
                headings << words->text(QAccessible::Name);
        QCOMPARE(headings, QStringList("A heading"));
    }

    void a_button_is_pressed_by_mouse_key_and_screen_reader() {
        QQuickItem* button = item(*view_, "button");
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, button->mapToScene({10, 10}).toPoint());
        QCOMPARE(presses(), 1);
        button->forceActiveFocus();
        QTest::keyClick(view_.get(), Qt::Key_Space);
        QTest::keyClick(view_.get(), Qt::Key_Return);
        QTest::keyClick(view_.get(), Qt::Key_Enter);
        QCOMPARE(presses(), 4);
        act(accessible(*view_, "button"), QAccessibleActionInterface::pressAction());
        QCOMPARE(presses(), 5);
    }

    void a_disabled_button_is_not_pressed_by_anybody() {
        QQuickItem* button = item(*view_, "disabled");
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, button->mapToScene({10, 10}).toPoint());
        act(accessible(*view_, "disabled"), QAccessibleActionInterface::pressAction());
        QCOMPARE(presses(), 0);
        QCOMPARE(accessible(*view_, "disabled")->text(QAccessible::Name), QString("Not now, not available"));
    }

    void a_toggle_is_thrown_by_mouse_key_and_screen_reader() {
        QQuickItem* toggle = item(*view_, "toggle");
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, toggle->mapToScene({20, 20}).toPoint());
        QVERIFY(wanted());
        act(accessible(*view_, "toggle"), QAccessibleActionInterface::toggleAction());
        QVERIFY(!wanted());
        toggle->forceActiveFocus();
        QTest::keyClick(view_.get(), Qt::Key_Space);
        QVERIFY(wanted());
        QVERIFY(accessible(*view_, "toggle")->state().checked);
        QTest::keyClick(view_.get(), Qt::Key_Return);
        QVERIFY(!wanted());
    }

    void a_toggle_follows_the_program() {
        view_->rootObject()->setProperty("wanted", true);
        QVERIFY(item(*view_, "toggle")->property("checked").toBool());
        act(accessible(*view_, "toggle"), QAccessibleActionInterface::toggleAction());
        view_->rootObject()->setProperty("wanted", true);
        QVERIFY(item(*view_, "toggle")->property("checked").toBool());
    }

    void a_slider_tells_its_bounds_and_is_set_by_key_and_screen_reader() {
        QAccessibleValueInterface* value = accessible(*view_, "slider")->valueInterface();
        QVERIFY(value != nullptr);
        QCOMPARE(value->minimumValue().toDouble(), 0.0);
        QCOMPARE(value->maximumValue().toDouble(), 1.0);
        QCOMPARE(value->currentValue().toDouble(), 0.5);
        value->setCurrentValue(0.8);
        QCOMPARE(picked(), 0.8);
        item(*view_, "slider")->forceActiveFocus();
        QTest::keyClick(view_.get(), Qt::Key_Left);
        QVERIFY(std::abs(picked() - 0.7) < 1e-9);
        act(accessible(*view_, "slider"), QAccessibleActionInterface::increaseAction());
        QVERIFY(std::abs(picked() - 0.8) < 1e-9);
    }

    void every_text_keeps_seven_to_one_data() {
        QTest::addColumn<int>("scheme");
        QTest::newRow("dark") << 0;
        QTest::newRow("light") << 1;
        QTest::newRow("yellow on black") << 2;
    }
    void every_text_keeps_seven_to_one() {
        QFETCH(int, scheme);
        QObject* theme = view_->rootObject()->property("theme").value<QObject*>();
        QVERIFY(theme != nullptr);
        theme->setProperty("scheme", scheme);
        const auto dark_again = qScopeGuard([&] { theme->setProperty("scheme", 0); });
        const auto colour = [&](const char* name) { return theme->property(name).value<QColor>(); };
        for (const char* ground : {"ground", "panel", "raised"})
            for (const char* text : {"text", "quiet", "accent", "finger", "line"})
                QVERIFY2(contrast(colour(text), colour(ground)) >= 7.0,
                         qPrintable(QString("%1 on %2: %3")
                                        .arg(text, ground)
                                        .arg(contrast(colour(text), colour(ground)))));
        for (const char* accent : {"accent", "accentPressed"})
            QVERIFY(contrast(colour("accentText"), colour(accent)) >= 7.0);
        QVERIFY(contrast(colour("text"), colour("pressed")) >= 7.0);
        for (const char* ground : {"ground", "panel", "raised"}) // what shows where a control is (WCAG 1.4.11)
            QVERIFY(contrast(colour("edge"), colour(ground)) >= 3.0);
    }

    void a_list_row_tells_its_place_and_is_pressed_by_mouse_key_and_screen_reader() {
        QAccessibleInterface* row = accessible(*view_, "row");
        QCOMPARE(row->role(), QAccessible::ListItem);
        QCOMPARE(row->text(QAccessible::Name), QString("Anna, 12 photographs, 2 of 9"));
        QVERIFY(item(*view_, "row")->height() >= 64.0);
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, item(*view_, "row")->mapToScene({20, 20}).toPoint());
        item(*view_, "row")->forceActiveFocus();
        QTest::keyClick(view_.get(), Qt::Key_Return);
        QTest::keyClick(view_.get(), Qt::Key_Space);
        act(row, QAccessibleActionInterface::pressAction());
        QCOMPARE(presses(), 4);
    }

    void a_field_tells_its_label_and_gives_what_was_typed_with_return_or_when_left() {
        QQuickItem* field = item(*view_, "field");
        field->forceActiveFocus();
        QQuickItem* input = view_->activeFocusItem();
        QVERIFY(input != nullptr && input->height() >= 64.0);
        QAccessibleInterface* words = QAccessible::queryAccessibleInterface(input);
        QCOMPARE(words->role(), QAccessible::EditableText);
        QCOMPARE(words->text(QAccessible::Name), QString("A field"));
        QTest::keyClick(view_.get(), Qt::Key_End);
        QTest::keyClick(view_.get(), Qt::Key_B);
        QCOMPARE(property("words").toString(), QString("Anna"));
        QCOMPARE(property("keystrokes").toInt(), 1);
        QTest::keyClick(view_.get(), Qt::Key_Return);
        QCOMPARE(property("words").toString(), QString("Annab"));
        QTest::keyClick(view_.get(), Qt::Key_C);
        item(*view_, "button")->forceActiveFocus();
        QCOMPARE(property("words").toString(), QString("Annabc"));
        view_->rootObject()->setProperty("words", "Tom");
        QCOMPARE(field->property("text").toString(), QString("Tom"));
    }

    void tab_leaves_an_area_and_what_was_typed_is_given() {
        item(*view_, "area")->forceActiveFocus();
        QQuickItem* input = view_->activeFocusItem();
        QTest::keyClick(view_.get(), Qt::Key_End);
        QTest::keyClick(view_.get(), Qt::Key_Return);
        QTest::keyClick(view_.get(), Qt::Key_X);
        QTest::keyClick(view_.get(), Qt::Key_Tab);
        QVERIFY(view_->activeFocusItem() != input);
        QCOMPARE(property("story").toString(), QString("In the garden\nx"));
        QTest::keyClick(view_.get(), Qt::Key_Backtab);
        QVERIFY(view_->activeFocusItem() == input);
        QTest::keyClick(view_.get(), Qt::Key_Backtab);
        QVERIFY(view_->activeFocusItem() != input);
    }

    void a_choice_has_each_of_its_options_in_reach() {
        QList<QAccessibleInterface*> options;
        for (QQuickItem* flow : item(*view_, "choice")->childItems())
            for (QQuickItem* one : flow->childItems())
                if (QAccessibleInterface* option = QAccessible::queryAccessibleInterface(one);
                    option != nullptr && option->role() == QAccessible::RadioButton)
                    options << option;
        QCOMPARE(options.size(), 3);
        QCOMPARE(options[1]->text(QAccessible::Name), QString("A choice: two"));
        QVERIFY(options[1]->state().checked && !options[0]->state().checked);
        act(options[2], QAccessibleActionInterface::pressAction());
        QCOMPARE(property("choice").toInt(), 2);
        QVERIFY(options[2]->state().checked && !options[1]->state().checked);
        auto* first = qobject_cast<QQuickItem*>(options[0]->object());
        QVERIFY(first->height() >= 64.0 && first->width() >= 64.0);
        first->forceActiveFocus();
        QTest::keyClick(view_.get(), Qt::Key_Return);
        QCOMPARE(property("choice").toInt(), 0);
        QTest::keyClick(view_.get(), Qt::Key_Tab);
        QTest::keyClick(view_.get(), Qt::Key_Space);
        QCOMPARE(property("choice").toInt(), 1);
    }

    void progress_tells_how_far_it_is() {
        QAccessibleInterface* progress = accessible(*view_, "progress");
        QCOMPARE(progress->role(), QAccessible::ProgressBar);
        QCOMPARE(progress->text(QAccessible::Name), QString("Import: 3 of 12"));
    }

    void what_the_keyboard_comes_to_is_scrolled_into_view() {
        QQuickItem* scroll = item(*view_, "scroll");
        for (const char* far : {"last", "first", "second"}) {
            item(*view_, far)->forceActiveFocus();
            const double top = item(*view_, far)->mapToItem(scroll, {0, 0}).y();
            QVERIFY2(top >= 0.0 && top + item(*view_, far)->height() <= scroll->height(), far);
        }
    }

    void a_finger_hears_letters_and_takes_the_one_it_is_lifted_on() {
        QQuickItem* board = item(*view_, "letters");
        const int columns = board->property("columns").toInt();
        QCOMPARE(columns, 5); // 400 px wide: 5 × 64 px and gaps
        const auto place = [&](int letter) {
            return board->mapToScene({70.0 * (letter % columns) + 32.0, 70.0 * (letter / columns) + 32.0}).toPoint();
        };
        QTest::mousePress(view_.get(), Qt::LeftButton, {}, place(0));
        QTest::mouseMove(view_.get(), place(1));
        QTest::mouseMove(view_.get(), place(6));
        QCOMPARE(property("spelt").toString(), QString()); // not before it is lifted
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, place(6));
        QCOMPARE(property("reachedLetters").toStringList(), QStringList({"A", "B", "G"}));
        QCOMPARE(property("spelt").toString(), QString("G"));
        QTest::mousePress(view_.get(), Qt::LeftButton, {}, place(2));
        QTest::mouseMove(view_.get(), place(2) - QPoint(0, 200)); // away: it was not meant
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, place(2) - QPoint(0, 200));
        QTest::mouseClick(view_.get(), Qt::LeftButton, {}, place(4) + QPoint(35, 0)); // between two is the one before
        QCOMPARE(property("spelt").toString(), QString("GE"));
    }

    void taps_that_soon_follow_each_other_count_each() {
        QPointingDevice* screen = QTest::createTouchDevice();
        const auto tap = [&](QPoint place) {
            QTest::touchEvent(view_.get(), screen).press(0, place, view_.get());
            QTest::touchEvent(view_.get(), screen).release(0, place, view_.get());
        };
        const QPoint row = item(*view_, "row")->mapToScene({30, 30}).toPoint();
        const QPoint letter = item(*view_, "letters")->mapToScene({30, 30}).toPoint();
        for (int i = 0; i < 4; ++i)
            tap(row);
        for (int i = 0; i < 4; ++i)
            tap(letter);
        QCOMPARE(presses(), 4);
        QCOMPARE(property("spelt").toString(), QString("AAAA"));
    }

    void letters_are_chosen_by_keys_and_screen_reader() {
        QQuickItem* board = item(*view_, "letters");
        board->forceActiveFocus();
        for (const auto key : {Qt::Key_Right, Qt::Key_Space, Qt::Key_Down, Qt::Key_Return, Qt::Key_Right, Qt::Key_Right,
                               Qt::Key_Left, Qt::Key_Up, Qt::Key_Enter})
            QTest::keyClick(view_.get(), key);
        QCOMPARE(property("spelt").toString(), QString("BGB"));
        QAccessibleInterface* letters = accessible(*view_, "letters");
        QCOMPARE(letters->text(QAccessible::Name), QString("Some letters"));
        QStringList names;
        for (int i = 0; i < letters->childCount(); ++i)
            if (letters->child(i)->role() == QAccessible::Button)
                names << letters->child(i)->text(QAccessible::Name);
        QCOMPARE(names, QStringList({"A", "B", "C", "D", "E", "F", "G", "H"}));
        act(letters->child(3), QAccessibleActionInterface::pressAction());
        QCOMPARE(property("spelt").toString(), QString("BGBD"));
    }

    void tab_goes_from_control_to_control() {
        item(*view_, "button")->forceActiveFocus();
        QTest::keyClick(view_.get(), Qt::Key_Tab);
        QVERIFY(item(*view_, "toggle")->hasActiveFocus()); // the disabled one is passed over
        QTest::keyClick(view_.get(), Qt::Key_Tab);
        QVERIFY(item(*view_, "slider")->hasActiveFocus());
    }

    /// Wrapped words change their height while the control that they are in takes its own from it.
    void no_height_hangs_on_itself_while_a_window_changes() {
        QTest::failOnWarning(QRegularExpression(".*"));
        view_ = std::make_unique<QQuickView>(
            QUrl::fromLocalFile(tp::test::in_source("tests/app/parts/controls/Resized.qml")));
        view_->show();
        QObject* theme = property("theme").value<QObject*>();
        const QScopeGuard usual([theme] { theme->setProperty("textScale", 1.0); });
        int completed = 0;
        for (int i = 1; i <= 400; ++i) {
            view_->rootObject()->setProperty("shown", i % 7 != 0);
            view_->rootObject()->setWidth(150 + i * 37 % 500);
            if (i % 5 == 0)
                theme->setProperty("textScale", 1.0 + 0.6 * (i % 3));
            QTest::qWait(3);
            completed += property("complete").toBool() ? 1 : 0;
        }
        QVERIFY2(completed > 100, qPrintable(QString::number(completed)));
    }

private:
    int presses() const { return view_->rootObject()->property("presses").toInt(); }
    QVariant property(const char* name) const { return view_->rootObject()->property(name); }
    bool wanted() const { return view_->rootObject()->property("wanted").toBool(); }
    double picked() const { return view_->rootObject()->property("picked").toDouble(); }

    std::unique_ptr<QQuickView> view_;
};

QTEST_MAIN(ControlsTest)
#include "controls_test.moc"
