// SPDX-License-Identifier: Apache-2.0
#include "drawn_people.hpp"
#include "faces/identity/face_groups.hpp"
#include "faces/identity/same_person.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace name_offers_test {

using namespace tp;

namespace {

constexpr std::int64_t year_ms = 31'557'600'000;

/// A face that is known by a name.
ComingFace said(ComingFace face, const char* name) {
    face.said = name;
    return face;
}

ComingFace at(ComingFace face, std::int64_t moment_ms) {
    face.moment_ms = moment_ms;
    return face;
}

/// `share` of the way from one descriptor to another.
FaceDescriptor between(const FaceDescriptor& from, const FaceDescriptor& to, double share) {
    FaceDescriptor there = from;
    for (std::size_t i = 0; i < descriptor_length; ++i)
        there[i] = static_cast<std::int8_t>(std::lround((1.0 - share) * from[i] + share * to[i]));
    return there;
}

} // namespace

class NameOffersTest : public QObject {
    Q_OBJECT

private slots:
    void a_known_face_is_offered_by_name() {
        drawn::People people(1);
        FaceGroups groups;
        groups.add({said(drawn::face(1, 1, people.picture_of(0)), "Anna")});
        groups.add({said(drawn::face(2, 2, people.picture_of(1)), "Ben")});
        groups.add({drawn::face(3, 3, people.picture_of(0))});
        const auto offers = groups.offers(3);
        QCOMPARE(offers.size(), std::size_t{1});
        QCOMPARE(offers[0].name, std::string("Anna"));
        QVERIFY(offers[0].sure && offers[0].distance < same_person);
    }
    void a_stranger_and_an_unknown_face_are_offered_nothing() {
        drawn::People people(2);
        FaceGroups groups;
        groups.add({said(drawn::face(1, 1, people.picture_of(0)), "Anna")});
        groups.add({drawn::face(2, 2, people.picture_of(1))});
        QVERIFY(groups.offers(2).empty());
        QVERIFY(groups.offers(99).empty());
        QVERIFY(groups.offers(1).empty()); // alone with its name
    }
    void two_who_look_alike_are_both_offered_and_neither_is_sure() {
        drawn::People people(3);
        const FaceDescriptor anna = people.picture_of(0, 0.0),
                             sister = between(anna, people.picture_of(1, 0.0), 0.5);
        FaceGroups groups;
        groups.add({said(drawn::face(1, 1, anna), "Anna")});
        groups.add({said(drawn::face(2, 2, sister), "Clara")});
        groups.add({drawn::face(3, 3, between(anna, sister, 0.45))});
        const auto offers = groups.offers(3);
        QCOMPARE(offers.size(), std::size_t{2});
        QCOMPARE(offers[0].name, std::string("Anna"));
        QVERIFY(!offers[0].sure && !offers[1].sure && offers[0].distance < offers[1].distance);
        QCOMPARE(groups.offers(3, 1).size(), std::size_t{1});
        QVERIFY(groups.offers(3, 0).empty());
    }
    void who_was_ruled_out_is_not_offered_again_under_the_same_name() {
        drawn::People people(4);
        FaceGroups groups;
        groups.add({said(drawn::face(1, 1, people.picture_of(0)), "Anna")});
        groups.add({drawn::face(2, 2, people.picture_of(0))});
        QCOMPARE(groups.group_of(2), groups.group_of(1));
        QVERIFY(groups.take_out(2));
        groups.add({said(drawn::face(3, 3, people.picture_of(0, 0.0)), "Anna")});
        QVERIFY(groups.offers(2).empty());
        QVERIFY(groups.group_of(2) != groups.group_of(3));
    }
    void the_name_of_another_face_in_the_photograph_is_not_offered() {
        drawn::People people(5);
        const FaceDescriptor anna = people.picture_of(0, 0.0),
                             twin = between(anna, people.picture_of(1), 0.2);
        FaceGroups groups;
        groups.add({said(drawn::face(1, 1, anna), "Anna")});
        groups.add({drawn::face(2, 2, anna), drawn::face(3, 2, twin)});
        QCOMPARE(groups.group_of(2), groups.group_of(1));
        QVERIFY(groups.offers(3).empty());
    }
    /// A child of two and of ten, each with a name; one of nine is nearer to ten in time, though its looks lie midway.
    void children_are_compared_with_themselves_at_that_age() {
        drawn::People people(6);
        const FaceDescriptor young = people.picture_of(0, 0.0),
                             old = between(young, people.picture_of(1, 0.0), 0.6);
        FaceGroups groups;
        FaceId id = 0;
        for (int i = 0; i < 20; ++i) {
            ++id;
            groups.add({said(at(drawn::face(id, id, people.picture_of(0, 0.3)), 2 * year_ms + i), "Anna")});
        }
        for (int i = 0; i < 8; ++i) {
            ++id;
            groups.add({said(at(drawn::face(id, id, old), 10 * year_ms + i), "Anna")});
        }
        const auto merged = groups.merge(*groups.group_of(1), *groups.group_of(id));
        QVERIFY(merged);
        groups.add({at(drawn::face(100, 100, old), 9 * year_ms)});
        groups.add({drawn::face(101, 101, old)}); // of no known time: all ages count
        QVERIFY(groups.offers(100).at(0).distance < 0.05);
        QVERIFY(groups.offers(100).at(0).sure);
        const auto unknown_time = groups.offers(101);
        QVERIFY(unknown_time.empty() || unknown_time[0].distance > 0.3);
    }
    void who_is_surely_known_of_those_with_a_name_is_who_is_surely_offered() {
        int sure = 0;
        for (std::uint32_t seed = 10; seed < 60; ++seed) {
            drawn::People people(seed);
            FaceGroups groups;
            FaceId next = 1;
            for (std::size_t who = 0; who < 4; ++who)
                for (int picture = 0; picture < 12; ++picture, ++next)
                    groups.add({at(said(drawn::face(next, next, people.picture_of(who, 0.4 + 0.12 * picture)),
                                        who < 2   ? "Anna"
                                        : who < 3 ? "Ben"
                                                  : ""),
                                   year_ms * picture)});
            const FaceDescriptor today = people.picture_of(people.below(6), 1.3);
            const std::string known = sure_name(groups.named(), today);
            groups.add({at(drawn::face(next, next, today), 100 * year_ms)});
            const auto group = groups.group_of(next);
            const auto offers = groups.offers(next);
            const std::string offered = !offers.empty() && offers[0].sure ? offers[0].name : "";
            QVERIFY(group);
            QCOMPARE(known, offered);
            sure += known.empty() ? 0 : 1;
        }
        QVERIFY2(sure > 10 && sure < 45, qPrintable(QString::number(sure)));
    }
    void of_two_who_look_alike_nobody_is_surely_known() {
        drawn::People people(3);
        const FaceDescriptor anna = people.picture_of(0, 0.0),
                             sister = between(anna, people.picture_of(1, 0.0), 0.5);
        QCOMPARE(sure_name({{"Anna", {anna}}, {"Clara", {sister}}}, between(anna, sister, 0.45)),
                 std::string());
        QCOMPARE(sure_name({{"Anna", {anna}}, {"Clara", {sister}}}, between(anna, sister, 0.05)),
                 std::string("Anna"));
        QCOMPARE(sure_name({{"Anna", {anna}}, {"Anna", {sister}}}, between(anna, sister, 0.45)),
                 std::string("Anna"));
    }
    void the_newest_faces_of_each_named_group_are_told() {
        drawn::People people(7);
        FaceGroups groups;
        std::vector<FaceDescriptor> anna;
        for (FaceId i = 0; i < 12; ++i) {
            anna.push_back(people.picture_of(0));
            groups.add({at(said(drawn::face(i + 1, i + 1, anna.back()), "Anna"), year_ms * i)});
        }
        groups.add({said(drawn::face(20, 20, people.picture_of(1)), "Ben")}); // when, nobody knows
        groups.add({drawn::face(21, 21, people.picture_of(2))});
        std::vector<NamedFaces> named = groups.named();
        std::ranges::sort(named, {}, &NamedFaces::name);
        QCOMPARE(named.size(), std::size_t{2});
        QCOMPARE(named[0].newest, std::vector(anna.rbegin(), anna.rbegin() + 8));
        QCOMPARE(named[1].newest.size(), std::size_t{1});
        QVERIFY(sure_name({}, anna[0]).empty());
    }
    void moments_at_both_ends_of_time() {
        drawn::People people(7);
        FaceGroups groups;
        groups.add({said(
            at(drawn::face(1, 1, people.picture_of(0)), std::numeric_limits<std::int64_t>::min()), "Anna")});
        groups.add({at(drawn::face(2, 2, people.picture_of(0)), std::numeric_limits<std::int64_t>::max())});
        QCOMPARE(groups.offers(2).size(), std::size_t{1});
    }
};

} // namespace name_offers_test

TP_TEST(name_offers_test, NameOffersTest, event_loop)
#include "name_offers_test.moc"
