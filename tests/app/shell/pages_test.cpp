// SPDX-License-Identifier: Apache-2.0
#include "page_test.hpp"
#include "page_window.hpp"
#include "whole_program.hpp"

#include <QColor>
#include <QFile>
#include <QGuiApplication>
#include <QRect>
#include <QRegularExpression>
#include <QTranslator>
#include <QUrl>

#include <utility>

using namespace tp;

namespace {

const QStringList every_page{"start", "browse", "explore", "care",  "capture",
                             "mend",  "print",  "lab",     "study", "settings"};

/// Marks every text that goes through translation.
class PseudoLocale : public QTranslator {
public:
    QString translate(const char*, const char* source, const char*, int n) const override {
        QString text = QString::fromUtf8(source);
        if (n >= 0)
            text.replace("%n", QString::number(n));
        return "⟦" + longer(text) + "⟧";
    }
    bool isEmpty() const override { return false; }

private:
    virtual QString longer(const QString& text) const { return text; }
};

/// As a language does whose words are a third longer.
class LongerWords final : public PseudoLocale {
    QString longer(const QString& text) const override {
        static const QRegularExpression vowel("([aeiouAEIOU])");
        return QString(text).replace(vowel, "\\1\\1");
    }
};

/// Where a page has all that it shows.
void settle(WholeProgram& whole) {
    QTRY_VERIFY_WITH_TIMEOUT(whole.complete(), 60000);
    QTest::qWait(50);
}

/// Whether it belongs to what is seen of the world, which has the same right and left for everybody.
bool shows_a_place(const QQuickItem& item) {
    const QStringList arrows{"←", "→", "↑", "↓"};
    if (arrows.contains(item.property("text").toString()))
        return true;
    for (const QQuickItem* one = item.parentItem(); one != nullptr; one = one->parentItem())
        if (one->objectName() == "surface")
            return true;
    return false;
}

} // namespace

class PagesTest : public PageTest {
    Q_OBJECT
private slots:
    void everything_on_every_page_has_a_name_a_size_and_its_turn_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("text");
        QTest::addColumn<QString>("language");
        QTest::newRow("wide") << QSize(1280, 800) << 1.0 << "en";
        QTest::newRow("tall, large text, German") << QSize(800, 1280) << 2.0 << "de";
        QTest::newRow("wide, large text, Korean") << QSize(1280, 800) << 2.0 << "ko";
    }
    void everything_on_every_page_has_a_name_a_size_and_its_turn() {
        QFETCH(QSize, size);
        QFETCH(double, text);
        QFETCH(QString, language);
        Choices choices = WholeProgram::asked();
        choices.text_scale = text;
        choices.language = language;
        WholeProgram whole(choices);
        whole.window->resize(size);
        QVERIFY(whole.shown());
        for (const QString& page : every_page) {
            whole.shell().open(page);
            settle(whole);
            QVERIFY2(whole.window->activeFocusItem() != nullptr, qPrintable(page));
            QCOMPARE(page + PageWindow::faulty_targets(*whole.window, 48.0).join("; "), page);
            const QStringList tabbed = PageWindow::tab_order(*whole.window);
            QVERIFY2(!tabbed.contains("no way round"), qPrintable(page + ": " + tabbed.join(", ")));
        }
    }

    void written_from_right_to_left_every_page_is_the_other_way_round_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("text");
        QTest::newRow("wide") << QSize(1280, 800) << 1.0;
        QTest::newRow("tall, large text") << QSize(800, 1280) << 2.0;
    }
    /// But for what shows a place or a time: surfaces, and the arrows and handles that go with them.
    void written_from_right_to_left_every_page_is_the_other_way_round() {
        QFETCH(QSize, size);
        QFETCH(double, text);
        Choices choices = WholeProgram::asked();
        choices.text_scale = text;
        WholeProgram whole(choices);
        whole.window->resize(size);
        QVERIFY(whole.shown());
        const auto back = qScopeGuard([] { QGuiApplication::setLayoutDirection(Qt::LeftToRight); });
        using Places = QList<std::pair<QString, QRect>>; // a name, and where it lies
        const auto places = [&](Qt::LayoutDirection direction) {
            QGuiApplication::setLayoutDirection(direction);
            settle(whole);
            Places all;
            for (QAccessibleInterface* one : PageWindow::everything(*whole.window))
                if (const QQuickItem* item = PageWindow::tab_stop(one); item != nullptr && !shows_a_place(*item))
                    all << std::pair(one->text(QAccessible::Name),
                                     item->mapRectToScene({0, 0, item->width(), item->height()}).toRect());
            return all;
        };
        int moved = 0;
        for (const QString& page : every_page) {
            whole.shell().open(page);
            if (page == "mend") {
                whole.program->mend().open(QUrl::fromLocalFile(whole.folder.filePath("Family/anna_smiling.jpg")));
                QTRY_VERIFY_WITH_TIMEOUT(PageWindow::named(*whole.window, "Next point") != nullptr, 60000);
            }
            Places usual = places(Qt::LeftToRight), mirrored, usual_before;
            do { // what the page is still finding out may make room for itself meanwhile
                usual_before = usual;
                mirrored = places(Qt::RightToLeft);
                usual = places(Qt::LeftToRight);
            } while (usual != usual_before);
            QCOMPARE(mirrored.size(), usual.size());
            QVERIFY2(usual.size() > 4, qPrintable(page));
            for (qsizetype i = 0; i < usual.size(); ++i) {
                const QRect before = usual[i].second, after = mirrored[i].second;
                QCOMPARE(mirrored[i].first, usual[i].first);
                const QRect expected(size.width() - before.x() - before.width(), before.y(), before.width(), before.height());
                QVERIFY2(expected.adjusted(-1, -1, 1, 1).contains(after) && after.adjusted(-1, -1, 1, 1).contains(expected),
                         qPrintable(QString("%1: %2 lies at %3, %4 and is %5 px wide, mirrored %6, %7 and %8")
                                        .arg(page, usual[i].first).arg(before.x()).arg(before.y()).arg(before.width())
                                        .arg(after.x()).arg(after.y()).arg(after.width())));
                moved += after.x() != before.x();
            }
        }
        QVERIFY(moved > 20);
    }

    void escape_leads_home_from_everywhere() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        for (const QString& page : every_page) {
            whole.shell().open(page);
            settle(whole);
            for (int i = 0; i < 4 && !whole.shell().home(); ++i)
                QTest::keyClick(whole.window.get(), Qt::Key_Escape);
            QVERIFY2(whole.shell().home(), qPrintable(page));
        }
    }

    void a_lost_keyboard_comes_back_to_the_page() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        for (const QString& page : every_page) {
            whole.shell().open(page);
            settle(whole);
            whole.window->rootObject()->setFocus(false);
            QVERIFY(whole.window->activeFocusItem() == whole.window->contentItem());
            QTRY_VERIFY2(whole.window->activeFocusItem() != whole.window->contentItem(), qPrintable(page));
            QVERIFY2(whole.window->activeFocusItem()->activeFocusOnTab(), qPrintable(page));
            for (int i = 0; i < 4 && !whole.shell().home(); ++i)
                QTest::keyClick(whole.window.get(), Qt::Key_Escape);
            QVERIFY2(whole.shell().home(), qPrintable(page));
        }
    }

    void alt_and_left_goes_back_whatever_a_page_does_with_arrows() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        for (const QString& page : every_page) {
            whole.shell().goHome();
            whole.shell().open("settings");
            whole.shell().open(page);
            settle(whole);
            QTest::keyClick(whole.window.get(), Qt::Key_Left, Qt::AltModifier);
            QCOMPARE(page + " " + whole.shell().page(), page + (page == "settings" || page == "start" ? " start" : " settings"));
        }
    }

    void every_page_says_where_one_is_and_has_help() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        for (const QString& page : every_page) {
            whole.voice.clear();
            whole.shell().open(page);
            settle(whole);
            QVERIFY2(!whole.voice.said().isEmpty(), qPrintable(page));
            whole.voice.clear();
            QTest::keyClick(whole.window.get(), Qt::Key_F1);
            const QStringList said = whole.voice.said();
            QVERIFY2(said.size() == 1 && said[0].size() > 200, qPrintable(page + ": " + said.join(" | ")));
        }
    }

    void the_programs_voice_says_what_tab_comes_to() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        whole.shell().open("settings");
        settle(whole);
        QStringList said;
        for (int i = 0; i < 60; ++i) {
            whole.voice.clear();
            QTest::keyClick(whole.window.get(), Qt::Key_Tab);
            said << whole.voice.said();
        }
        for (const char* words :
             {"Speed of speech: Normal, choice, selected", "Colours: Light, choice", "Home, button",
              "Sound effects, switch, on", "Text size, slider, 100 percent"})
            QVERIFY2(said.contains(words), qPrintable(QString(words) + " is not in: " + said.join("; ")));
        whole.program->settings().speech()->chooseVoice(1); // a screen reader says it itself
        whole.voice.clear();
        QTest::keyClick(whole.window.get(), Qt::Key_Tab);
        QCOMPARE(whole.voice.said(), QStringList());
    }

    void no_text_escapes_translation() {
        PseudoLocale pseudo;
        WholeProgram whole;
        QCoreApplication::installTranslator(&pseudo);
        const auto back = qScopeGuard([&] { QCoreApplication::removeTranslator(&pseudo); });
        emit whole.program->language_changed();
        QVERIFY(whole.shown());
        QStringList untranslated;
        whole.voice.clear();
        for (const QString& page : every_page) {
            whole.shell().open(page);
            settle(whole);
            for (QAccessibleInterface* one : PageWindow::everything(*whole.window)) {
                const QString name = one->text(QAccessible::Name);
                const bool says_something = name.contains(QRegularExpression("[A-Za-z]{3}"));
                const bool is_data = name.contains(whole.folder.path()) || name.contains(".jpg") ||
                                     QStringList{"English", "Deutsch"}.contains(name.section(": ", -1));
                if (says_something && !is_data && !name.contains("⟦"))
                    untranslated << page + ": " + name;
            }
            for (const QString& said : whole.voice.said())
                if (!said.contains("⟦") && said.contains(' '))
                    untranslated << page + " says: " + said;
            whole.voice.clear();
        }
        untranslated.removeDuplicates();
        QCOMPARE(untranslated.join('\n'), QString());
    }

    void no_text_is_clipped_in_a_language_of_longer_words_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<double>("text");
        QTest::newRow("wide") << QSize(1280, 800) << 1.0;
        QTest::newRow("wide, large text") << QSize(1280, 800) << 2.0;
        QTest::newRow("tall") << QSize(800, 1280) << 1.0;
        QTest::newRow("tall, large text") << QSize(800, 1280) << 2.0;
    }
    void no_text_is_clipped_in_a_language_of_longer_words() {
        QFETCH(QSize, size);
        QFETCH(double, text);
        LongerWords pseudo;
        Choices choices = WholeProgram::asked();
        choices.text_scale = text;
        WholeProgram whole(choices);
        QCoreApplication::installTranslator(&pseudo);
        const auto back = qScopeGuard([&] { QCoreApplication::removeTranslator(&pseudo); });
        emit whole.program->language_changed();
        whole.window->resize(size);
        QVERIFY(whole.shown());
        QStringList clipped;
        for (const QString& page : every_page) {
            whole.shell().open(page);
            settle(whole);
            const auto clipped_now = [&whole] { return PageWindow::clipped_texts(*whole.window); };
            // A busy machine lays out a page's texts one after the other.
            if (!QTest::qWaitFor([&] { return clipped_now().isEmpty(); }))
                for (const QString& one : clipped_now())
                    clipped << page + ": " + one;
        }
        QVERIFY2(clipped.isEmpty(), qPrintable(clipped.join('\n')));
    }

    void what_goes_wrong_below_the_pages_is_translated_too() {
        PseudoLocale pseudo;
        WholeProgram whole;
        settle(whole);
        QCoreApplication::installTranslator(&pseudo);
        const auto back = qScopeGuard([&] { QCoreApplication::removeTranslator(&pseudo); });
        emit whole.program->language_changed();
        whole.window->show();
        const auto heard = [&](const QString& sentence) { return !whole.voice.said().filter(sentence).isEmpty(); };

        whole.shell().open("browse");
        Choices choices = whole.program->preferences().choices();
        choices.folders << whole.folder.filePath("Gone");
        whole.program->preferences().set(choices);
        QTRY_VERIFY2(heard("⟦The folder \"" + whole.folder.filePath("Gone") + "\" is missing."),
                     qPrintable(whole.voice.said().join('\n')));

        const QString broken = whole.folder.filePath("broken.jpg");
        {
            QFile whole_photo(whole.folder.filePath("Family/anna_smiling.jpg")), half(broken);
            QVERIFY(whole_photo.open(QIODevice::ReadOnly) && half.open(QIODevice::WriteOnly));
            half.write(whole_photo.read(whole_photo.size() / 2));
        }
        for (const QString& page : QStringList{"explore", "mend"}) {
            whole.shell().open(page);
            settle(whole);
            whole.voice.clear();
            if (page == "explore")
                whole.program->explore().open(QUrl::fromLocalFile(broken));
            else
                whole.program->mend().open(QUrl::fromLocalFile(broken));
            QTRY_VERIFY2_WITH_TIMEOUT(heard("⟦The JPEG file is cut short: a part of the picture is missing."),
                                      qPrintable(page + ": " + whole.voice.said().join('\n')), 60000);
        }

        whole.shell().open("care");
        settle(whole);
        CareSession& care = whole.program->care();
        care.openRow(0);
        QTRY_VERIFY(care.photoOpen());
        whole.microphone_there = false;
        whole.voice.clear();
        care.take()->start();
        QTRY_VERIFY2(heard("⟦There is no microphone."), qPrintable(whole.voice.said().join('\n')));
        care.take()->askDiscard();
        care.take()->discard();
        QTRY_VERIFY(!care.take()->running());
        const QString name = care.photoName();
        care.deletePhoto();
        QTRY_VERIFY2(care.history()->undoText().contains("⟦" + name + " was deleted"),
                     qPrintable(care.history()->undoText()));
    }

    void the_language_changes_while_the_program_runs() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        whole.shell().open("settings");
        QCOMPARE(whole.window->title(), QString("Settings – TouchPhoto"));
        whole.program->settings().speech()->chooseLanguage(2);
        QCOMPARE(whole.voice.language(), QString("de"));
        QCOMPARE(whole.window->title(), QString("Einstellungen – TouchPhoto"));
        QTRY_VERIFY(PageWindow::named(*whole.window, "Farben: Dunkel") != nullptr);
        whole.program->settings().speech()->chooseLanguage(1);
        QTRY_VERIFY(PageWindow::named(*whole.window, "Colours: Dark") != nullptr);
    }

    void colours_and_sizes_follow_at_once() {
        WholeProgram whole;
        QVERIFY(whole.shown());
        whole.shell().open("settings");
        const QColor dark = whole.window->grabWindow().pixelColor(2, 400);
        whole.program->settings().looks()->chooseTheme(1);
        const QColor light = whole.window->grabWindow().pixelColor(2, 400);
        QVERIFY(dark.lightness() < 40 && light.lightness() > 215);
    }
};

QTEST_MAIN(PagesTest)
#include "pages_test.moc"
