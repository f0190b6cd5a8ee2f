// SPDX-License-Identifier: Apache-2.0
#include "drawn_people.hpp"
#include "faces/identity/face_groups.hpp"
#include "faces/identity/same_person.hpp"

#include <QTest>

#include <cmath>
#include <limits>

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
    void moments_at_both_ends_of_time() {
        drawn::People people(7);
        FaceGroups groups;
        groups.add({said(
            at(drawn::face(1, 1, people.picture_of(0)), std::numeric_limits<std::int64_t>::min()), "Anna")});
        groups.add({at(drawn::face(2, 2, people.picture_of(0)), std::numeric_limits<std::int64_t>::max())});
        QCOMPARE(groups.offers(2).size(), std::size_t{1});
    }
};

QTEST_GUILESS_MAIN(NameOffersTest)
#include "name_offers_test.moc"
