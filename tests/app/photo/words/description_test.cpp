// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/description.hpp"

#include <QTest>

using namespace tp;

namespace {

PersonShown somebody(const QString& name, Spot::Kind kind, Mien mien = Mien::unknown) {
    PersonShown person;
    person.name = name;
    person.spot.kind = kind;
    person.face.mien = mien;
    return person;
}

PhotoView looked_at() {
    PhotoView view;
    view.seen = true;
    view.width = 3000;
    view.height = 4000;
    return view;
}

/// Anna and two more, on a Sunday evening near Vienna.
PhotoView family() {
    PhotoView view = looked_at();
    view.people = {somebody("Anna", Spot::Kind::left, Mien::smiling_broadly),
                   somebody({}, Spot::Kind::middle), somebody({}, Spot::Kind::right, Mien::perhaps_smiling)};
    view.people[1].further_back = true;
    view.people[2].face.cut_off = true;
    view.people[2].face.eyes = Eyes::perhaps_shut;
    view.light = Light::dark;
    view.date = QDate(2019, 5, 12);
    view.time = QTime(19, 30);
    view.town = "Wien";
    view.where = NearTown::Where::near;
    return view;
}

PhotoView alone() {
    PhotoView view = looked_at();
    view.people = {somebody({}, Spot::Kind::middle, Mien::perhaps_laughing)};
    view.people[0].face.facing = Facing::camera;
    view.nearness = Nearness::face;
    view.colours = Colours::black_and_white;
    view.blurred = true;
    return view;
}

PhotoView crowd() {
    PhotoView view = looked_at();
    for (int i = 0; i < 13; ++i) {
        view.people.push_back(somebody({}, Spot::Kind::from_left, i < 5 ? Mien::smiling : Mien::unknown));
        view.people.back().spot.number = static_cast<std::size_t>(i) + 1;
    }
    view.people[1].name = "Tom";
    view.elsewhere = {"Eva"};
    return view;
}

} // namespace

class DescriptionTest : public QObject {
    Q_OBJECT

    void say(const PhotoView& view, QLocale::Language language, const char* in_short, const char* in_full) {
        QCOMPARE(short_description(view, language), QString::fromUtf8(in_short));
        QCOMPARE(full_description(view, language), QString::fromUtf8(in_full));
    }

private slots:
    void english() {
        say(family(), QLocale::English, "Anna and two more people, one of them smiling, May 2019, near Wien",
            "Three people: Anna at the left, smiling broadly; one in the middle, further back; one at the "
            "right, cut "
            "off by the edge, perhaps smiling, eyes perhaps shut. An upright picture, dark. A Sunday evening "
            "in May "
            "2019, near Wien.");
        say(alone(), QLocale::English, "one person, perhaps laughing",
            "One person, perhaps laughing, facing the camera. An upright picture, close to the face, black "
            "and white, "
            "blurred.");
        say(crowd(), QLocale::English, "Tom, Eva, and eleven more people, five of them smiling",
            "13 people, five of them smiling: Tom second from the left, smiling; named: Eva. An upright "
            "picture.");
    }

    void german() {
        say(family(), QLocale::German,
            "Anna und zwei weitere Personen, eine davon lächelnd, Mai 2019, bei Wien",
            "Drei Personen: Anna links, breit lächelnd; eine in der Mitte, weiter hinten; eine rechts, vom "
            "Bildrand "
            "angeschnitten, vielleicht lächelnd, die Augen vielleicht geschlossen. Ein Hochformat, dunkel. "
            "Ein "
            "Sonntagabend im Mai 2019, bei Wien.");
        say(alone(), QLocale::German, "eine Person, vielleicht lachend",
            "Eine Person, vielleicht lachend, der Kamera zugewandt. Ein Hochformat, Nahaufnahme, "
            "schwarz-weiß, "
            "unscharf.");
        say(crowd(), QLocale::German, "Tom, Eva und elf weitere Personen, fünf davon lächelnd",
            "13 Personen, fünf davon lächelnd: Tom an zweiter Stelle von links, lächelnd; genannt sind: Eva. "
            "Ein "
            "Hochformat.");
    }

    void korean() {
        say(family(), QLocale::Korean,
            "Anna, 다른 두 사람, 그중 한 사람 웃는 얼굴, 2019년 5월, Wien 근처에서",
            "세 사람: 왼쪽에 Anna, 활짝 웃는 얼굴; 가운데 한 사람, 더 뒤쪽; 오른쪽에 한 사람, 사진 "
            "가장자리에서 잘림, "
            "미소를 띤 듯한 얼굴, 눈을 감은 듯함. 세로 사진, 어두움. 2019년 5월 어느 일요일 저녁, Wien "
            "근처에서.");
        say(alone(), QLocale::Korean, "한 사람, 소리 내어 웃는 듯한 얼굴",
            "한 사람, 소리 내어 웃는 듯한 얼굴, 정면을 향함. 세로 사진, 얼굴을 가까이에서 찍음, 흑백, 흐림.");
        say(crowd(), QLocale::Korean, "Tom, Eva, 다른 11명, 그중 다섯 사람 웃는 얼굴",
            "13명, 그중 다섯 사람 웃는 얼굴: 왼쪽에서 두 번째에 Tom, 웃는 얼굴; 이름이 적힌 사람: Eva. 세로 "
            "사진.");
    }

    void what_was_taken_is_told_with_place_and_eyes() {
        PhotoView view = looked_at();
        view.people = {somebody("Anna", Spot::Kind::middle, Mien::smiling)};
        view.people[0].face.eyes = Eyes::open;
        view.people[0].face.facing = Facing::camera;
        view.light = Light::dark;
        view.date = QDate(2026, 11, 26);
        QCOMPARE(taken_words(view, QLocale::English),
                 QString("Taken: Anna in the middle, smiling, eyes open. A little dark."));
        QCOMPARE(taken_words(view, QLocale::German),
                 QString("Aufgenommen: Anna in der Mitte, lächelnd, die Augen offen. Etwas dunkel."));
        QCOMPARE(taken_words(view, QLocale::Korean),
                 QString("찍음: 가운데 Anna, 웃는 얼굴, 눈을 뜸. 조금 어두움."));

        view.people = {somebody({}, Spot::Kind::left), somebody("Tom", Spot::Kind::right)};
        view.people[0].face.eyes = Eyes::shut;
        view.people[1].face.cut_off = true;
        view.light = Light::bright_background;
        view.blurred = true;
        QCOMPARE(
            taken_words(view, QLocale::English),
            QString("Taken: two people: one at the left, eyes shut; Tom at the right, cut off by the edge. "
                    "Blurred, against a bright background."));
        view.people[0].name = "Anna";
        QVERIFY2(
            taken_words(view, QLocale::English)
                .startsWith("Taken: Anna at the left, eyes shut; Tom at the right, cut off by the edge. "),
            qPrintable(taken_words(view, QLocale::English)));
        QVERIFY(full_description(view, QLocale::English).startsWith("Two people: Anna"));
        QCOMPARE(taken_words(looked_at(), QLocale::English), QString("Taken: no faces."));
        QCOMPARE(taken_words(looked_at(), QLocale::German), QString("Aufgenommen: keine Gesichter."));
    }

    void time_and_place_can_come_first() {
        QVERIFY(full_description(family(), QLocale::English, DescriptionOrder::place_first)
                    .startsWith("A Sunday evening in May 2019, near Wien. Three people: Anna"));
        QVERIFY(short_description(family(), QLocale::German, DescriptionOrder::place_first)
                    .startsWith("Mai 2019, bei Wien, Anna und"));
    }

    void all_smile_and_both_smile() {
        PhotoView view = looked_at();
        view.people = {somebody({}, Spot::Kind::left, Mien::smiling),
                       somebody({}, Spot::Kind::right, Mien::smiling)};
        QCOMPARE(short_description(view, QLocale::English), QString("two people, both smiling"));
        QCOMPARE(short_description(view, QLocale::German), QString("zwei Personen, beide lächelnd"));
        QCOMPARE(short_description(view, QLocale::Korean), QString("두 사람, 둘 다 웃는 얼굴"));
        view.people.push_back(view.people[0]);
        QCOMPARE(short_description(view, QLocale::English), QString("three people, all smiling"));
    }

    void nobody_on_it_and_nobody_looked_are_two_things() {
        QCOMPARE(full_description(looked_at(), QLocale::English), QString("No faces. An upright picture."));
        QCOMPARE(short_description(looked_at(), QLocale::German), QString("keine Gesichter"));
        QCOMPARE(full_description(PhotoView(), QLocale::English), QString());
        PhotoView named;
        named.elsewhere = {"Eva", "Tom"};
        named.town = "Wien";
        QCOMPARE(full_description(named, QLocale::German), QString("Eva und Tom. In Wien."));
    }

    /// Day names and parts of the day that languages make one word of, and from which hour on.
    void times_of_day_are_said_as_the_language_does() {
        PhotoView view;
        view.date = QDate(2019, 5, 12);
        const auto at = [&](int hour, QLocale::Language language) {
            view.time = hour < 0 ? QTime() : QTime(hour, 0);
            return grammar_of(language).when(view);
        };
        QCOMPARE(at(-1, QLocale::English), QString("a Sunday in May 2019"));
        QCOMPARE(at(4, QLocale::English), QString("a night in May 2019"));
        QCOMPARE(at(5, QLocale::English), QString("a Sunday morning in May 2019"));
        QCOMPARE(at(12, QLocale::English), QString("a Sunday afternoon in May 2019"));
        QCOMPARE(at(22, QLocale::English), QString("a Sunday night in May 2019"));
        QCOMPARE(at(-1, QLocale::German), QString("ein Sonntag im Mai 2019"));
        QCOMPARE(at(4, QLocale::German), QString("eine Nacht im Mai 2019"));
        QCOMPARE(at(11, QLocale::German), QString("ein Sonntagvormittag im Mai 2019"));
        QCOMPARE(at(13, QLocale::German), QString("ein Sonntagmittag im Mai 2019"));
        QCOMPARE(at(23, QLocale::German), QString("eine Sonntagnacht im Mai 2019"));
        QCOMPARE(at(-1, QLocale::Korean), QString("2019년 5월 어느 일요일"));
        QCOMPARE(at(4, QLocale::Korean), QString("2019년 5월 어느 날 새벽"));
        QCOMPARE(at(13, QLocale::Korean), QString("2019년 5월 어느 일요일 오후"));
    }

    void a_far_town_is_said_with_its_distance() {
        PhotoView view;
        view.town = "Graz";
        view.where = NearTown::Where::from;
        view.km = 60;
        QCOMPARE(grammar_of(QLocale::English).where(view), QString("about 60 km from Graz"));
        QCOMPARE(grammar_of(QLocale::German).where(view), QString("etwa 60 km von Graz entfernt"));
        QCOMPARE(grammar_of(QLocale::Korean).where(view), QString("Graz에서 약 60km 떨어진 곳에서"));
        QCOMPARE(grammar_of(QLocale::French).where(view), grammar_of(QLocale::English).where(view));
    }

    /// Every word is there in every language, and no two things are said alike.
    void no_word_is_missing() {
        for (const QLocale::Language language : {QLocale::English, QLocale::German, QLocale::Korean}) {
            QStringList said;
            const auto add = [&](PhotoView view) { said << full_description(view, language); };
            for (const Mien mien : {Mien::unknown, Mien::perhaps_smiling, Mien::smiling,
                                    Mien::smiling_broadly, Mien::perhaps_laughing}) {
                PhotoView view = looked_at();
                view.people = {somebody("Anna", Spot::Kind::middle, mien)};
                add(view);
                if (mien == Mien::unknown)
                    continue;
                view.people[0].face.eyes = Eyes::shut;
                add(view);
                view.people[0].face.facing = Facing::left;
                add(view);
                view.people[0].face.facing = Facing::right;
                add(view);
            }
            for (const auto kind : {Spot::Kind::left, Spot::Kind::right, Spot::Kind::above, Spot::Kind::below,
                                    Spot::Kind::far_left, Spot::Kind::far_right}) {
                PhotoView view = looked_at();
                view.people = {somebody("Anna", kind), somebody("Tom", Spot::Kind::middle)};
                add(view);
            }
            for (std::size_t number = 2; number < 13; ++number) {
                PhotoView view = looked_at();
                view.people = {somebody("Anna", Spot::Kind::from_left)};
                view.people[0].spot.number = number;
                add(view);
            }
            for (const Colours colours : {Colours::black_and_white, Colours::red, Colours::yellow,
                                          Colours::green, Colours::blue, Colours::violet}) {
                PhotoView view = looked_at();
                view.colours = colours;
                add(view);
            }
            for (const Light light : {Light::dark, Light::dark_background, Light::bright_background}) {
                PhotoView view = looked_at();
                view.light = light;
                add(view);
            }
            for (const int width : {3999, 4001, 6000, 60'000}) {
                PhotoView view = looked_at();
                view.width = width;
                view.colours = width == 4001 ? Colours::red : Colours::many;
                add(view);
            }
            for (const QString& text : said) {
                QVERIFY2(!text.contains(", ,") && !text.contains("  ") && !text.contains(",."),
                         qPrintable(text));
                QVERIFY(!text.isEmpty() && text.endsWith('.'));
            }
            said.removeAll(full_description(
                [] {
                    PhotoView view = looked_at();
                    view.width = 3999;
                    return view;
                }(),
                language)); // as square as 4001
            QStringList unlike = said;
            unlike.removeDuplicates();
            QCOMPARE(unlike.size(), said.size());
        }
    }
};

QTEST_APPLESS_MAIN(DescriptionTest)
#include "description_test.moc"
