// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/caption_grammar.hpp"
#include "app/photo/words/grammars.hpp"

#include <array>

namespace tp {

namespace {

constexpr CaptionWords german_words{
    {"", "vielleicht lächelnd", "lächelnd", "breit lächelnd", "vielleicht lachend"},
    {"", "", "die Augen vielleicht geschlossen", "die Augen geschlossen"},
    {"", "der Kamera zugewandt", "nach links gewandt", "nach rechts gewandt"},
    {"", "ein Hochformat", "ein quadratisches Bild", "ein Querformat", "ein Panorama"},
    {"von weitem", "", "Kopf und Schultern", "Nahaufnahme"},
    {"", "schwarz-weiß", "ringsum vor allem rot", "ringsum vor allem gelb", "ringsum vor allem grün",
     "ringsum vor allem blau", "ringsum vor allem violett"},
    {"", "dunkel", "vor dunklem Hintergrund", "vor hellem Hintergrund"},
    {"links", "in der Mitte", "rechts", "oben", "unten", "ganz links", "an %1 Stelle von links",
     "ganz rechts"},
    "keine Gesichter",
    "eine",
    "weiter hinten",
    "vom Bildrand angeschnitten",
    "unscharf",
    "genannt sind: ",
    "aufgenommen: ",
    "die Augen offen",
    "etwas dunkel"};

class German final : public CaptionGrammar {
public:
    German() : CaptionGrammar(german_words) {}

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
        const QString part = hour < 0    ? "ein " + day
                             : hour < 5  ? QStringLiteral("eine Nacht") // of which day, people do not agree
                             : hour < 10 ? "ein " + day + "morgen"
                             : hour < 12 ? "ein " + day + "vormittag"
                             : hour < 14 ? "ein " + day + "mittag"
                             : hour < 18 ? "ein " + day + "nachmittag"
                             : hour < 22 ? "ein " + day + "abend"
                                         : "eine " + day + "nacht";
        return part + " im " + month(view);
    }

    QString where(const PhotoView& view) const override {
        if (view.town.isEmpty())
            return {};
        switch (view.where) {
        case NearTown::Where::in:
            return "in " + view.town;
        case NearTown::Where::near:
            return "bei " + view.town;
        case NearTown::Where::from:
            return "etwa " + QString::number(view.km) + " km von " + view.town + " entfernt";
        }
        return {};
    }

protected:
    QString count(std::size_t people) const override {
        return people == 1 ? QStringLiteral("eine Person") : number(people) + " Personen";
    }
    QString more(std::size_t people) const override {
        return people == 1 ? QStringLiteral("eine weitere Person") : number(people) + " weitere Personen";
    }
    QString list(const QStringList& names) const override { return locale().createSeparatedList(names); }
    QString smiles(std::size_t smiling, std::size_t people) const override {
        return smiling < people ? number(smiling) + " davon lächelnd"
               : people == 2    ? QStringLiteral("beide lächelnd")
                                : QStringLiteral("alle lächelnd");
    }

    QString placed(const QString& who, const QString& spot) const override {
        return who + QLatin1Char(' ') + spot;
    }

    QString ordinal(std::size_t n) const override {
        static constexpr std::array words{"erster",   "zweiter", "dritter", "vierter", "fünfter",
                                          "sechster", "siebter", "achter",  "neunter", "zehnter"};
        return n >= 1 && n <= words.size() ? QString::fromUtf8(words[n - 1])
                                           : QString::number(n) + QLatin1Char('.');
    }

private:
    static QLocale locale() { return QLocale(QLocale::German); }

    static QString number(std::size_t n) {
        static constexpr std::array words{"keine",  "eine", "zwei", "drei", "vier", "fünf", "sechs",
                                          "sieben", "acht", "neun", "zehn", "elf",  "zwölf"};
        return n < words.size() ? QString::fromUtf8(words[n]) : QString::number(n);
    }
};

} // namespace

const DescriptionGrammar& german_grammar() {
    static const German grammar;
    return grammar;
}

} // namespace tp
