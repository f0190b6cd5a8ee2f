// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/write_sidecar.hpp"
#include "app/pages/care/care_people.hpp"
#include "care_bench.hpp"
#include "test_program.hpp"

#include <QStringList>

namespace care_people_test {

using namespace tp;

namespace {

struct Bench : CareGround {
    CarePeople people{*album};
    using CareGround::CareGround;

    void write(const std::string& name, const SidecarChanges& changes) {
        QCOMPARE(write_sidecar(photo(name), changes), std::string());
        album->touched(photo(name));
    }
};

SidecarChanges showing(std::vector<std::string> persons) {
    SidecarChanges changes;
    changes.persons = std::move(persons);
    return changes;
}

} // namespace

class CarePeopleTest : public QObject {
    Q_OBJECT
private slots:
    void nobody_is_known_to_an_album_without_names() {
        Bench bench;
        QCOMPARE(bench.people.known(""), QStringList());
        QCOMPARE(bench.people.known("a"), QStringList());
    }
    void all_are_offered_where_nothing_was_typed_else_the_commonest_first() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.write("a.jpg", showing({"Anna", "Tobias", "Tom"}));
        bench.write("b.jpg", showing({"Tom"}));
        CARE_TRY_COMPARE(bench.people.known(" "), QStringList({"Anna", "Tobias", "Tom"}));
        CARE_TRY_COMPARE(bench.people.known("to"), QStringList({"Tom", "Tobias"}));
    }
    void who_may_be_meant_is_a_person_and_no_keyword() {
        Bench bench;
        SidecarChanges changes = showing({"Anna", "Tom"});
        changes.keywords = std::vector<std::string>{"Tomatoes"};
        bench.write("a.jpg", changes);
        CARE_TRY_COMPARE(bench.people.known("to"), QStringList{"Tom"});
        QCOMPARE(bench.people.known("x"), QStringList());
    }
    void no_more_are_offered_than_one_can_go_through() {
        Bench bench;
        std::vector<std::string> many;
        for (int i = 0; i < 2 * CarePeople::most_offered; ++i)
            many.push_back("Maria " + std::to_string(i));
        bench.write("a.jpg", showing(many));
        CARE_TRY_COMPARE(bench.people.known("").size(), qsizetype{CarePeople::most_offered});
        QCOMPARE(bench.people.known("mar").size(), qsizetype{CarePeople::most_offered});
    }
};

} // namespace care_people_test

TP_TEST(care_people_test, CarePeopleTest, window)
#include "care_people_test.moc"
