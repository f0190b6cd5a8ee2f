// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/write_sidecar.hpp"
#include "app/pages/care/description_care.hpp"
#include "care_bench.hpp"
#include "full_disk.hpp"
#include "test_program.hpp"

#include <QSignalSpy>

#include <filesystem>
#include <string>

namespace description_care_test {

using namespace tp;
namespace fs = std::filesystem;

namespace {

struct Bench : CareParts {
    QString language = "en";
    DescriptionCare descriptions{cared, teller, [this] { return language; }};
    using CareParts::CareParts;

    void type(const QString& alt_text, const QString& description = {}) {
        descriptions.typeAltText(alt_text);
        descriptions.typeDescription(description);
    }
    bool saved() {
        descriptions.save();
        return rests();
    }
    std::string alt_text(const std::string& name = "a.jpg") const {
        const LanguageTexts texts = record(name).alt_text;
        return texts.contains("en") ? texts.at("en") : std::string();
    }
    std::string description(const std::string& name = "a.jpg") const {
        const LanguageTexts texts = record(name).description;
        return texts.contains("en") ? texts.at("en") : std::string();
    }
    /// By another program.
    void write(const std::string& name, const LanguageTexts& alt_text) {
        SidecarChanges changes;
        changes.alt_text = alt_text;
        QCOMPARE(write_sidecar(photo(name), changes), std::string());
    }
    /// Without waiting.
    void go_to(const std::string& name) { cared.open({photo(name), &album->keeper_for(photo(name))}); }
};

} // namespace

class DescriptionCareTest : public QObject {
    Q_OBJECT
private slots:
    void descriptions_are_saved_once_and_taken_back() {
        Bench bench;
        bench.open();
        QVERIFY(!bench.descriptions.unsaved());
        bench.type("A garden ", " Two people in a garden, laughing.");
        QVERIFY(bench.descriptions.unsaved());
        bench.descriptions.save();
        bench.descriptions.save(); // the field is left, and the button pressed
        QVERIFY(bench.rests());
        QCOMPARE(bench.voice.said(), QStringList{"The description is saved."});
        QVERIFY(bench.sounded(Earcon::saved));
        QVERIFY(!bench.descriptions.unsaved());
        QCOMPARE(bench.descriptions.altText(), QString("A garden"));
        QCOMPARE(bench.descriptions.description(), QString("Two people in a garden, laughing."));
        QCOMPARE(bench.alt_text(), std::string("A garden"));
        QCOMPARE(bench.description(), std::string("Two people in a garden, laughing."));
        bench.descriptions.save();
        QVERIFY(!bench.steps.busy());
        bench.history.undo();
        QVERIFY(bench.rests());
        QCOMPARE(bench.descriptions.altText() + bench.descriptions.description(), QString());
        QVERIFY(!bench.descriptions.unsaved());
    }
    void the_page_is_told_of_what_is_typed_read_and_saved() {
        Bench bench;
        bench.write("a.jpg", {{"en", "A cat"}});
        QSignalSpy changed(&bench.descriptions, &DescriptionCare::changed);
        bench.go_to("a.jpg");
        const auto told = changed.size();
        QVERIFY(told > 0);
        QVERIFY(bench.rests());
        QCOMPARE(bench.descriptions.altText(), QString("A cat"));
        QVERIFY(changed.size() > told);
        changed.clear();
        bench.type("A cat");
        QVERIFY(changed.isEmpty());
        bench.type("A dog", "On a sofa");
        QCOMPARE(changed.size(), 2);
        changed.clear();
        bool unsaved = true;
        connect(&bench.descriptions, &DescriptionCare::changed, &bench.descriptions,
                [&] { unsaved = bench.descriptions.unsaved(); });
        QVERIFY(bench.saved());
        QVERIFY(!unsaved);
    }
    void what_is_typed_while_the_disk_is_slow_is_kept_too() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.write("b.jpg", {{"en", "A cat"}});
        bench.open("a.jpg");
        {
            SlowDisk disk("a.jpg.xmp");
            bench.descriptions.typeAltText("A garden");
            bench.descriptions.save();
            CARE_TRY_VERIFY(disk.waits());
            bench.descriptions.typeDescription("Two people in a garden.");
            bench.descriptions.save(); // that field is left, too
            bench.go_to("b.jpg");
            bench.descriptions.typeDescription("Two people in a garden."); // on that one, too
        }
        QVERIFY(bench.rests());
        QCOMPARE(bench.alt_text("a.jpg"), std::string("A garden"));
        QCOMPARE(bench.description("a.jpg"), std::string("Two people in a garden."));
        QCOMPARE(bench.descriptions.altText(), QString("A cat"));
        QCOMPARE(bench.descriptions.description(), QString("Two people in a garden."));
        QVERIFY(bench.descriptions.unsaved());
        QVERIFY(bench.record("b.jpg").description.empty());
    }
    void what_is_typed_back_while_the_disk_is_slow_is_as_before() {
        Bench bench;
        bench.write("a.jpg", {{"en", "A cat"}});
        bench.open();
        {
            SlowDisk disk("a.jpg.xmp");
            bench.descriptions.typeAltText("A dog");
            bench.descriptions.save();
            CARE_TRY_VERIFY(disk.waits());
            bench.descriptions.typeAltText("A cat");
            bench.descriptions.save();
            QStringList shown;
            connect(&bench.descriptions, &DescriptionCare::changed, &bench.descriptions,
                    [&] { shown << bench.descriptions.altText(); });
            disk.let(1);
            CARE_TRY_COMPARE(bench.voice.said().size(), 1);
            bench.descriptions.save(); // it is on its way
            QVERIFY2(!shown.contains("A dog"), qPrintable(shown.join('|')));
            disconnect(&bench.descriptions, &DescriptionCare::changed, &bench.descriptions, nullptr);
        }
        QVERIFY(bench.rests());
        QCOMPARE(bench.voice.said().size(), 2);
        QCOMPARE(bench.alt_text(), std::string("A cat"));
        QCOMPARE(bench.descriptions.altText(), QString("A cat"));
        QVERIFY(!bench.descriptions.unsaved());
    }
    void what_is_typed_after_leaving_a_field_stays_unsaved_beside_what_was_kept() {
        Bench bench;
        bench.open();
        {
            SlowDisk disk("a.jpg.xmp");
            bench.descriptions.typeAltText("A garden");
            bench.descriptions.save();
            CARE_TRY_VERIFY(disk.waits());
            bench.descriptions.typeAltText("A garden in May");
        }
        QVERIFY(bench.rests());
        QCOMPARE(bench.alt_text(), std::string("A garden"));
        QCOMPARE(bench.descriptions.altText(), QString("A garden in May"));
        QVERIFY(bench.descriptions.unsaved());
    }
    void what_was_typed_is_kept_when_another_photograph_is_opened_or_none() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.descriptions.save();
        QVERIFY(!bench.steps.busy()); // none is open
        bench.open("a.jpg");
        bench.type("A garden");
        bench.open("b.jpg");
        QCOMPARE(bench.descriptions.altText(), QString());
        QCOMPARE(bench.alt_text("a.jpg"), std::string("A garden"));
        bench.type("", "More");
        bench.cared.close();
        QVERIFY(bench.rests());
        QCOMPARE(bench.description("b.jpg"), std::string("More"));
        QVERIFY(bench.descriptions.description().isEmpty() && !bench.descriptions.unsaved());
    }
    void what_another_program_wrote_is_shown_unless_a_person_has_typed_something() {
        Bench bench;
        bench.open();
        bench.type("", "Typed");
        bench.write("a.jpg", {{"en", "A cat"}});
        bench.cared.read_again();
        QVERIFY(bench.rests());
        QCOMPARE(bench.descriptions.altText(), QString("A cat"));
        QCOMPARE(bench.descriptions.description(), QString("Typed"));
        QVERIFY(bench.descriptions.unsaved());
        bench.type("A dog", "");
        bench.write("a.jpg", {{"en", "A bird"}});
        bench.cared.read_again();
        QVERIFY(bench.rests());
        QCOMPARE(bench.descriptions.altText(), QString("A dog"));
    }
    void it_is_of_the_albums_language_and_what_is_for_everybody_is_changed_where_it_stands() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.language = "de";
        QCOMPARE(bench.descriptions.languageName(), QString("Deutsch"));
        bench.write("a.jpg", {{"en", "A cat"}, {"de", "Eine Katze"}});
        bench.write("b.jpg", {{"x-default", "A cat"}});
        bench.open("a.jpg");
        QCOMPARE(bench.descriptions.altText(), QString("Eine Katze"));
        bench.open("b.jpg");
        QCOMPARE(bench.descriptions.altText(), QString("A cat"));
        bench.type("A dog");
        QVERIFY(bench.saved());
        QCOMPARE(bench.record("b.jpg").alt_text, (LanguageTexts{{"x-default", "A dog"}}));
    }

    // --- what fails ---

    void what_was_typed_stays_where_it_could_not_be_saved() {
        Bench bench;
        bench.open();
        bench.type("A garden");
        {
            const FullDisk disk("a.jpg.xmp");
            QVERIFY(bench.saved());
        }
        QVERIFY2(bench.last_said().contains("the disk is full."), qPrintable(bench.last_said()));
        QVERIFY(bench.sounded(Earcon::error));
        QCOMPARE(bench.descriptions.altText(), QString("A garden"));
        QVERIFY(bench.descriptions.unsaved());
        QVERIFY(bench.saved()); // there is room again
        QCOMPARE(bench.alt_text(), std::string("A garden"));
        bench.folder.write("album/a.jpg.xmp", "not XMP at all");
        bench.type("A cat");
        QVERIFY(bench.saved());
        QVERIFY(bench.last_said().contains("a.jpg.xmp"));
        QCOMPARE(bench.descriptions.altText(), QString("A cat"));
        QVERIFY(bench.descriptions.unsaved());
    }
    void what_could_not_be_saved_of_a_photograph_that_was_left_is_there_again() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.write("a.jpg", {{"en", "A cat"}});
        bench.open("a.jpg");
        bench.type("A garden", "In May");
        {
            const FullDisk disk("a.jpg.xmp");
            bench.open("b.jpg");
            QCOMPARE(bench.descriptions.altText(), QString());
        }
        bench.open("a.jpg");
        QCOMPARE(bench.descriptions.altText(), QString("A garden"));
        QCOMPARE(bench.descriptions.description(), QString("In May"));
        QVERIFY(bench.descriptions.unsaved());
        bench.open("b.jpg"); // there is room again
        QCOMPARE(bench.alt_text("a.jpg"), std::string("A garden"));
        bench.open("a.jpg");
        QVERIFY(!bench.descriptions.unsaved());
    }
    void nor_is_it_lost_when_the_photograph_was_opened_again_before_the_disk_answered() {
        Bench bench({"a.jpg", "b.jpg"});
        bench.open("a.jpg");
        bench.type("A garden");
        {
            const FullDisk disk("a.jpg.xmp");
            bench.go_to("b.jpg");
            bench.go_to("a.jpg");
            QVERIFY(bench.rests());
        }
        QCOMPARE(bench.descriptions.altText(), QString("A garden"));
        QVERIFY(bench.descriptions.unsaved());
    }
    void of_a_photograph_that_another_program_deleted_nothing_is_saved() {
        Bench bench;
        bench.open();
        fs::remove(bench.photo("a.jpg"));
        bench.type("A garden");
        QVERIFY(bench.saved());
        QVERIFY2(bench.last_said().contains("a.jpg"), qPrintable(bench.last_said()));
        QVERIFY(bench.sounded(Earcon::error));
        QVERIFY(bench.descriptions.unsaved());
        QVERIFY(!fs::exists(bench.root() / "a.jpg.xmp"));
    }
};

} // namespace description_care_test

TP_TEST(description_care_test, DescriptionCareTest, window)
#include "description_care_test.moc"
