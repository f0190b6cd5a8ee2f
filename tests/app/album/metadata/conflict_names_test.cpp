// SPDX-License-Identifier: Apache-2.0
// Which names sync programs make, letter by letter: a name that is nearly one is somebody's own file and is left alone.
#include "app/album/metadata/conflicts.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>

namespace conflict_names_test {

using namespace tp;

namespace {

std::string original(const std::string& name) { return conflict_original(name).value_or("none"); }

} // namespace

class ConflictNamesTest : public QObject {
    Q_OBJECT
private slots:
    void syncthing() {
        for (const char* mark :
             {"20260501-101500", "20260501-101500-ABCDEFG", "00000000-999999", "99999999-000000"})
            QCOMPARE(original(std::string("a.jpg.sync-conflict-") + mark + ".xmp"), std::string("a.jpg.xmp"));
        for (const char* mark :
             {"", "2026", "20260501_101500", "2026050-1101500", "202605011-01500", "/0260501-101500",
              ":0260501-101500", "2026050/-101500", "20260501-:01500", "20260501-10150/", "20260501-10150",
              "20260501-1015000", "20260501-101500-", "20260501-101500-ABCDEF", "20260501-101500-ABCDEFGH",
              "20260501-101500_ABCDEFG", "20260501-101500ABCDEFGH", "x0260501-101500"})
            QCOMPARE(original(std::string("a.jpg.sync-conflict-") + mark + ".xmp"), std::string("none"));
        QCOMPARE(original("a.sync-conflict-x.sync-conflict-20260501-101500.xmp"),
                 std::string("a.sync-conflict-x.xmp"));
    }

    void owncloud() {
        for (const char* mark :
             {"20260501-101500", "Anna-20260501-101500", "-20260501-101500", "A-B-20260501-101500"})
            QCOMPARE(original(std::string("a.jpg_conflict-") + mark + ".xmp"), std::string("a.jpg.xmp"));
        for (const char* mark : {"", "0260501-101500", "Anna20260501-101500", "Anna_20260501-101500",
                                 "Anna-20260501-10150x", "20260501-101500-Anna", "120260501-101500"})
            QCOMPARE(original(std::string("a.jpg_conflict-") + mark + ".xmp"), std::string("none"));
    }

    void remarks_in_parentheses() {
        for (const char* remark :
             {"conflicted copy", "Anna's conflicted copy 2026-05-01", "CONFLICTED COPY",
              "case clash from Anna", "Case Conflict", "case conflict 2", "SFConflict anna@example.org 2026",
              "conflicted copy (2)", "conflicted copy (a (b) c)"})
            QCOMPARE(original(std::string("a.jpg (") + remark + ").xmp"), std::string("a.jpg.xmp"));
        for (const char* remark : {"", "conflicted", "copy", "a case conflict", "a case clash from Anna",
                                   "sfconflict", "a sfconflict b", "conflicted-copy", "1x", "2", "12"})
            QCOMPARE(original(std::string("a.jpg (") + remark + ").xmp"), std::string("none"));
        QCOMPARE(original("a.jpg(conflicted copy).xmp"), std::string("none"));
        QCOMPARE(original("a.jpg (conflicted copy)x.xmp"), std::string("none"));
        QCOMPARE(original("a.jpg (conflicted copy.xmp"), std::string("none"));
        QCOMPARE(original("a.jpg conflicted copy).xmp"), std::string("none"));
        QCOMPARE(original("(conflicted copy).xmp"), std::string("none"));
        QCOMPARE(original(" (conflicted copy)"), std::string("none")); // of nothing
        QCOMPARE(original(" (conflicted copy).xmp"), std::string(".xmp"));
        QCOMPARE(original("a (b) (conflicted copy).xmp"), std::string("a (b).xmp"));
    }

    void numbers_behind_a_remark() {
        QCOMPARE(original("a (conflicted copy) (2).xmp"), std::string("a.xmp"));
        QCOMPARE(original("a (conflicted copy) (12) (3).xmp"), std::string("a.xmp"));
        QCOMPARE(original("a.sync-conflict-20260501-101500 (09).xmp"), std::string("a.xmp"));
        for (const char* count : {"/", ":", "1:", "x", " ", ""})
            QCOMPARE(original(std::string("a (conflicted copy) (") + count + ").xmp"), std::string("none"));
        QCOMPARE(original("a (2).xmp"), std::string("none"));
    }

    void at_the_end_of_the_name_or_before_its_last_ending() {
        QCOMPARE(original("a.xmp.sync-conflict-20260501-101500"), std::string("a.xmp"));
        QCOMPARE(original("a (conflicted copy)"), std::string("a"));
        QCOMPARE(original("a.sync-conflict-20260501-101500.jpg.xmp"), std::string("none"));
        QCOMPARE(original("a_conflict-20260501-101500.sync-conflict-20260501-101500 (conflicted copy).xmp"),
                 std::string("a.xmp"));
        QCOMPARE(original("a_conflict-20260501-101500.xmp.sync-conflict-20260501-101500"),
                 std::string("a.xmp"));
        for (const char* plain : {"", "a", ".xmp", "a.", "a.xmp"})
            QCOMPARE(original(plain), std::string("none"));
    }
};

} // namespace conflict_names_test

TP_TEST(conflict_names_test, ConflictNamesTest, event_loop)
#include "conflict_names_test.moc"
