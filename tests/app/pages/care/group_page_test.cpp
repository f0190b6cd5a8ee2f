// SPDX-License-Identifier: Apache-2.0
#include "care_page.hpp"
#include "known_faces.hpp"
#include "page_test.hpp"
#include "test_program.hpp"

#include <QAccessible>
#include <QCoreApplication>
#include <QStringList>

namespace group_page_test {

using namespace tp;
using namespace tp::testing;

namespace {

/// Person 1 is on three photographs, person 2 on two.
struct PeoplePage : Page {
    explicit PeoplePage(QSize size = {1280, 800}) : Page({"a.png", "b.png", "c.png"}, size) {
        for (const auto& [name, people] :
             {std::pair("a.png", std::vector{1, 2}), std::pair("b.png", std::vector{1, 2}),
              std::pair("c.png", std::vector{1})})
            QCOMPARE(look_at(*bench.album, bench.photo(name), people), std::string());
        bench.groups->go_on();
    }
    bool has(const QString& beginning_of_a_name) {
        return QTest::qWaitFor([&] { return beginning(*this, beginning_of_a_name) != nullptr; }, 60'000);
    }
    bool is_on(const QString& beginning_of_a_name) {
        return QTest::qWaitFor([&] { return focused().startsWith(beginning_of_a_name); }, 60'000);
    }
    void type(const QString& text) {
        for (const QChar letter : text)
            QTest::keyClick(&window, letter.toLatin1());
    }
    QStringList names_on(const std::string& photo) const {
        QStringList names;
        for (const std::string& person : bench.record(photo).persons)
            names << QString::fromStdString(person);
        return names;
    }
};

} // namespace

class GroupPageTest : public PageTest {
    Q_OBJECT
private slots:
    void by_keys_alone_all_are_named_and_taken_back() {
        PeoplePage page;
        QVERIFY(page.tab_to("People…"));
        page.key(Qt::Key_Return);
        QVERIFY(page.is_on("Back to the photographs"));
        QVERIFY(page.has("Who is this?, 3 photograph(s), 1 of 2"));
        QVERIFY(page.tab_to("Who is this?, 3 photograph(s), 1 of 2"));
        page.key(Qt::Key_Return);
        QVERIFY(page.is_on("Name"));
        page.type("Anna");
        page.key(Qt::Key_Return);
        QVERIFY(page.has("Anna, 3 photograph(s), 1 of 2"));
        CARE_TRY_VERIFY(page.session().groups()->row() == 1); // the next one is asked for
        QVERIFY(page.is_on("Name"));
        page.type("Bert");
        page.key(Qt::Key_Return);
        QVERIFY(page.has("Bert, 2 photograph(s), 2 of 2"));
        QVERIFY(page.bench.rests());
        QCOMPARE(page.names_on("a.png"), QStringList({"Anna", "Bert"}));
        QVERIFY(page.is_on("Bert")); // in the list: nobody is left
        page.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(page.has("Who is this?, 2 photograph(s), 2 of 2"));
        QVERIFY(page.bench.rests());
        QCOMPARE(page.names_on("a.png"), QStringList("Anna"));
        page.key(Qt::Key_Escape);
        QVERIFY(page.has("Photographs of the album"));
        QVERIFY(page.is_on("c.png"));
    }

    void by_keys_a_wrong_face_is_taken_out_and_the_keyboard_stays_beside_it() {
        PeoplePage page;
        page.session().groups()->show();
        QVERIFY(page.has("Who is this?, 3 photograph(s)"));
        page.session().groups()->choose(0);
        QVERIFY(page.has("c.png, "));
        QVERIFY(page.tab_to(beginning(page, "c.png, ")->text(QAccessible::Name)));
        page.key(Qt::Key_Down);
        QVERIFY(page.is_on("b.png, "));
        page.key(Qt::Key_Delete);
        QVERIFY(page.has("Who is this?, 2 photograph(s), 1 of 2"));
        QVERIFY(page.is_on("a.png, "));
        page.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(page.has("Who is this?, 3 photograph(s)"));
        QVERIFY(page.is_on("b.png, "));
    }

    void by_a_screen_readers_actions_a_wrong_face_is_taken_out_and_the_photograph_opened() {
        PeoplePage page;
        QVERIFY(press(named(page, "People…")));
        QVERIFY(page.has("Who is this?, 3 photograph(s)"));
        QVERIFY(press(beginning(page, "Who is this?, 3 photograph(s)")));
        QVERIFY(page.has("c.png, "));
        QVERIFY(named(page, "Not this person, not available") != nullptr); // no face is selected
        QVERIFY(press(beginning(page, "c.png, ")));
        QVERIFY(press(named(page, "Not this person")));
        QVERIFY(page.has("Who is this?, 2 photograph(s), 1 of 2"));
        QVERIFY(press(beginning(page, "a.png, ")));
        QVERIFY(press(named(page, "Open the photograph")));
        QVERIFY(page.has("Back to the photographs"));
        QCOMPARE(page.session().photo(), page.bench.photo("a.png"));
    }

    void a_known_face_is_confirmed_with_one_key() {
        PeoplePage page;
        page.session().groups()->show();
        QVERIFY(page.has("Who is this?, 3 photograph(s)"));
        page.session().groups()->choose(0);
        page.session().groups()->nameAll("Anna");
        QVERIFY(page.has("Anna, 3 photograph(s)"));
        page.session().groups()->hide();
        a_picture(page.bench.folder, "album/d.png", 9);
        page.bench.album->rescan();
        QVERIFY(page.bench.rests());
        QCOMPARE(look_at(*page.bench.album, page.bench.photo("d.png"), {1}), std::string());
        page.bench.groups->go_on();
        page.session().groups()->show();
        QVERIFY(page.has("Anna, 4 photograph(s), 1 to confirm"));
        QVERIFY(press(beginning(page, "Anna, 4 photograph(s), 1 to confirm")));
        QVERIFY(page.is_on("Yes, this is Anna"));
        page.key(Qt::Key_Y);
        QVERIFY(page.has("Anna, 4 photograph(s), "));
        QVERIFY(page.bench.rests());
        QCOMPARE(page.names_on("d.png"), QStringList("Anna"));
    }

    void everything_can_be_named_found_and_hit() {
        for (const QSize size : {QSize(1280, 800), QSize(600, 1024)})
            for (const double scale : {1.0, 2.0}) {
                PeoplePage page(size);
                page.set_text_scale(scale);
                page.session().groups()->show();
                QVERIFY(page.has("Who is this?, 3 photograph(s)"));
                check_operable(page, 3);
                page.session().groups()->choose(0);
                QVERIFY(page.has("Name"));
                check_operable(page);
                page.set_text_scale(1.0);
            }
    }

    void whoever_left_the_page_from_people_comes_back_to_the_photographs() {
        PeoplePage page;
        page.session().groups()->show();
        QVERIFY(page.has("Who is this?, 3 photograph(s)"));
        QVERIFY(page.tab_to("Who is this?, 3 photograph(s), 1 of 2"));
        page.window.rootObject()->setFocus(false); // another page has the keyboard
        page.session().leave();
        QVERIFY(page.has("c.png"));
        QCoreApplication::processEvents();
        page.session().enter();
        page.window.rootObject()->forceActiveFocus();
        QVERIFY(page.is_on("Import photographs…"));
    }

    void nobody_asks_for_people_where_faces_are_not_compared() {
        PeoplePage page;
        QVERIFY(named(page, "People…") != nullptr);
        page.bench.groups->set_on(false);
        QVERIFY(QTest::qWaitFor([&] { return named(page, "People…") == nullptr; }, 60'000));
    }
};

} // namespace group_page_test

TP_TEST(group_page_test, GroupPageTest, window)
#include "group_page_test.moc"
