// SPDX-License-Identifier: Apache-2.0
#include "app/album/grouping/people.hpp"

#include <QTest>

#include <string>
#include <vector>

using namespace tp;

namespace {

/// A face `id` on photograph `photo`.jpg.
PlacedFace on(std::int64_t id, const std::string& photo) {
    PlacedFace face;
    face.id = id;
    face.photo = "/album/" + photo + ".jpg";
    return face;
}

bool nobody_has(FaceId) { return false; }
bool everybody_has(FaceId) { return true; }

} // namespace

class PeopleTest : public QObject {
    Q_OBJECT
private slots:
    void those_without_an_answer_come_first_and_the_largest_of_them() {
        const People people = people_of(
            {{1, "Anna", {1, 2, 3}}, {2, "", {4, 5}}, {3, "", {6, 7, 8}}},
            {on(1, "a"), on(2, "b"), on(3, "c"), on(4, "d"), on(5, "e"), on(6, "a"), on(7, "b"), on(8, "c")},
            [](FaceId face) { return face <= 3; });
        QCOMPARE(people.persons.size(), std::size_t(3));
        QCOMPARE(people.persons[0].groups, std::vector<GroupId>{3});
        QCOMPARE(people.persons[1].groups, std::vector<GroupId>{2});
        QCOMPARE(people.persons[2].name, std::string("Anna"));
        QCOMPARE(people.persons[2].to_confirm, std::size_t(0));
        QCOMPARE(people.persons[0].to_confirm, std::size_t(3));
    }

    void groups_of_one_name_are_one_person() {
        const People people =
            people_of({{1, "Anna", {1, 2}}, {5, "Anna", {3}}, {7, "", {4, 5}}, {8, "", {6, 7}}},
                      {on(3, "z"), on(1, "a"), on(2, "b"), on(4, "c"), on(5, "d"), on(6, "e"), on(7, "f")},
                      everybody_has);
        QCOMPARE(people.persons.size(), std::size_t(3)); // the unnamed ones are two
        QCOMPARE(people.persons[0].groups, (std::vector<GroupId>{1, 5}));
        QCOMPARE(people.persons[0].faces.size(), std::size_t(3));
        QCOMPARE(people.persons[0].faces[0].id, FaceId(3)); // as they were given: the newest first
        QCOMPARE(people.persons[0].faces[0].group, GroupId(5));
    }

    void who_is_seen_on_one_photograph_only_is_counted_alone() {
        const People people = people_of({{1, "", {1}}, {2, "", {2, 3}}, {3, "Bert", {4}}},
                                        {on(1, "a"), on(2, "b"), on(3, "b"), on(4, "c")}, nobody_has);
        QCOMPARE(people.alone, std::size_t(3)); // the two of one photograph too: a mirror, say
        QCOMPARE(people.persons.size(), std::size_t(1));
        QCOMPARE(people.persons[0].name, std::string("Bert"));
    }

    void two_files_with_the_same_bytes_are_two_photographs() {
        const People people = people_of({{1, "", {1}}}, {on(1, "a"), on(1, "copy")}, nobody_has);
        QCOMPARE(people.persons.size(), std::size_t(1));
        QCOMPARE(people.persons[0].photos, std::size_t(2));
    }

    void whose_photographs_are_all_missing_is_not_there() {
        const People people = people_of({{1, "Anna", {1, 2}}, {2, "", {3, 4}}}, {}, nobody_has);
        QVERIFY(people.persons.empty());
        QCOMPARE(people.alone, std::size_t(0));
    }
};

QTEST_GUILESS_MAIN(PeopleTest)
#include "people_test.moc"
