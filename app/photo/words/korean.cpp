// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/caption_grammar.hpp"
#include "app/photo/words/grammars.hpp"

#include <array>

namespace tp {

namespace {

constexpr CaptionWords korean_words{
    {"", "미소를 띤 듯한 얼굴", "웃는 얼굴", "활짝 웃는 얼굴", "소리 내어 웃는 듯한 얼굴"},
    {"", "", "눈을 감은 듯함", "눈을 감음"},
    {"", "정면을 향함", "왼쪽을 향함", "오른쪽을 향함"},
    {"", "세로 사진", "정사각형 사진", "가로 사진", "파노라마 사진"},
    {"멀리서 찍음", "", "머리와 어깨까지 나옴", "얼굴을 가까이에서 찍음"},
    {"", "흑백", "주변은 대부분 빨간색", "주변은 대부분 노란색", "주변은 대부분 초록색",
     "주변은 대부분 파란색", "주변은 대부분 보라색"},
    {"", "어두움", "어두운 배경", "밝은 배경"},
    {"왼쪽에", "가운데", "오른쪽에", "위쪽에", "아래쪽에", "맨 왼쪽에", "왼쪽에서 %1에", "맨 오른쪽에"},
    "얼굴 없음",
    "한 사람",
    "더 뒤쪽",
    "사진 가장자리에서 잘림",
    "흐림",
    "이름이 적힌 사람: ",
    "찍음: ",
    "눈을 뜸",
    "조금 어두움"};

/// Phrases that end in nouns, as captions do: no particle then depends on how a name ends, which a name in Latin letters
/// does not tell.
class Korean final : public CaptionGrammar {
public:
    Korean() : CaptionGrammar(korean_words) {}

    QString month(const PhotoView& view) const override {
        if (!view.date.isValid())
            return {};
        return QString::number(view.date.year()) + "년 " + QString::number(view.date.month()) + "월";
    }

    QString when(const PhotoView& view) const override {
        if (!view.date.isValid())
            return {};
        const QString day = locale().standaloneDayName(view.date.dayOfWeek());
        const int hour = view.time.isValid() ? view.time.hour() : -1;
        return month(view) + (hour < 0    ? " 어느 " + day
                              : hour < 5  ? QStringLiteral(" 어느 날 새벽")
                              : hour < 9  ? " 어느 " + day + " 아침"
                              : hour < 12 ? " 어느 " + day + " 오전"
                              : hour < 18 ? " 어느 " + day + " 오후"
                              : hour < 22 ? " 어느 " + day + " 저녁"
                                          : " 어느 " + day + " 밤");
    }

    QString where(const PhotoView& view) const override {
        if (view.town.isEmpty())
            return {};
        switch (view.where) {
        case NearTown::Where::in:
            return view.town + "에서";
        case NearTown::Where::near:
            return view.town + " 근처에서";
        case NearTown::Where::from:
            return view.town + "에서 약 " + QString::number(view.km) + "km 떨어진 곳에서";
        }
        return {};
    }

protected:
    QString count(std::size_t people) const override { return number(people); }
    QString more(std::size_t people) const override { return "다른 " + number(people); }
    QString list(const QStringList& names) const override { return names.join(QStringLiteral(", ")); }
    QString smiles(std::size_t smiling, std::size_t people) const override {
        return smiling < people ? "그중 " + number(smiling) + " 웃는 얼굴"
               : people == 2    ? QStringLiteral("둘 다 웃는 얼굴")
                                : QStringLiteral("모두 웃는 얼굴");
    }

    QString placed(const QString& who, const QString& spot) const override {
        return spot + QLatin1Char(' ') + who;
    }

    QString ordinal(std::size_t n) const override {
        static constexpr std::array words{"첫",   "두",   "세",   "네",   "다섯",
                                          "여섯", "일곱", "여덟", "아홉", "열"};
        return n >= 1 && n <= words.size() ? QString::fromUtf8(words[n - 1]) + " 번째"
                                           : QString::number(n) + "번째";
    }

private:
    static QLocale locale() { return QLocale(QLocale::Korean); }

    static QString number(std::size_t n) {
        static constexpr std::array words{"",     "한",   "두",   "세",   "네", "다섯",
                                          "여섯", "일곱", "여덟", "아홉", "열"};
        return n >= 1 && n < words.size() ? QString::fromUtf8(words[n]) + " 사람" : QString::number(n) + "명";
    }
};

} // namespace

const DescriptionGrammar& korean_grammar() {
    static const Korean grammar;
    return grammar;
}

} // namespace tp
