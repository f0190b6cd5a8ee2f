// SPDX-License-Identifier: Apache-2.0
#include "drawn_people.hpp"
#include "faces/identity/near_groups.hpp"
#include "faces/identity/same_person.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <map>

namespace near_groups_test {

using namespace tp;

namespace {

using Faces = std::vector<FaceDescriptor>;

GroupSum sum_of(const Faces& faces) {
    GroupSum sum;
    for (const FaceDescriptor& face : faces)
        sum.add(face);
    return sum;
}

/// As it is defined: pair by pair.
double mean_squared(const Faces& a, const Faces& b) {
    double sum = 0.0;
    for (const FaceDescriptor& one : a)
        for (const FaceDescriptor& other : b)
            sum += squared_distance(one, other);
    return sum / static_cast<double>(a.size() * b.size());
}

Faces some(drawn::People& people, std::size_t who, std::size_t count) {
    Faces faces;
    for (std::size_t i = 0; i < count; ++i)
        faces.push_back(people.picture_of(who, 3.0));
    return faces;
}

} // namespace

class NearGroupsTest : public QObject {
    Q_OBJECT

private slots:
    void sums_say_what_all_pairs_say() {
        drawn::People people(1);
        for (int round = 0; round < 20; ++round) {
            const Faces a = some(people, 0, 1 + people.below(9)), b = some(people, 1, 1 + people.below(30));
            QCOMPARE(sum_of(b).mean_squared(a[0]), mean_squared({a[0]}, b));
            const double both = sum_of(a).mean_squared(sum_of(b));
            QVERIFY(std::abs(both - mean_squared(a, b)) < 1e-6);
            GroupSum joined = sum_of(a);
            joined.add(sum_of(b));
            for (const FaceDescriptor& face : a)
                joined.take(face);
            QCOMPARE(joined.count(), std::int64_t(b.size()));
            QCOMPARE(joined.mean_squared(a[0]), mean_squared({a[0]}, b));
        }
    }
    void the_order_of_a_sum_does_not_count() {
        drawn::People people(2);
        Faces faces = some(people, 0, 500);
        const FaceDescriptor other = people.picture_of(1);
        const double before = sum_of(faces).mean_squared(other);
        std::ranges::shuffle(faces, people.random());
        QCOMPARE(sum_of(faces).mean_squared(other), before);
    }
    /// Whatever has come and gone, no near group is missed, and none that is clearly far is said to be near.
    void all_near_groups_are_found() {
        drawn::People people(3);
        NearGroups near;
        std::map<GroupId, Faces> known;
        const double most = squared_steps(0.5);
        for (int round = 0; round < 2000; ++round) {
            const auto id = static_cast<GroupId>(people.below(60));
            if (people.below(3) == 0) {
                near.erase(id);
                known.erase(id);
            } else {
                Faces& faces = known[id];
                faces.push_back(people.picture_of(static_cast<std::size_t>(id % 20), 2.0));
                near.set(id, sum_of(faces));
            }
            const FaceDescriptor face = people.picture_of(people.below(20), 2.0);
            std::vector<GroupId> found = near.within(face, most);
            std::ranges::sort(found);
            for (const auto& [group, faces] : known) {
                const double squared = mean_squared({face}, faces);
                const bool is_found = std::ranges::binary_search(found, group);
                QVERIFY(squared > most || is_found);
                QVERIFY(squared < 1.01 * most || !is_found);
            }
        }
    }
    void without_groups_nothing_is_near() { QVERIFY(NearGroups().within(FaceDescriptor{}, 1e9).empty()); }
};

} // namespace near_groups_test

TP_TEST(near_groups_test, NearGroupsTest, event_loop)
#include "near_groups_test.moc"
