// SPDX-License-Identifier: Apache-2.0
#include "app/album/index/album_queries.hpp"
#include "app/album/index/search_words.hpp"
#include "app/album/index/sort_keys.hpp"
#include "test_album.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <set>

namespace search_test {

using namespace tp;
using namespace tp::testing;

class SearchTest : public QObject {
    Q_OBJECT

    TestAlbum album_;
    std::unique_ptr<AlbumIndex> index_;

    std::vector<std::string> found(std::string_view typed, std::size_t count = 50) {
        std::vector<std::string> names;
        const auto photos = AlbumQueries(*index_).search(typed, count);
        if (!photos)
            return {photos.error()};
        for (const PhotoEntry& photo : photos.value())
            names.push_back(photo.path.filename().string());
        return names;
    }
    std::vector<std::string> sorted(std::string_view typed) {
        std::vector<std::string> names = found(typed);
        std::sort(names.begin(), names.end());
        return names;
    }

    using Names = std::vector<std::string>;

private slots:
    void initTestCase() {
        PhotoRecord anna;
        anna.persons = {"Anna Müller"};
        anna.alt_text["x-default"] = "Two people at the sea";
        anna.place_name = "Sankt Pölten, Österreich";
        PhotoRecord sea;
        sea.description["x-default"] = "Das Meer. O'Hara AND \"friends\" near the sea";
        sea.keywords = {"Möwe", "NEAR"};
        sea.persons = {"Annemarie Huber", "Anna Müller"};
        PhotoRecord hebrew;
        hebrew.description["x-default"] = "שלום 👵🏽 日本";
        hebrew.keywords = {"Anna Anna"};
        for (const auto& [name, record] :
             {std::pair("a.jpg", anna), std::pair("b.jpg", sea), std::pair("c.jpg", hebrew)}) {
            album_.add(name, name);
            write_file(album_.root() / (std::string(name) + ".xmp"), sidecar_text(record));
        }
        const fs::path tagged = album_.add("d.jpg", "d");
        fs::create_directory(tagged.string() + ".tags");
        write_file(tagged.string() + ".tags/1.flac", "Großmutter erzählt vom Krieg");
        index_ = std::make_unique<AlbumIndex>(AlbumIndex::in_memory().value());
        QVERIFY(album_.scan(*index_).ok());
    }

    void words_are_found_where_they_are() {
        QCOMPARE(sorted("anna"), (Names{"a.jpg", "b.jpg", "c.jpg"}));
        QCOMPARE(sorted("sea"), (Names{"a.jpg", "b.jpg"}));
        QCOMPARE(sorted("sea anna"), (Names{"a.jpg", "b.jpg"}));
        QCOMPARE(sorted("meer"), (Names{"b.jpg"}));
        QCOMPARE(sorted("pölten"), (Names{"a.jpg"}));
        QCOMPARE(sorted("KRIEG"), (Names{"d.jpg"}));
        QCOMPARE(sorted("d.jpg"), (Names{"d.jpg"}));
        QCOMPARE(sorted("שלום"), (Names{"c.jpg"}));
        QVERIFY(found("nobody").empty());
    }

    void accents_and_case_do_not_count() {
        for (const char* typed : {"muller", "MÜLLER", "mu\xCC\x88ller", "Möwe muller", "mowe"})
            QVERIFY2(!found(typed).empty(), typed);
    }

    void the_last_word_may_be_half_typed() {
        QCOMPARE(sorted("ann"), (Names{"a.jpg", "b.jpg", "c.jpg"}));
        QCOMPARE(sorted("annem"), (Names{"b.jpg"}));
        QCOMPARE(sorted("annem "), (Names{})); // a blank ends the word
        QCOMPARE(sorted("ann sea"), (Names{}));
        QCOMPARE(sorted("sea ann"), (Names{"a.jpg", "b.jpg"}));
    }

    void a_name_counts_more_than_a_file() {
        TestAlbum album;
        album.add("huber.jpg", "1");
        album.add("other.jpg", "2", {"Eva Huber"});
        auto index = AlbumIndex::in_memory();
        QVERIFY(album.scan(*index).ok());
        const auto photos = AlbumQueries(*index).search("huber", 10);
        QCOMPARE(photos.value().size(), std::size_t(2));
        QCOMPARE(photos.value()[0].path.filename().string(), std::string("other.jpg"));
    }

    void whatever_is_typed_is_no_syntax() {
        for (const char* typed : {"\"",
                                  "\"\"\"",
                                  "anna\"",
                                  "anna OR sea",
                                  "NOT",
                                  "anna AND",
                                  "NEAR(anna sea)",
                                  "names:anna",
                                  "^anna",
                                  "anna*",
                                  "*",
                                  "-anna",
                                  "{names}: x",
                                  "anna + sea",
                                  "(",
                                  ")",
                                  "'; DROP TABLE photos; --",
                                  "a\\",
                                  "%_",
                                  "\xFF\xFE",
                                  "\xED\xA0\x80",
                                  "?",
                                  "?1",
                                  ":x",
                                  "@x",
                                  "$x",
                                  " ",
                                  "",
                                  "\n",
                                  "O'Hara",
                                  "👵🏽",
                                  "\xCC\x88",
                                  "a\xCC\x88\xCC\x88",
                                  "日本",
                                  "\t\"anna\"\t"}) {
            const auto photos = AlbumQueries(*index_).search(typed, 10);
            QVERIFY2(photos.ok(), typed);
            QVERIFY(AlbumQueries(*index_).suggestions(typed, 10).ok());
        }
        QCOMPARE(sorted("NEAR"), (Names{"b.jpg"}));
        QCOMPARE(sorted("O'Hara AND friends"), (Names{"b.jpg"}));
        QCOMPARE(sorted("names:anna"), (Names{}));
        QVERIFY(AlbumQueries(*index_).search(std::string(100'000, 'a'), 10).ok());
        std::string many;
        for (int i = 0; i < 10'000; ++i)
            many += "w" + std::to_string(i) + " ";
        QVERIFY(AlbumQueries(*index_).search(many, 10).ok());
    }

    void random_bytes_are_no_syntax() {
        SyntheticAlbum random(7);
        constexpr std::string_view bits = "\"'*()+-^:{}AND OR NOT NEAR a\xC3\xBC\xCC\x88\xFF\0\\,";
        for (int i = 0; i < 2000; ++i) {
            std::string typed;
            for (std::size_t n = random.below(12); n > 0; --n)
                typed += bits[random.below(bits.size())];
            const auto photos = AlbumQueries(*index_).search(typed, 10);
            QVERIFY2(photos.ok(), photos.error().c_str());
        }
    }

    void suggestions_are_the_commonest_that_begin_so() {
        AlbumQueries queries(*index_);
        const TopicEntry anna{"person", "Anna Müller", 2}, annemarie{"person", "Annemarie Huber", 1},
            keyword{"keyword", "Anna Anna", 1}, polten{"place", "Sankt Pölten, Österreich", 1};
        for (const char* typed : {"a", "an", "ann", "ANN"}) {
            const auto suggestions = queries.suggestions(typed, 10);
            QCOMPARE(suggestions.value().size(), std::size_t(3));
            QCOMPARE(suggestions.value()[0], anna);
        }
        QCOMPARE(queries.suggestions("anna  m", 10).value(), (std::vector<TopicEntry>{anna}));
        QCOMPARE(queries.suggestions("mul", 10).value(), (std::vector<TopicEntry>{anna}));
        QCOMPARE(queries.suggestions("huber", 10).value(), (std::vector<TopicEntry>{annemarie}));
        QCOMPARE(queries.suggestions("österr", 10).value(), (std::vector<TopicEntry>{polten}));
        QCOMPARE(queries.suggestions("anna a", 10).value(), (std::vector<TopicEntry>{keyword}));
        QCOMPARE(queries.suggestions("ann", 1).value(), (std::vector<TopicEntry>{anna}));
        QVERIFY(queries.suggestions("", 10).value().empty());
        QVERIFY(queries.suggestions("zzz", 10).value().empty());
    }

    void letters_lead_on_to_what_is_found() {
        AlbumQueries queries(*index_);
        QCOMPARE(queries.next_letters("mul").value(), (Names{"l"}));
        QCOMPARE(queries.next_letters("Mü").value(), (Names{"l"}));
        QCOMPARE(queries.next_letters("sea ann").value(), (Names{"a", "e"}));
        QCOMPARE(queries.next_letters("O'").value(), queries.next_letters("").value()); // a new word
        QCOMPARE(queries.next_letters("annahm").value(), (Names{}));
        QCOMPARE(queries.next_letters("日").value(), (Names{"本"}));
        // Each leads to something, and nothing that is there is left out.
        const auto first = queries.next_letters("").value();
        QVERIFY(std::is_sorted(first.begin(), first.end()));
        for (const std::string& letter : first)
            QVERIFY2(!found(letter).empty(), letter.c_str());
        for (char letter = 'a'; letter <= 'z'; ++letter) {
            const std::string typed(1, letter);
            QCOMPARE(std::count(first.begin(), first.end(), typed) > 0, !found(typed).empty());
        }
    }

    void letters_of_hangul_are_syllables() {
        TestAlbum album;
        PhotoRecord record;
        record.persons = {"안나", "안수"};
        album.add("a.jpg", "a");
        write_file(album.root() / "a.jpg.xmp", sidecar_text(record));
        AlbumIndex index = AlbumIndex::in_memory().value();
        QVERIFY(album.scan(index).ok());
        const auto letters = AlbumQueries(index).next_letters("안").value();
        QCOMPARE(letters, (Names{"나", "수"}));
    }

    /// Also where so many photographs have a word that it does not count for the order.
    void every_word_chooses_in_a_large_album() {
        TestAlbum album;
        auto index = AlbumIndex::in_memory();
        SyntheticAlbum made(9);
        std::vector<std::pair<std::string, std::set<std::string>>> photos;
        album.tools.read_record = [&](const fs::path& photo) -> Result<PhotoRecord> {
            PhotoRecord record;
            std::set<std::string> words{"common"};
            for (const char* word : {"half", "other", "some"})
                if (made.below(2) == 0)
                    words.insert(word);
            if (made.below(100) == 0)
                words.insert("rare");
            record.keywords.assign(words.begin(), words.end());
            photos.emplace_back(photo.filename().string(), words);
            return record;
        };
        for (int i = 0; i < 1500; ++i)
            album.add("IMG_" + std::to_string(i) + ".jpg", std::to_string(i));
        QVERIFY(album.scan(*index).ok());
        AlbumQueries queries(*index);
        for (const std::vector<std::string>& words :
             std::vector<std::vector<std::string>>{{"common"},
                                                   {"common", "half"},
                                                   {"half", "other", "some"},
                                                   {"rare"},
                                                   {"rare", "common"},
                                                   {"rare", "half", "other"},
                                                   {"common", "absent"},
                                                   {"img"}}) {
            std::set<std::string> expected;
            for (const auto& [name, has] : photos)
                if (std::all_of(words.begin(), words.end(), [&has = has](const std::string& word) {
                        return word == "img" || has.contains(word);
                    }))
                    expected.insert(name);
            std::string typed;
            for (const std::string& word : words)
                typed += word + " ";
            const auto result = queries.search(typed.substr(0, typed.size() - 1), 100);
            QCOMPARE(result.value().size(), std::min<std::size_t>(expected.size(), 100));
            for (const PhotoEntry& photo : result.value())
                QVERIFY(expected.contains(photo.path.filename().string()));
        }
    }
};

} // namespace search_test

TP_TEST(search_test, SearchTest, event_loop)
#include "search_test.moc"
