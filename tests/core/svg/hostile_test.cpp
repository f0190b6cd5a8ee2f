// SPDX-License-Identifier: Apache-2.0
#include "core/svg/contour_sheet.hpp"
#include "core/svg/path_pieces.hpp"
#include "path_check.hpp"
#include "places.hpp"
#include "sheet_check.hpp"
#include "svg_mutants.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>
#include <vector>

namespace hostile_test {

using tp::test::Mutator;
using tp::test::Seed;

namespace {

constexpr std::size_t mutated_inputs = 20'000;
constexpr std::uint64_t seed = 20190709;

std::vector<Seed> sheets() { return tp::test::corpus(tp::test::in_source("tests/core/svg/corpus")); }

} // namespace

class HostileSheets : public QObject {
    Q_OBJECT

private slots:
    void corpus_data() {
        QTest::addColumn<QByteArray>("text");
        for (const Seed& input : sheets())
            QTest::newRow(input.name.c_str()) << QByteArray::fromStdString(input.text);
    }
    void corpus() {
        QFETCH(QByteArray, text);
        QCOMPARE(tp::test::complaint_about(text.toStdString()), std::string());
    }

    void mutated_corpus() {
        const std::vector<Seed> seeds = sheets();
        QVERIFY(seeds.size() >= 10);
        Mutator mutator(seed);
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

    void mutated_path_data() {
        const std::vector<Seed> seeds = tp::test::corpus(tp::test::in_source("tests/core/svg/path_corpus"));
        QVERIFY(seeds.size() >= 5);
        for (const Seed& input : seeds)
            QCOMPARE(tp::test::complaint_about_path(input.text), std::string());
        Mutator mutator(seed);
        std::size_t drawn = 0;
        for (std::size_t i = 0; i < mutated_inputs; ++i) {
            const std::string text = mutator.mutant(seeds);
            const std::string complaint = tp::test::complaint_about_path(text);
            QVERIFY2(complaint.empty(), (complaint + ": " + text).c_str());
            drawn += tp::svg::subpaths_from(text, 1e-3, 1000).ok() ? 1 : 0;
        }
        QVERIFY2(drawn > mutated_inputs / 10, qPrintable(QString::number(drawn)));
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

    void as_many_pieces_as_a_sheet_may_hold_are_read() {
        std::string text = "<svg width=\"10\" height=\"10\"><path id=\"coast\" d=\"M0 0";
        for (int i = 0; i < 1'900'000; ++i)
            text += i % 2 == 0 ? " 1 1" : " 0 0";
        const auto sheet = tp::sheet_from_svg(text + "\"/></svg>");
        QVERIFY2(sheet.ok(), sheet.error().c_str());
        QCOMPARE(sheet->contours.at(0).pieces.size(), std::size_t{1'900'000});
    }

    void as_many_contours_as_a_sheet_may_hold_are_read() {
        std::string text = "<svg width=\"10\" height=\"10\">";
        for (int i = 0; i < 200'000; ++i)
            text += "<path d=\"M0 0 1 1\"/>";
        QVERIFY(tp::sheet_from_svg(text + "</svg>").ok());
    }

    /// Signs of tags and attributes are counted before anything is read, here in a comment.
    void tags_and_attributes_up_to_their_limits() {
        const auto with = [](std::size_t count, char sign) {
            return tp::sheet_from_svg("<svg width=\"10\" height=\"10\"><!-- " + std::string(count, sign) +
                                      " --></svg>");
        };
        QVERIFY(with(3'999'990, '<').ok());
        QVERIFY(!with(4'000'010, '<').ok());
        QVERIFY(with(7'999'990, '=').ok());
        QVERIFY(!with(8'000'010, '=').ok());
    }

    void names_up_to_64_mib_together() {
        const auto with = [](int contours) {
            std::string text =
                "<svg width=\"9\" height=\"9\"><path id=\"" + std::string(1 << 20, 'x') + "\" d=\"";
            for (int i = 0; i < contours; ++i)
                text += "M0 0 1 1";
            return tp::sheet_from_svg(text + "\"/></svg>").ok();
        };
        QVERIFY(with(60));
        QVERIFY(!with(70));
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

    void more_contours_than_a_sheet_may_hold() {
        std::string text = "<svg width=\"10\" height=\"10\">";
        for (int i = 0; i < 200'001; ++i)
            text += "<path d=\"M0 0 1 1\"/>";
        const auto sheet = tp::sheet_from_svg(text + "</svg>");
        QVERIFY(!sheet.ok());
        QVERIFY2(sheet.error().find("more lines than") != std::string::npos, sheet.error().c_str());
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

} // namespace hostile_test

TP_TEST(hostile_test, HostileSheets, event_loop)
#include "hostile_test.moc"
