// SPDX-License-Identifier: Apache-2.0
#include "album_folder.hpp"
#include "app/album/keeper/name_languages.hpp"
#include "byte_mutants.hpp"
#include "name_language_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <sys/stat.h>

namespace name_languages_test {

using namespace tp;
using tp::test::complaint_about_name_language;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t seed = 20261122;
constexpr std::size_t mutated_files = 5'000;

/// What is said of a person, or the problem.
std::string said_of(const NameLanguages& names, const std::string& person) {
    const auto language = names.of(person);
    return language ? *language : language.error();
}

} // namespace

class NameLanguagesTest : public QObject {
    Q_OBJECT
private slots:
    void tags_are_told_from_other_texts() {
        for (const char* tag :
             {"de", "pt-BR", "zh-Hant-TW", "es-419", "sl-rozaj-biske-1994", "x-own", "i-klingon", "abcdefgh",
              "en-a-bbb-x-a-ccc", "de-abcdefgh-abcdefgh-abcdefgh-abcde"})
            QVERIFY2(is_language_tag(tag), tag);
        for (const char* text :
             {"", "-", "d", "x", "q-own", "de-", "-de", "de--AT", "d1", "1de", "de_AT", "de AT", "de\n",
              "de\r\nQUIT", "dé", "abcdefghi", "de-abcdefghi", "de-abcdefgh-abcdefgh-abcdefgh-abcdef"})
            QVERIFY2(!is_language_tag(text), text);
    }

    void a_file_says_the_tag_and_the_person() {
        QCOMPARE(name_language_text({"Anaïs", "fr"}), std::string("fr\nAnaïs\n"));
        for (const std::string& person :
             {std::string("Anna"), std::string("박지민"), std::string("two\nlines\n"), std::string("\n"),
              std::string("not UTF-8 \xFF"), std::string(1000, 'x')})
            QCOMPARE(*parse_name_language(name_language_text({person, "pt-BR"})),
                     (NameLanguage{person, "pt-BR"}));
        QCOMPARE(*parse_name_language("fr\nAna"), (NameLanguage{"Ana", "fr"}));
        for (const char* text : {"", "\n", "fr", "fr\n", "fr\n\n", "\nAna\n", "Ana fr\n", "fr\r\nAna\r\n"})
            QVERIFY2(parse_name_language(text).error().ends_with('.'), text);
    }

    void a_file_is_read_up_to_a_megabyte() {
        const AlbumFolder album;
        for (const std::size_t more : {std::size_t{0}, std::size_t{1}}) {
            const fs::path file =
                album.write("x.language", "fr\n" + std::string((1 << 20) - 4 + more, 'x') + "\n");
            QCOMPARE(NameLanguages::read(file).ok(), more == 0);
        }
    }

    void any_bytes_are_refused_or_read() {
        const auto seeds =
            tp::test::corpus(tp::test::in_source("tests/app/album/keeper/name_language_corpus"));
        QVERIFY(seeds.size() >= 8);
        for (const auto& input : seeds) {
            const std::string complaint = complaint_about_name_language(input.text);
            QVERIFY2(complaint.empty(), (input.name + ": " + complaint).c_str());
        }
        tp::test::ByteMutator mutator(seed);
        for (std::size_t i = 0; i < mutated_files; ++i) {
            const std::string complaint = complaint_about_name_language(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), (std::to_string(i) + ": " + complaint).c_str());
        }
    }

    void a_language_is_chosen_changed_forgotten_and_each_taken_back() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        QCOMPARE(said_of(names, "Giulia"), std::string());
        QCOMPARE(names.choose("Giulia", ""), std::string());
        QCOMPARE(keeper.history().steps(), std::size_t{0}); // nothing was changed
        const std::vector<std::string> chosen{"it", "it-CH", ""};
        for (const std::string& language : chosen) {
            QCOMPARE(names.choose("Giulia", language), std::string());
            QCOMPARE(said_of(names, "Giulia"), language);
        }
        QVERIFY(!fs::exists(names.place_of("Giulia")));
        QCOMPARE(keeper.history().next_undo(), std::string("the language of the name of Giulia was chosen"));
        for (const char* before : {"it-CH", "it", ""}) {
            QCOMPARE(keeper.history().undo(), std::string());
            QCOMPARE(said_of(names, "Giulia"), std::string(before));
        }
        for (const std::string& language : chosen) {
            QCOMPARE(keeper.history().redo(), std::string());
            QCOMPARE(said_of(names, "Giulia"), language);
        }
    }

    void it_lies_beside_the_recorded_names_for_its_owner_only() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        QCOMPARE(names.choose("José", "es"), std::string());
        QCOMPARE(album.read(".touchphoto/people/José.language"), std::string("es\nJosé\n"));
        struct stat about {};
        for (const fs::path& place : {names.place_of("José"), names.place_of("José").parent_path()}) {
            QCOMPARE(::stat(place.c_str(), &about), 0);
            QCOMPARE(about.st_mode & 077u, 0u);
        }
    }

    void every_name_has_a_place_of_its_own() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        const std::vector<std::string> people{"Anna/Maria",
                                              "...",
                                              ".language",
                                              "Anna.flac",
                                              std::string(300, 'x'),
                                              "50 %",
                                              "a.language",
                                              "박지민",
                                              std::string(299, 'x') + 'y',
                                              "bad \xFF"};
        for (const std::string& person : people)
            QCOMPARE(names.choose(person, "fr-" + std::to_string(person.size())), std::string());
        const std::vector<NameLanguage> all = names.all();
        QCOMPARE(all.size(), people.size());
        for (const std::string& person : people) {
            const NameLanguage expected{person, "fr-" + std::to_string(person.size())};
            QVERIFY2(std::find(all.begin(), all.end(), expected) != all.end(), person.c_str());
            QCOMPARE(said_of(names, person), expected.language);
        }
        QCOMPARE(NameLanguages(keeper).all().size(), people.size());
    }

    void it_goes_where_its_person_goes() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        QCOMPARE(names.rename("Ana", "Anna"), std::string()); // there is none
        QCOMPARE(names.choose("Ana", "es"), std::string());
        for (int i = 0; i < 2; ++i) {
            QCOMPARE(i == 0 ? names.rename("Ana", "Anna/Maria") : keeper.history().redo(), std::string());
            QCOMPARE(names.all(), (std::vector<NameLanguage>{{"Anna/Maria", "es"}}));
            QCOMPARE(keeper.history().undo(), std::string());
            QCOMPARE(names.all(), (std::vector<NameLanguage>{{"Ana", "es"}}));
        }
    }

    void where_two_become_one_the_other_s_stays() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        QCOMPARE(names.choose("Ana", "es"), std::string());
        QCOMPARE(names.choose("Anna", "de"), std::string());
        for (int i = 0; i < 2; ++i) {
            QCOMPARE(i == 0 ? names.rename("Ana", "Anna") : keeper.history().redo(), std::string());
            QCOMPARE(names.all(), (std::vector<NameLanguage>{{"Anna", "de"}}));
            QCOMPARE(keeper.trash().entries().size(), std::size_t{1}); // nothing is lost
            QCOMPARE(keeper.history().undo(), std::string());
            QCOMPARE(names.all(), (std::vector<NameLanguage>{{"Ana", "es"}, {"Anna", "de"}}));
        }
    }

    void a_file_that_says_nothing_is_told_and_stays() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        QCOMPARE(names.choose("Tom", "en"), std::string());
        for (const char* text : {"", "what?", "fr", "fr\nSomebody else\n"}) {
            album.write(".touchphoto/people/Ana.language", text);
            QVERIFY(said_of(names, "Ana").find("Ana.language") != std::string::npos);
            QVERIFY(names.choose("Ana", "es").ends_with('.'));
            QVERIFY(names.choose("Ana", "").ends_with('.'));
            QVERIFY(names.rename("Ana", "Eva").ends_with('.'));
            QVERIFY(!fs::exists(names.place_of("Eva")));
            QCOMPARE(album.read(".touchphoto/people/Ana.language"), std::string(text));
            std::vector<std::string> problems;
            QCOMPARE(names.all(&problems), (std::vector<NameLanguage>{{"Tom", "en"}}));
            QCOMPARE(problems.size(), std::size_t{1});
        }
        QCOMPARE(names.rename("Tom", "Ana"), std::string()); // the other's stays, whatever it says
        QCOMPARE(album.read(".touchphoto/people/Ana.language"), std::string("fr\nSomebody else\n"));
        QCOMPARE(keeper.trash().entries().size(), std::size_t{1});
    }

    void what_makes_no_sense_changes_nothing() {
        const AlbumFolder album;
        AlbumKeeper keeper(album.path());
        NameLanguages names(keeper);
        QVERIFY(names.choose("", "fr").ends_with('.'));
        QVERIFY(names.choose("Ana", "french language").find("french language") != std::string::npos);
        album.write(".touchphoto/people", "a file where the folder should be");
        QVERIFY(names.choose("Ana", "es").ends_with('.'));
        QCOMPARE(keeper.history().steps(), std::size_t{0});
        QVERIFY(names.all().empty());
    }
};

} // namespace name_languages_test

TP_TEST(name_languages_test, NameLanguagesTest, event_loop)
#include "name_languages_test.moc"
