// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/caption_grammar.hpp"
#include "app/photo/words/grammars.hpp"

#include <array>

namespace tp {

namespace {

constexpr CaptionWords english_words{
    {"", "perhaps smiling", "smiling", "smiling broadly", "perhaps laughing"},
    {"", "", "eyes perhaps shut", "eyes shut"},
    {"", "facing the camera", "turned to the left", "turned to the right"},
    {"", "an upright picture", "a square picture", "a wide picture", "a panorama"},
    {"from far away", "", "head and shoulders", "close to the face"},
    {"", "black and white", "mostly red around", "mostly yellow around", "mostly green around",
     "mostly blue around", "mostly violet around"},
    {"", "dark", "against a dark background", "against a bright background"},
    {"at the left", "in the middle", "at the right", "above", "below", "at the far left", "%1 from the left",
     "at the far right"},
    "no faces",
    "one",
    "further back",
    "cut off by the edge",
    "blurred",
    "named: ",
    "taken: ",
    "eyes open",
    "a little dark"};

class English final : public CaptionGrammar {
public:
    English() : CaptionGrammar(english_words) {}

    QString month(const PhotoView& view) const override {
        if (!view.date.isValid())
            return {};
        return locale().standaloneMonthName(view.date.month()) + QLatin1Char(' ') +
               QString::number(view.date.year());
    }

    QString when(const PhotoView& view) const override {
        if (!view.date.isValid())
            return {};
        const QString day = locale().standaloneDayName(view.date.dayOfWeek());
        const int hour = view.time.isValid() ? view.time.hour() : -1;
        const QString part = hour < 0    ? day
                             : hour < 5  ? QStringLiteral("night") // of which day, people do not agree
                             : hour < 12 ? day + " morning"
                             : hour < 18 ? day + " afternoon"
                             : hour < 22 ? day + " evening"
                                         : day + " night";
        return "a " + part + " in " + month(view);
    }

    QString where(const PhotoView& view) const override {
        if (view.town.isEmpty())
            return {};
        switch (view.where) {
        case NearTown::Where::in:
            return "in " + view.town;
        case NearTown::Where::near:
            return "near " + view.town;
        case NearTown::Where::from:
            return "about " + QString::number(view.km) + " km from " + view.town;
        }
        return {};
    }

protected:
    QString count(std::size_t people) const override {
        return people == 1 ? QStringLiteral("one person") : number(people) + " people";
    }
    QString more(std::size_t people) const override {
        return people == 1 ? QStringLiteral("one more person") : number(people) + " more people";
    }
    QString list(const QStringList& names) const override { return locale().createSeparatedList(names); }
    QString smiles(std::size_t smiling, std::size_t people) const override {
        return smiling < people ? number(smiling) + " of them smiling"
               : people == 2    ? QStringLiteral("both smiling")
                                : QStringLiteral("all smiling");
    }

    QString placed(const QString& who, const QString& spot) const override {
        return who + QLatin1Char(' ') + spot;
    }

    QString ordinal(std::size_t n) const override {
        static constexpr std::array words{"first", "second",  "third",  "fourth", "fifth",
                                          "sixth", "seventh", "eighth", "ninth",  "tenth"};
        return n >= 1 && n <= words.size() ? QString::fromUtf8(words[n - 1]) : "number " + QString::number(n);
    }

private:
    static QLocale locale() { return QLocale(QLocale::English); }

    static QString number(std::size_t n) {
        static constexpr std::array words{"no",    "one",   "two",  "three", "four",   "five",  "six",
                                          "seven", "eight", "nine", "ten",   "eleven", "twelve"};
        return n < words.size() ? QString::fromUtf8(words[n]) : QString::number(n);
    }
};

} // namespace

const DescriptionGrammar& english_grammar() {
    static const English grammar;
    return grammar;
}

} // namespace tp
