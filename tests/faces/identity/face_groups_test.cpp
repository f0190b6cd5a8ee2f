// SPDX-License-Identifier: Apache-2.0
#include "drawn_people.hpp"
#include "effort.hpp"
#include "faces/identity/face_groups.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace face_groups_test {

using namespace tp;
using test::tried_of;

namespace {

/// Which faces are together, whatever the numbers of groups.
using Partition = std::set<std::vector<FaceId>>;

Partition partition_of(const FaceGroups& groups) {
    Partition partition;
    for (const FaceGroup& group : groups.groups())
        partition.insert(group.faces);
    return partition;
}

using Photo = std::vector<ComingFace>;

/// Photographs with one to three faces of `people`, `times` as different from picture to picture as usual.
std::vector<Photo> album(drawn::People& people, std::size_t count, std::size_t photos, double times) {
    std::vector<Photo> album;
    FaceId id = 0;
    for (std::size_t p = 1; p <= photos; ++p) {
        std::set<std::size_t> shown;
        const std::size_t faces = 1 + people.below(3);
        while (shown.size() < faces)
            shown.insert(people.below(count));
        Photo photo;
        for (const std::size_t who : shown)
            photo.push_back(drawn::face(++id, static_cast<PhotoId>(p), people.picture_of(who, times)));
        album.push_back(photo);
    }
    return album;
}

FaceGroups grouped(const std::vector<Photo>& album) {
    FaceGroups groups;
    for (const Photo& photo : album)
        groups.add(photo);
    return groups;
}

FaceId some_face(drawn::People& people, const FaceGroups& groups) {
    const GroupsState state = groups.state();
    return state.faces[people.below(state.faces.size())].id;
}

GroupId some_group(drawn::People& people, const FaceGroups& groups) {
    const GroupsState state = groups.state();
    return state.groups[people.below(state.groups.size())].id;
}

/// Something that a person may say.
std::optional<GroupsChange> said_at_random(drawn::People& people, FaceGroups& groups) {
    switch (people.below(3)) {
    case 0:
        return groups.name(some_group(people, groups),
                           std::string(1, static_cast<char>('A' + people.below(4))));
    case 1:
        return groups.take_out(some_face(people, groups));
    default:
        return groups.merge(some_group(people, groups), some_group(people, groups));
    }
}

/// In each group at most one face of a photograph.
bool photos_are_apart(const FaceGroups& groups) {
    const GroupsState state = groups.state();
    std::map<FaceId, PhotoId> photo_of;
    for (const KnownFace& face : state.faces)
        photo_of[face.id] = face.photo;
    return std::ranges::all_of(state.groups, [&](const FaceGroup& group) {
        std::set<PhotoId> photos;
        return std::ranges::all_of(group.faces,
                                   [&](FaceId face) { return photos.insert(photo_of[face]).second; });
    });
}

} // namespace

class FaceGroupsTest : public QObject {
    Q_OBJECT

private slots:
    void nobody() {
        FaceGroups groups;
        QVERIFY(groups.add({}));
        QCOMPARE(groups.face_count(), std::size_t{0});
        QVERIFY(groups.groups().empty() && groups.offers(1).empty());
        QVERIFY(!groups.group_of(1) && !groups.group(1));
        QVERIFY(!groups.name(1, "Anna") && !groups.take_out(1) && !groups.merge(1, 2));
        groups.remove(1);
    }
    void one_face_is_a_group() {
        drawn::People people(1);
        FaceGroups groups;
        QVERIFY(groups.add({drawn::face(7, 1, people.picture_of(0))}));
        QCOMPARE(groups.groups().size(), std::size_t{1});
        QCOMPARE(groups.groups()[0].faces, std::vector<FaceId>{7});
        groups.remove(7);
        QVERIFY(groups.groups().empty());
        QVERIFY(groups.add({drawn::face(7, 1, people.picture_of(0))}));
    }
    void the_same_face_again_is_refused() {
        drawn::People people(2);
        FaceGroups groups;
        const ComingFace face = drawn::face(1, 1, people.picture_of(0));
        QVERIFY(groups.add({face}));
        const GroupsState before = groups.state();
        QVERIFY(!groups.add({drawn::face(2, 1, people.picture_of(1)), face}));
        QVERIFY(
            !groups.add({drawn::face(3, 2, people.picture_of(1)), drawn::face(3, 2, people.picture_of(2))}));
        QVERIFY(
            !groups.add({drawn::face(4, 2, people.picture_of(1)), drawn::face(5, 3, people.picture_of(2))}));
        QVERIFY(groups.state() == before);
    }
    /// A copy of a photograph: its faces are the same to the bit.
    void duplicates_are_together() {
        drawn::People people(3);
        FaceGroups groups;
        const FaceDescriptor face = people.picture_of(0);
        for (FaceId id = 1; id <= 50; ++id)
            groups.add({drawn::face(id, id, face)});
        QCOMPARE(groups.groups().size(), std::size_t{1});
        groups.add({drawn::face(51, 51, face), drawn::face(52, 51, face)}); // a mirror in the picture
        QCOMPARE(groups.groups().size(), std::size_t{2});
        QVERIFY(photos_are_apart(groups));
    }

    void people_are_told_apart_whatever_the_order() {
        drawn::People people(4);
        std::vector<Photo> photos = album(people, 12, 120, 1.0);
        const Partition first = partition_of(grouped(photos));
        QCOMPARE(first.size(), std::size_t{12});
        for (std::size_t round = 0; round < tried_of(10); ++round) {
            std::ranges::shuffle(photos, people.random());
            for (Photo& photo : photos)
                std::ranges::shuffle(photo, people.random());
            QVERIFY(partition_of(grouped(photos)) == first);
        }
    }
    /// Faces that are hard to tell apart: what counts is how they look and which photograph they are in, and the order
    /// of the photographs; neither the order of faces in one nor any number, nor the moment.
    void nothing_else_decides() {
        drawn::People people(5);
        for (std::size_t round = 0; round < tried_of(10); ++round) {
            std::vector<Photo> photos = album(people, 8, 80, 1.7);
            const FaceGroups first = grouped(photos);
            const Partition partition = partition_of(first);
            for (Photo& photo : photos) {
                std::ranges::shuffle(photo, people.random());
                for (ComingFace& face : photo) {
                    face.moment_ms = static_cast<std::int64_t>(people.below(1'000'000));
                    face.photo = -17 * face.photo;
                }
            }
            QVERIFY(partition_of(grouped(photos)) == partition);
            for (Photo& photo : photos)
                for (ComingFace& face : photo)
                    face.id = -face.id;
            Partition negated;
            for (std::vector<FaceId> faces : partition) {
                std::ranges::transform(faces, faces.begin(), std::negate());
                std::ranges::sort(faces);
                negated.insert(faces);
            }
            QVERIFY(partition_of(grouped(photos)) == negated);
        }
    }
    void twice_the_same_gives_twice_the_same() {
        drawn::People one(6), other(6);
        QVERIFY(grouped(album(one, 9, 90, 1.7)).state() == grouped(album(other, 9, 90, 1.7)).state());
    }
    /// A face between two groups of one person that came before it shows that they are one.
    void a_face_between_two_groups_joins_them() {
        FaceGroups groups;
        FaceDescriptor a{}, b{}, between{};
        a[0] = 40; // 0.41 from b
        b[1] = 34;
        between[0] = 20;
        between[1] = 17;
        QVERIFY(distance(a, b) > 0.39 && distance(a, between) < 0.25);
        groups.add({drawn::face(1, 1, a)});
        groups.add({drawn::face(2, 2, b)});
        QCOMPARE(groups.groups().size(), std::size_t{2});
        groups.add({drawn::face(3, 3, between)});
        QCOMPARE(groups.groups().size(), std::size_t{1});
        FaceGroups held;
        held.add({drawn::face(1, 1, a)});
        held.add({drawn::face(2, 2, b)});
        held.name(1, "Anna");
        held.name(2, "Ben");
        held.add({drawn::face(3, 3, between)});
        QCOMPARE(held.groups().size(), std::size_t{2});
    }

    void names_that_came_with_faces_are_kept_apart() {
        drawn::People people(7);
        const FaceDescriptor looks = people.picture_of(0);
        FaceGroups groups;
        ComingFace anna = drawn::face(1, 1, looks), twin = drawn::face(2, 2, looks),
                   unknown = drawn::face(3, 3, looks);
        anna.said = "Anna";
        twin.said = "Clara";
        groups.add({unknown});
        groups.add({anna}); // names the group of the unknown one
        groups.add({twin});
        QCOMPARE(groups.group_of(1), groups.group_of(3));
        QVERIFY(groups.group_of(2) != groups.group_of(1));
        QCOMPARE(groups.group(*groups.group_of(3))->name, std::string("Anna"));
        QCOMPARE(groups.group(*groups.group_of(2))->name, std::string("Clara"));
    }
    void not_this_person_holds_for_ever() {
        drawn::People people(8);
        FaceGroups groups;
        for (FaceId id = 1; id <= 10; ++id)
            groups.add({drawn::face(id, id, people.picture_of(0))});
        const GroupId group = *groups.group_of(1);
        QVERIFY(groups.take_out(4));
        for (FaceId id = 11; id <= 200; ++id) {
            groups.add({drawn::face(id, id, people.picture_of(0))});
            QVERIFY(groups.group_of(4) != groups.group_of(1));
        }
        QCOMPARE(groups.group_of(1), std::optional(group));
        QVERIFY(groups.merge(group, *groups.group_of(4))); // but a person may think again
        QCOMPARE(groups.group_of(4), std::optional(group));
        QVERIFY(groups.state().not_there.empty());
    }
    void merging_says_that_two_faces_of_a_photograph_are_one_person() {
        drawn::People people(9);
        FaceGroups groups;
        groups.add({drawn::face(1, 1, people.picture_of(0)), drawn::face(2, 1, people.picture_of(0))});
        groups.name(*groups.group_of(2), "Anna");
        const auto change = groups.merge(*groups.group_of(1), *groups.group_of(2));
        QVERIFY(change && !groups.merge(*groups.group_of(1), *groups.group_of(1)));
        QCOMPARE(groups.group_of(1), groups.group_of(2));
        QCOMPARE(groups.group(*groups.group_of(1))->name, std::string("Anna"));
        QVERIFY(groups.undo(*change));
        QVERIFY(photos_are_apart(groups));
    }
    /// Whatever people say and whatever comes and goes: no photograph's faces are together, no taken out face is with
    /// those from whom it was taken, and the state holds together.
    void what_people_said_always_holds() {
        drawn::People people(10);
        for (std::size_t round = 0; round < tried_of(20); ++round) {
            FaceGroups groups;
            std::map<FaceId, std::set<FaceId>> apart;
            FaceId id = 0;
            for (PhotoId photo = 1; photo <= 150; ++photo) {
                Photo faces;
                for (std::size_t i = 0; i < 1 + people.below(3); ++i)
                    faces.push_back(drawn::face(++id, photo, people.picture_of(people.below(5), 1.8)));
                QVERIFY(groups.add(faces));
                if (people.below(4) == 0) {
                    const FaceId face = some_face(people, groups);
                    const std::vector<FaceId> together = groups.group(*groups.group_of(face))->faces;
                    for (const FaceId other : together)
                        if (other != face)
                            apart[face].insert(other);
                    for (auto& [other, those] : apart) // the others may find together with it again elsewhere
                        if (other != face)
                            those.erase(face);
                    QVERIFY(groups.take_out(face));
                }
                if (people.below(6) == 0)
                    groups.name(some_group(people, groups), people.below(2) == 0 ? "Anna" : "Ben");
                if (people.below(8) == 0) {
                    const FaceId face = some_face(people, groups);
                    groups.remove(face);
                    apart.erase(face);
                }
                QVERIFY(photos_are_apart(groups));
                for (const auto& [face, those] : apart)
                    for (const FaceId other : those)
                        if (groups.group_of(face) && groups.group_of(other))
                            QVERIFY(groups.group_of(face) != groups.group_of(other));
                const auto again = FaceGroups::from(groups.state());
                QVERIFY(again && again->state() == groups.state());
            }
        }
    }
    void undo_restores_exactly() {
        drawn::People people(11);
        for (std::size_t round = 0; round < tried_of(60); ++round) {
            FaceGroups groups = grouped(album(people, 6, 25, 1.6));
            std::vector<std::pair<GroupsState, GroupsChange>> done;
            for (int step = 0; step < 12; ++step) {
                const GroupsState before = groups.state();
                if (const auto change = said_at_random(people, groups))
                    done.emplace_back(before, *change);
            }
            for (; !done.empty(); done.pop_back()) {
                QVERIFY(groups.undo(done.back().second));
                GroupsState now = groups.state();
                now.last_group = done.back().first.last_group; // numbers are not given again
                QVERIFY(now == done.back().first);
            }
        }
    }
    void undo_leaves_what_came_since_where_it_is() {
        drawn::People people(12);
        FaceGroups groups;
        groups.add({drawn::face(1, 1, people.picture_of(0))});
        groups.add({drawn::face(2, 2, people.picture_of(1))});
        const GroupId first = *groups.group_of(1), second = *groups.group_of(2);
        const auto merged = groups.merge(first, second);
        groups.add({drawn::face(3, 3, people.picture_of(2))});
        groups.remove(1);
        QVERIFY(!groups.undo(*groups.name(first, "Anna")) || groups.group(first)->name.empty());
        QVERIFY(!groups.undo(*merged) || groups.group_of(2) == std::optional(second));
        QVERIFY(groups.group_of(3) && !groups.group_of(1));
    }
    void what_has_changed_since_is_not_undone() {
        drawn::People people(13);
        FaceGroups groups;
        for (FaceId id = 1; id <= 6; ++id)
            groups.add({drawn::face(id, id, people.picture_of(id % 2 == 0))});
        const GroupId even = *groups.group_of(2), odd = *groups.group_of(1);
        const auto named = groups.name(even, "Anna");
        groups.name(even, "Clara");
        QVERIFY(!groups.undo(*named));
        const auto out = groups.take_out(2);
        groups.merge(odd, *groups.group_of(2));
        const GroupsState before = groups.state();
        QVERIFY(!groups.undo(*out));
        QVERIFY(groups.state() == before);
    }
    /// A face of the same photograph that took the place of the one taken out keeps it.
    void undo_never_puts_two_faces_of_a_photograph_together() {
        drawn::People people(14);
        FaceGroups groups;
        groups.add({drawn::face(1, 1, people.picture_of(0))});
        groups.add({drawn::face(2, 2, people.picture_of(0))});
        const auto out = groups.take_out(2);
        groups.add({drawn::face(3, 2, people.picture_of(0, 0.0))});
        QCOMPARE(groups.group_of(3), groups.group_of(1));
        QVERIFY(!groups.undo(*out));
        QVERIFY(photos_are_apart(groups));
    }

    void kept_and_begun_again_it_goes_on_alike() {
        drawn::People people(15);
        const std::vector<Photo> photos = album(people, 7, 100, 1.6);
        FaceGroups live;
        for (std::size_t p = 0; p < 50; ++p) {
            live.add(photos[p]);
            if (p % 5 == 0)
                said_at_random(people, live);
        }
        std::optional<FaceGroups> again = FaceGroups::from(live.state());
        QVERIFY(again);
        for (std::size_t p = 50; p < photos.size(); ++p) {
            live.add(photos[p]);
            again->add(photos[p]);
        }
        QVERIFY(live.state() == again->state());
    }
    void a_state_that_contradicts_itself_is_refused() {
        drawn::People people(16);
        FaceGroups groups;
        groups.add({drawn::face(1, 1, people.picture_of(0)), drawn::face(2, 1, people.picture_of(1))});
        const GroupsState good = groups.state();
        QVERIFY(FaceGroups::from(good) && FaceGroups::from({}));
        const auto refused = [&](auto spoil) {
            GroupsState state = good;
            spoil(state);
            return !FaceGroups::from(state);
        };
        QVERIFY(refused([](GroupsState& s) { s.faces.push_back(s.faces[0]); }));
        QVERIFY(refused([](GroupsState& s) { s.groups.pop_back(); }));
        QVERIFY(refused([](GroupsState& s) { s.groups.push_back(s.groups[0]); }));
        QVERIFY(refused([](GroupsState& s) { s.groups[0].faces.push_back(s.groups[1].faces[0]); }));
        QVERIFY(refused([](GroupsState& s) { s.groups[0].faces.push_back(99); }));
        QVERIFY(refused([](GroupsState& s) { s.groups.push_back({99, "", {}}); }));
        QVERIFY(refused([](GroupsState& s) { s.groups[0].id = 0; }));
        QVERIFY(refused([](GroupsState& s) { s.not_there.emplace(99, s.groups[0].id); }));
        QVERIFY(refused([](GroupsState& s) { s.not_there.emplace(s.groups[0].faces[0], s.groups[0].id); }));
    }
    void largest_groups_come_first() {
        drawn::People people(17);
        FaceGroups groups;
        for (FaceId id = 1; id <= 6; ++id)
            groups.add({drawn::face(id, id, people.picture_of(id == 1 ? 0 : id == 2 ? 1 : 2))});
        const auto all = groups.groups();
        QCOMPARE(all.size(), std::size_t{3});
        QCOMPARE(all[0].faces.size(), std::size_t{4});
        QVERIFY(all[1].faces == std::vector<FaceId>{1} && all[2].faces == std::vector<FaceId>{2});
    }
    /// Ten thousand photographs of two hundred people and of strangers.
    void twenty_thousand_faces() {
        drawn::People people(18);
        FaceGroups groups;
        std::map<FaceId, std::size_t> who;
        FaceId id = 0;
        const auto photos = static_cast<PhotoId>(tried_of(10'000));
        for (PhotoId photo = 1; photo <= photos; ++photo) {
            const std::size_t one = people.below(200), other = photo % 5 == 0
                                                                   ? 200 + static_cast<std::size_t>(photo)
                                                                   : (one + 1 + people.below(199)) % 200;
            Photo faces;
            for (const std::size_t person : {one, other}) {
                who[++id] = person;
                faces.push_back(drawn::face(id, photo, people.picture_of(person)));
            }
            QVERIFY(groups.add(faces));
        }
        QCOMPARE(groups.face_count(), static_cast<std::size_t>(2 * photos));
        const auto all = groups.groups();
        for (const FaceGroup& group : all)
            QVERIFY(std::ranges::all_of(group.faces,
                                        [&](FaceId face) { return who[face] == who[group.faces[0]]; }));
        QCOMPARE(all.size(), static_cast<std::size_t>(200 + photos / 5));
    }
};

} // namespace face_groups_test

TP_TEST(face_groups_test, FaceGroupsTest, event_loop)
#include "face_groups_test.moc"
