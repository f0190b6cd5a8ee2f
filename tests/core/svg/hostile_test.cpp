// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "sheet_check.hpp"

#include <QTest>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr std::size_t mutated_inputs = 20'000;
constexpr std::uint64_t seed = 20190709;
constexpr std::size_t longest_mutant = 16'384;

struct Seed {
    std::string name;
    std::string text;
};

std::vector<Seed> corpus() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(TP_SOURCE_DIR "/tests/core/svg/corpus"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Seed> seeds;
    for (const auto& file : files) {
        std::ifstream stream(file, std::ios::binary);
        seeds.push_back({file.filename().string(), {std::istreambuf_iterator<char>(stream), {}}});
    }
    return seeds;
}

/// What a blind change of bytes would take long to hit upon.
constexpr std::array<std::string_view, 44> words = {"<path d=\"M0 0L1 1Z\"/>",
                                                    "<g transform=\"scale(2)\">",
                                                    "</g>",
                                                    "<circle r=\"5\"/>",
                                                    "<rect width=\"3\" height=\"4\" rx=\"1\"/>",
                                                    " transform=\"rotate(30 1 2)\"",
                                                    " transform=\"skewX(89.9999999)\"",
                                                    " transform=\"matrix(1 0 0 0 0 0)\"",
                                                    " viewBox=\"0 0 1e300 1e-300\"",
                                                    " viewBox=\"-5 -5 10 20\"",
                                                    " preserveAspectRatio=\"none\"",
                                                    " preserveAspectRatio=\"xMaxYMin slice\"",
                                                    " width=\"1e308mm\"",
                                                    " height=\"50%\"",
                                                    " id=\"a b\"",
                                                    " data-name=\"a%20b\"",
                                                    " id=\"a_b\"",
                                                    " style=\"display:none\"",
                                                    "display:inline",
                                                    "1e400",
                                                    "1e-400",
                                                    "-0",
                                                    "nan",
                                                    "inf",
                                                    "1e308",
                                                    "-1e308",
                                                    "4.9e-324",
                                                    "A 5 3 20 1 0 9 9",
                                                    "a1 1 0 0 1 1e-9 0",
                                                    "A1e-300 1e300 0 1 1 5 5",
                                                    "z",
                                                    "m",
                                                    "T 3 4",
                                                    "s 1 2 3 4",
                                                    "C0 0 0 0 0 0",
                                                    "Q 1e200 1e200 0 0",
                                                    "&#0;",
                                                    "&#1;",
                                                    "&amp;",
                                                    "&lol;",
                                                    "]]>",
                                                    "<![CDATA[",
                                                    std::string_view("\0", 1),
                                                    "\xFF"};

class Mutator {
public:
    std::string mutant(const std::vector<Seed>& seeds) {
        std::string text = seeds[below(seeds.size())].text;
        const std::size_t steps = 1 + below(3);
        for (std::size_t i = 0; i < steps; ++i)
            change(text, seeds);
        text.resize(std::min(text.size(), longest_mutant));
        return text;
    }

private:
    std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random_() % n); }

    void change(std::string& text, const std::vector<Seed>& seeds) {
        const std::size_t at = below(text.size() + 1);
        switch (below(10)) {
        case 0:
            if (at < text.size())
                text[at] = static_cast<char>(random_() & 0xFFu);
            break;
        case 1:
            if (at < text.size())
                text[at] = static_cast<char>(text[at] ^ static_cast<char>(1u << below(8)));
            break;
        case 2:
            text.erase(at, below(20));
            break;
        case 3:
            text.insert(at, text.substr(at, below(60)));
            break;
        case 4: { // another seed's middle
            const std::string& other = seeds[below(seeds.size())].text;
            text.insert(at, other.substr(below(other.size()), below(120)));
            break;
        }
        case 5: // in place of a number, most often
            if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
                text.replace(digit, 1, words[below(words.size())]);
            break;
        case 6:
        case 7:
        case 8:
            if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
                text[digit] = static_cast<char>('0' + below(10));
            break;
        default:
            text.insert(at, words[below(words.size())]);
        }
    }

    std::mt19937_64 random_{seed};
};

} // namespace

class HostileSheets : public QObject {
    Q_OBJECT

private slots:
    void corpus_data() {
        QTest::addColumn<QByteArray>("text");
        for (const Seed& input : ::corpus())
            QTest::newRow(input.name.c_str()) << QByteArray::fromStdString(input.text);
    }
    void corpus() {
        QFETCH(QByteArray, text);
        QCOMPARE(tp::test::complaint_about(text.toStdString()), std::string());
    }

    void mutated_corpus() {
        const std::vector<Seed> seeds = ::corpus();
        QVERIFY(seeds.size() >= 10);
        Mutator mutator;
        std::size_t read = 0;
        for (std::size_t i = 0; i < mutated_inputs; ++i) {
            const std::string text = mutator.mutant(seeds);
            const std::string complaint = tp::test::complaint_about(text);
            if (!complaint.empty())
                qWarning("input %zu: %s\n%s", i, complaint.c_str(), text.c_str());
            QVERIFY(complaint.empty());
            read += tp::sheet_from_svg(text).ok() ? 1 : 0;
        }
        // Mutants that are all refused would test nothing but the refusal.
        QVERIFY2(read > mutated_inputs / 10, qPrintable(QString::number(read)));
    }

    void groups_nested_100_000_deep() {
        std::string text = "<svg width=\"10\" height=\"10\">";
        const std::size_t depth = 100'000;
        for (std::size_t i = 0; i < depth; ++i)
            text += "<g transform=\"translate(1e-5,0)\">";
        text += "<path d=\"M0 0 L1 1\"/>";
        for (std::size_t i = 0; i < depth; ++i)
            text += "</g>";
        text += "</svg>";
        const auto sheet = tp::sheet_from_svg(text);
        QVERIFY2(sheet.ok(), sheet.error().c_str());
        QCOMPARE(sheet->contours.size(), std::size_t{1});
        QVERIFY(std::abs(tp::start_of(sheet->contours[0].pieces[0]).x - 1.0) < 1e-9);
    }

    void tags_100_000_deep_and_never_closed() {
        std::string text = "<svg width=\"10\" height=\"10\">";
        for (int i = 0; i < 100'000; ++i)
            text += "<g>";
        QVERIFY(!tp::sheet_from_svg(text).ok());
    }

    void doctype_nested_100_000_deep() {
        std::string text = "<!DOCTYPE svg ";
        for (int i = 0; i < 100'000; ++i)
            text += "[<!x ";
        QVERIFY(!tp::sheet_from_svg(text + "<svg width=\"1\" height=\"1\"/>").ok());
    }

    void a_billion_laughs_stay_one_word() {
        std::string text = "<!DOCTYPE svg [<!ENTITY a0 \"M0 0L1 1\">";
        for (int i = 1; i < 30; ++i) {
            const std::string before = "&a" + std::to_string(i - 1) + ";";
            text += "<!ENTITY a" + std::to_string(i) + " \"" + before + before + before + before + "\">";
        }
        text += "]><svg width=\"9\" height=\"9\"><path id=\"&a29;\" d=\"M0 0L1 1\"/></svg>";
        const auto sheet = tp::sheet_from_svg(text);
        QVERIFY2(sheet.ok(), sheet.error().c_str());
        QCOMPARE(sheet->contours.at(0).name, std::string("&a29;"));
        QCOMPARE(tp::test::complaint_about(text), std::string());
    }

    void more_pieces_than_a_sheet_may_hold() {
        std::string text = "<svg width=\"10\" height=\"10\"><path id=\"coast\" d=\"M0 0";
        for (int i = 0; i < 2'100'000; ++i)
            text += i % 2 == 0 ? " 1 1" : " 0 0";
        const auto sheet = tp::sheet_from_svg(text + "\"/></svg>");
        QVERIFY(!sheet.ok());
        QVERIFY2(sheet.error().find("coast") != std::string::npos, sheet.error().c_str());
    }

    void one_endless_name_for_many_contours() {
        std::string text =
            "<svg width=\"10\" height=\"10\"><path id=\"" + std::string(1 << 20, 'x') + "\" d=\"";
        for (int i = 0; i < 1'000; ++i)
            text += "M0 0 1 1";
        QVERIFY(!tp::sheet_from_svg(text + "\"/></svg>").ok());
    }

    void many_contours_of_one_name() {
        std::string text = "<svg width=\"10\" height=\"10\">";
        for (int i = 0; i < 50'000; ++i)
            text += "<path id=\"eye\" d=\"M0 0 1 1\"/>";
        const auto sheet = tp::sheet_from_svg(text + "</svg>");
        QVERIFY(sheet.ok());
        QCOMPARE(sheet->contours.back().name, std::string("eye 50000"));
    }

    void larger_than_64_mib() {
        const auto sheet = tp::sheet_from_svg(std::string((std::size_t{64} << 20) + 1, ' '));
        QVERIFY(!sheet.ok());
        QVERIFY(sheet.error().find("64 MB") != std::string::npos);
    }

    void more_elements_than_a_sheet_may_have() {
        std::string text = "<svg width=\"10\" height=\"10\">";
        for (int i = 0; i < 4'000'001; ++i)
            text += "<g/>";
        QVERIFY(!tp::sheet_from_svg(text + "</svg>").ok());
    }
};

QTEST_GUILESS_MAIN(HostileSheets)
#include "hostile_test.moc"
