// SPDX-License-Identifier: Apache-2.0
#include "app/pages/care/care_history.hpp"
#include "app/pages/care/care_people.hpp"
#include "app/pages/care/group_care.hpp"
#include "care_bench.hpp"
#include "known_faces.hpp"
#include "test_program.hpp"

#include <QSignalSpy>
#include <QStringList>

#include <fstream>
#include <system_error>
#include <unistd.h>

namespace group_care_test {

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;

namespace {

const QStringList nobody_named{"Who is this? 3 photograph(s)", "Who is this? 2 photograph(s)"};
const QStringList anna_named{"Anna 3 photograph(s)", "Who is this? 2 photograph(s)"};

/// Person 1 is on three photographs, person 2 on two, person 3 on one.
struct Bench : CareParts {
    Bench() : CareParts({"a.jpg", "b.jpg", "c.jpg"}) {
        look("a.jpg", {1, 2});
        look("b.jpg", {1, 2});
        look("c.jpg", {3, 1});
    }

    CarePeople people{*album};
    GroupCare care{*album, *groups, steps, teller,
                   [this](const QString& typed) { return people.known(typed); }};
    CareHistory history{steps, cared, *album, recording, teller};

    void look(const std::string& name, const std::vector<int>& persons) {
        QCOMPARE(look_at(*album, photo(name), persons), std::string());
        groups->go_on();
    }
    /// "Anna 3(2)": as the rows say it, when all has come to rest.
    QStringList told() {
        QStringList rows;
        for (int row = 0; row < care.rows()->rowCount(); ++row) {
            const QModelIndex index = care.rows()->index(row);
            rows << index.data(GroupRows::TextRole).toString() + " " +
                        index.data(GroupRows::DetailRole).toString();
        }
        return rows;
    }
    bool tells(const QStringList& rows) {
        return QTest::qWaitFor([&] { return rests() && !groups->grouping() && told() == rows; }, 60'000);
    }
    void show() {
        care.show();
        QVERIFY(tells(nobody_named)); // all are grouped
    }
    /// Every name that a file has while it is being written is taken, or free again.
    void let_nothing_be_written(bool nothing) const {
        for (int i = 0; i < 600; ++i) {
            const fs::path name =
                ".touchphoto-" + std::to_string(::getpid()) + "-" + std::to_string(i) + ".tmp";
            if (nothing)
                std::ofstream(root() / name);
            else
                fs::remove(root() / name);
        }
    }
    QStringList names(const std::string& name) const {
        QStringList all;
        for (const FaceRegion& face : record(name).faces)
            all << QString::fromStdString(face.name);
        return all;
    }
};

/// All people are shown.
struct ShownBench : Bench {
    ShownBench() { show(); }
};

/// The first of them has been named.
struct NamedBench : ShownBench {
    NamedBench() {
        care.choose(0);
        care.nameAll("Anna");
        QVERIFY(tells(anna_named));
    }
};

} // namespace

class GroupCareTest : public QObject {
    Q_OBJECT
private slots:
    void people_are_told_the_largest_first() {
        Bench bench;
        CARE_TRY_VERIFY(bench.rests() && !bench.groups->grouping()); // what is told is told once
        bench.show();
        QVERIFY(bench.tells(nobody_named));
        QCOMPARE(bench.care.summary(),
                 QString("2 person(s) without a name. 1 face(s) on one photograph only."));
        CARE_TRY_VERIFY(bench.voice.said().contains(bench.care.summary()));
        QCOMPARE(bench.names("a.jpg"), QStringList()); // nothing is written
    }

    void one_name_names_them_all_and_the_next_one_is_asked_for() {
        ShownBench bench;
        QSignalSpy chosen(&bench.care, &GroupCare::personChosen);
        bench.care.choose(0);
        QCOMPARE(bench.last_said(), QString("Who is this? 3 photograph(s)."));
        bench.care.nameAll("  Anna ");
        CARE_TRY_COMPARE(bench.last_said(),
                         QString("Saved: Anna, on 3 photograph(s). Who is the next? 2 photograph(s)."));
        QCOMPARE(chosen.size(), 2);
        QVERIFY(bench.sounded(Earcon::saved));
        QVERIFY(bench.tells(anna_named)); // rows stay where they are
        QCOMPARE(bench.care.row(), 1);
        QCOMPARE(bench.names("a.jpg"), QStringList{"Anna"});
        QCOMPARE(bench.names("b.jpg"), QStringList{"Anna"});
        QCOMPARE(bench.names("c.jpg"), QStringList{"Anna"});
        QVERIFY(std::abs(bench.record("c.jpg").faces[0].x - place_of_face(1).centre().x) < 1e-6);
        bench.care.nameAll("Bert");
        CARE_TRY_COMPARE(bench.last_said(),
                         QString("Saved: Bert, on 2 photograph(s). Nobody is left without a name."));
        QCOMPARE(bench.care.row(), -1);
        QVERIFY(bench.tells({"Anna 3 photograph(s)", "Bert 2 photograph(s)"}));
    }

    void one_undo_takes_all_of_it_back() {
        NamedBench bench;
        bench.history.undo();
        CARE_TRY_COMPARE(bench.last_said(), QString("Undone: 3 faces were named Anna."));
        QVERIFY(bench.tells(nobody_named));
        QCOMPARE(bench.names("a.jpg"), QStringList());
    }

    void two_groups_with_one_name_are_one_person() {
        NamedBench bench;
        bench.care.nameAll("Anna");
        QVERIFY(bench.tells({"Anna 3 photograph(s)"})); // on a and b twice
    }

    void a_new_photograph_is_to_be_confirmed_with_one_word() {
        NamedBench bench;
        a_photo(bench.folder, "album/d.jpg", 9);
        bench.album->rescan();
        CARE_TRY_VERIFY(!bench.album->scanning());
        bench.look("d.jpg", {1});
        QVERIFY(bench.tells({"Anna 4 photograph(s), 1 to confirm", "Who is this? 2 photograph(s)"}));
        QCOMPARE(bench.names("d.jpg"), QStringList());
        QVERIFY(bench.care.summary().startsWith("1 person(s) without a name. 1 face(s) to confirm."));
        bench.care.choose(0);
        QCOMPARE(bench.care.offer(), QString("Anna"));
        QCOMPARE(bench.care.faces()->face(0)->photo,
                 bench.photo("d.jpg")); // what is to be confirmed comes first
        bench.care.confirm();
        QVERIFY(bench.tells({"Anna 4 photograph(s)", "Who is this? 2 photograph(s)"}));
        QCOMPARE(bench.names("d.jpg"), QStringList{"Anna"});
    }

    /// Names as other programs write them: with a mark for the direction of writing, and with two blanks.
    void a_name_with_what_is_not_shown_stays_one_person() {
        const std::string name = "\xD7\x93\xD7\xA0\xD7\x94\xE2\x80\x8F  Levi"; // U+200F
        const QString shown = QString::fromUtf8("\xD7\x93\xD7\xA0\xD7\x94   Levi");
        Bench bench;
        const Rect part = place_of_face(0);
        SidecarChanges changes;
        changes.faces = {{part.centre().x, part.centre().y, part.width(), part.height(), name}};
        QCOMPARE(write_sidecar(bench.photo("a.jpg"), changes), std::string());
        bench.album->touched(bench.photo("a.jpg"));
        bench.care.show();
        QVERIFY(bench.tells({shown + " 3 photograph(s), 2 to confirm", "Who is this? 2 photograph(s)"}));
        bench.care.choose(0);
        QCOMPARE(bench.care.offer(), shown);
        bench.care.confirm();
        QVERIFY(bench.tells({shown + " 3 photograph(s)", "Who is this? 2 photograph(s)"}));
        QCOMPARE(bench.names("c.jpg"), QStringList{QString::fromStdString(name)});
    }

    void who_is_like_somebody_with_a_name_is_offered_it() {
        ShownBench bench;
        bench.care.choose(1);
        QCOMPARE(bench.care.offer(), QString());
        bench.care.confirm(); // there is nobody to confirm
        QVERIFY(bench.rests());
        QCOMPARE(bench.names("a.jpg"), QStringList());
    }

    void a_face_of_somebody_else_goes_and_comes_back() {
        NamedBench bench;
        bench.care.choose(0);
        bench.care.notThisPerson(-1); // none is selected
        bench.care.select(2);
        const fs::path photo = bench.care.faces()->face(2)->photo;
        const std::string name = photo.filename().string();
        QCOMPARE(bench.last_said(), QString("Selected: %1.").arg(QString::fromStdString(name)));
        bench.care.notThisPerson(2);
        CARE_TRY_COMPARE(bench.last_said(), QString("This face is not that of Anna."));
        QVERIFY(bench.tells({"Anna 2 photograph(s)", "Who is this? 2 photograph(s)"}));
        QVERIFY(!bench.names(name).contains("Anna"));
        bench.history.undo();
        CARE_TRY_COMPARE(bench.last_said(), QString("Undone: a face is not that of Anna."));
        QVERIFY(bench.tells(anna_named));
        QVERIFY(bench.names(name).contains("Anna"));
    }

    void a_guess_that_is_wrong_is_put_right_without_a_name() {
        ShownBench bench;
        bench.care.choose(0);
        bench.care.select(1);
        const fs::path selected = bench.care.faces()->face(1)->photo;
        bench.care.notThisPerson(0);
        CARE_TRY_COMPARE(bench.last_said(), QString("This face is somebody else's."));
        QVERIFY(bench.tells({"Who is this? 2 photograph(s)", "Who is this? 2 photograph(s)"}));
        QCOMPARE(bench.care.selected(), 0); // what is selected stays so
        QCOMPARE(bench.care.faces()->face(0)->photo, selected);
        bench.history.undo();
        QVERIFY(bench.tells(nobody_named));
        bench.history.redo();
        QVERIFY(bench.tells({"Who is this? 2 photograph(s)", "Who is this? 2 photograph(s)"}));
        bench.care.select(0);
        bench.care.notThisPerson(0);
        QVERIFY(bench.tells({"Who is this? 2 photograph(s)"}));
        QCOMPARE(bench.care.selected(), -1); // and never becomes another one
    }

    void another_name_renames_the_person_everywhere() {
        ShownBench bench;
        bench.care.choose(0);
        bench.care.nameAll("Ana");
        QVERIFY(bench.tells({"Ana 3 photograph(s)", "Who is this? 2 photograph(s)"}));
        bench.care.choose(0);
        bench.care.nameAll("Anna");
        QVERIFY(bench.tells(anna_named));
        QCOMPARE(bench.record("b.jpg").persons, std::vector<std::string>{"Anna"});
    }

    void a_mark_of_another_program_gets_the_name() {
        Bench bench;
        const Rect part = place_of_face(0);
        SidecarChanges changes;
        changes.faces = {{part.centre().x, part.centre().y, 0.24, 0.26, ""}};
        QCOMPARE(write_sidecar(bench.photo("a.jpg"), changes), std::string());
        bench.show();
        bench.care.choose(0);
        bench.care.nameAll("Anna");
        QVERIFY(bench.tells(anna_named));
        QCOMPARE(bench.record("a.jpg").faces.size(), std::size_t{1});
        QCOMPARE(bench.record("a.jpg").faces[0].width, 0.24);
    }

    void what_cannot_be_written_is_said_and_nothing_is_named() {
        Bench bench;
        fs::create_directory(bench.photo("b.jpg").string() + ".xmp");
        bench.show();
        bench.care.choose(0);
        bench.care.nameAll("Anna");
        CARE_TRY_VERIFY(bench.last_said().contains("b.jpg.xmp"));
        QVERIFY(bench.sounded(Earcon::error));
        QCOMPARE(bench.names("a.jpg"), QStringList());
        QCOMPARE(bench.care.row(), 1); // where a name may be typed already
        bench.care.nameAll("Bert");    // b.jpg is in the way once more
        QCOMPARE(bench.care.row(), 0); // still to be named
        CARE_TRY_VERIFY(bench.rests());
        fs::remove(bench.photo("b.jpg").string() + ".xmp");
        bench.care.nameAll("Anna");
        QVERIFY(bench.tells(anna_named));
    }

    void who_types_on_while_a_name_is_written_names_the_next_one() {
        ShownBench bench;
        bench.care.choose(0);
        bench.care.nameAll("Anna");
        bench.care.nameAll("Bert");
        bench.care.nameAll("Carl"); // nobody is asked for
        QVERIFY(bench.tells({"Anna 3 photograph(s)", "Bert 2 photograph(s)"}));
        QCOMPARE(bench.last_said(),
                 QString("Saved: Bert, on 2 photograph(s). Nobody is left without a name."));
        bench.history.undo();
        QVERIFY(bench.tells(anna_named));
        QCOMPARE(bench.names("b.jpg"), QStringList{"Anna"});
    }

    void a_face_whose_sidecar_cannot_be_written_stays_and_that_is_said_once() {
        NamedBench bench;
        bench.care.choose(0);
        const std::string name = bench.care.faces()->face(1)->photo.filename().string();
        QVERIFY(bench.sounded(Earcon::saved));
        bench.let_nothing_be_written(true);
        const auto said = bench.voice.said().size();
        bench.care.notThisPerson(1);
        CARE_TRY_VERIFY(bench.last_said().contains("could not be written"));
        bench.let_nothing_be_written(false);
        QVERIFY(bench.last_said().contains(QString::fromStdString(name)));
        QVERIFY(bench.sounded(Earcon::error));
        QCOMPARE(bench.voice.said().size(), said + 1);
        QVERIFY(bench.tells(anna_named));
        QCOMPARE(bench.care.faces()->rowCount(), 3);
        QVERIFY(bench.names(name).contains("Anna"));
        QCOMPARE(bench.history.undoText(), QString("3 faces were named Anna")); // nothing else was done
        bench.care.notThisPerson(1);
        CARE_TRY_COMPARE(bench.last_said(), QString("This face is not that of Anna."));
        QVERIFY(bench.tells({"Anna 2 photograph(s)", "Who is this? 2 photograph(s)"}));
        bench.history.undo();
        QVERIFY(bench.tells(anna_named));
        QVERIFY(bench.names(name).contains("Anna"));
    }

    void a_photograph_that_is_not_there_keeps_nobody_from_a_name() {
        ShownBench bench;
        bench.care.choose(0);
        fs::remove(bench.photo("b.jpg")); // a stick was pulled out; the list does not know yet
        bench.care.nameAll("Anna");
        CARE_TRY_VERIFY(bench.names("a.jpg") == QStringList{"Anna"});
        QVERIFY(bench.rests());
        QCOMPARE(bench.names("c.jpg"), QStringList{"Anna"});
        QVERIFY(!fs::exists(bench.photo("b.jpg").string() + ".xmp"));
    }

    void back_goes_from_the_person_to_the_list_and_to_the_photographs() {
        Bench bench;
        QVERIFY(!bench.care.back());
        bench.show();
        bench.care.choose(1);
        QVERIFY(bench.care.back());
        QCOMPARE(bench.care.row(), -1);
        QVERIFY(bench.care.back());
        QVERIFY(!bench.care.shown());
        QVERIFY(!bench.care.back());
    }

    void a_face_leads_to_its_photograph() {
        ShownBench bench;
        QSignalSpy asked(&bench.care, &GroupCare::photoAsked);
        bench.care.choose(0);
        bench.care.openPhoto(); // none is selected
        QCOMPARE(asked.size(), 0);
        bench.care.select(0);
        const fs::path photo = bench.care.faces()->face(0)->photo;
        bench.care.openPhoto();
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].value<fs::path>(), photo);
        QVERIFY(!bench.care.shown());
    }
};

} // namespace group_care_test

TP_TEST(group_care_test, GroupCareTest, window)
#include "group_care_test.moc"
