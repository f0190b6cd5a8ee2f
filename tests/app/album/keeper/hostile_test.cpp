// SPDX-License-Identifier: Apache-2.0
#include "album_list_check.hpp"
#include "bundle_check.hpp"
#include "byte_mutants.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

namespace hostile_test {

using namespace tp::test;

namespace {

constexpr std::uint64_t seed = 20260501;
constexpr std::size_t mutated_bundles = 2'000;

std::vector<Seed> bundles() { return corpus(tp::test::in_source("tests/app/album/keeper/bundle_corpus")); }

} // namespace

class HostileBundles : public QObject {
    Q_OBJECT

private slots:
    void bundle_corpus() {
        QVERIFY(bundles().size() >= 10);
        for (const Seed& input : bundles()) {
            const std::string complaint = complaint_about_bundle(input.text);
            QVERIFY2(complaint.empty(), (input.name + ": " + complaint).c_str());
        }
    }

    void lists_of_deletions_and_imports() {
        const std::vector<Seed> lists = corpus(tp::test::in_source("tests/app/album/keeper/list_corpus"));
        QVERIFY(lists.size() >= 6);
        ByteMutator mutator(seed);
        for (const Seed& input : lists)
            QCOMPARE(complaint_about_album_lists(input.text), std::string());
        for (std::size_t i = 0; i < mutated_bundles; ++i)
            QCOMPARE(complaint_about_album_lists(mutator.mutant(lists)), std::string());
    }

    void mutated_bundles_are_refused_or_harmless() {
        const std::vector<Seed> seeds = bundles();
        ByteMutator mutator(seed);
        for (std::size_t i = 0; i < mutated_bundles; ++i) {
            const std::string complaint = complaint_about_bundle(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), (std::to_string(i) + ": " + complaint).c_str());
        }
    }
};

} // namespace hostile_test

TP_TEST(hostile_test, HostileBundles, event_loop)
#include "hostile_test.moc"
