// SPDX-License-Identifier: Apache-2.0
#include "app/figures/study/published_results.hpp"
#include "core/files/whole_file.hpp"
#include "drawn_study.hpp"
#include "places.hpp"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace tp;
using namespace tp::testing;
namespace fs = std::filesystem;
using Kind = PublishedResult::Kind;

namespace {

std::string shipped(const std::string& name) {
    return read_whole(test::in_source(("resources/studies/" + name + ".study").c_str()),
                      most_experiment_bytes)
        .value();
}

/// People whose error and time depend on what `of` says of the levels, and a little on chance.
template <typename Of>
StudyReport drawn(const fs::path& folder, const std::string& name, unsigned seed, Of of) {
    const Experiment experiment = read_experiment(shipped(name)).value();
    draw_study(folder, shipped(name), 4,
               [&](int participant, const PlannedTrial& trial, TrialRecord& record) {
                   if (trial.training)
                       return;
                   std::mt19937 random(static_cast<unsigned>(trial.seed) + seed);
                   std::normal_distribution<double> noise(0.0, 0.1);
                   of(experiment, experiment.levels_of(trial.condition), record);
                   if (record.error_mm)
                       *record.error_mm += 0.1 * participant + noise(random);
                   record.time_s += 0.1 * participant + noise(random);
               });
    return report_on(read_study(folder).value()).value();
}

const ComparedResult& found(const std::vector<ComparedResult>& results, const std::string& subject,
                            Kind kind) {
    for (const ComparedResult& result : results)
        if (subject_words(result.published) == subject && result.published.kind == kind)
            return result;
    qFatal("nothing published: %s", subject.c_str());
}

} // namespace

class PublishedResultsTest : public QObject {
    Q_OBJECT
    QTemporaryDir dir_;
    fs::path folder(const char* name) const { return fs::path(dir_.path().toStdString()) / name; }

private slots:
    /// Lim, Yoo and Choi (2019), sections on Experiments I to III: every F with its significance.
    void every_f_of_the_paper_is_there() {
        const std::map<std::string, std::pair<double, bool>> paper{
            {"tracking error by stiffness", {27.65, true}},
            {"tracking error by range", {41.97, true}},
            {"tracking error by path", {2.59, false}},
            {"tracking error by stiffness × range", {6.67, true}},
            {"tracking time by stiffness", {30.14, true}},
            {"tracking time by range", {30.00, true}},
            {"tracking time by path", {43.01, true}},
            {"tracking time by stiffness × range", {16.4, true}},
            {"tracking time by stiffness × path", {8.70, true}},
            {"tracking time by range × path", {11.06, true}},
            {"tracking time by stiffness × range × path", {4.29, true}},
            {"primitives named rightly by shape", {3.74, true}},
            {"primitives named rightly by radius", {27.0, true}},
            {"primitives named rightly by shape × radius", {8.59, true}},
            {"primitives time by shape", {16.35, true}},
            {"primitives time by radius", {0.58, false}}};
        std::map<std::string, std::pair<double, bool>> ours;
        for (const PublishedResult& result : published_results())
            if (result.kind == Kind::f)
                ours[std::string(result.experiment) + ' ' + subject_words(result)] = {result.low,
                                                                                      result.significant};
        QCOMPARE(ours, paper);
    }
    /// The same: means in percent and seconds.
    void every_mean_of_the_paper_is_there() {
        const std::map<std::string, std::string> paper{
            {"primitives named rightly, pentagon, 20 mm", "63.0 %"},
            {"primitives named rightly, hexagon, 20 mm", "70.0 %"},
            {"primitives named rightly, pentagon, 50 mm", "at least 90.0 %"},
            {"primitives named rightly, hexagon, 50 mm", "at least 90.0 %"},
            {"primitives named rightly, pentagon, 80 mm", "at least 90.0 %"},
            {"primitives named rightly, hexagon, 80 mm", "at least 90.0 %"},
            {"primitives time, circle", "7.9 s"},
            {"primitives time, hexagon", "21.2 s"},
            {"expressions named rightly, smiling", "97.5 %"},
            {"expressions named rightly, surprised", "97.5 %"},
            {"expressions named rightly, sad", "80.0 %"},
            {"expressions named rightly, angry", "80.0 %"},
            {"expressions time", "20 to 30 s"}};
        std::map<std::string, std::string> ours;
        for (const PublishedResult& result : published_results())
            if (result.kind == Kind::mean)
                ours[std::string(result.experiment) + ' ' + subject_words(result)] = published_words(result);
        QCOMPARE(ours, paper);
    }
    void effects_and_orders_are_found_where_they_are_and_nowhere_else() {
        const auto study = [&](const char* name, unsigned seed, bool wide_is_worse) {
            return drawn(folder(name), "tracking", seed,
                         [=](const Experiment&, const std::vector<std::size_t>& levels, TrialRecord& record) {
                             const auto stiffness = static_cast<double>(std::min<std::size_t>(levels[0], 3)),
                                        range = static_cast<double>(levels[1]);
                             record.error_mm = 5.0 - 0.6 * stiffness + (wide_is_worse ? 0.4 : -0.4) * range;
                             record.time_s = 20.0 + 4.0 * static_cast<double>(levels[2]) - range;
                         });
        };
        const std::vector<StudyReport> studies{study("a", 1, false), study("b", 2, false),
                                               study("c", 3, true)};
        const auto results = compared_results(studies);
        QVERIFY(found(results, "error by stiffness", Kind::f).alike);
        QVERIFY(found(results, "error by range", Kind::f).alike);
        QVERIFY(found(results, "error by path", Kind::f).alike); // not significant in either
        QVERIFY(!found(results, "error by stiffness × range", Kind::f).alike);
        QVERIFY(found(results, "error by stiffness", Kind::falls).alike);
        QVERIFY(found(results, "error by stiffness", Kind::saturates).alike);
        QVERIFY(!found(results, "error by range", Kind::saturates).alike);
        const ComparedResult& wide = found(results, "error by range", Kind::falls);
        QVERIFY(wide.alike && wide.least == 0.0 && wide.most == 1.0); // in two of three
        QCOMPARE(our_words(wide), std::string("in 2 of 3"));
        QVERIFY(!compared_results(std::span(studies).last(1)).empty());
        QVERIFY(!found(compared_results(std::span(studies).last(1)), "error by range", Kind::falls).alike);
        const ComparedResult& f = found(results, "time by path", Kind::f);
        QCOMPARE(f.ours.size(), std::size_t{3});
        QVERIFY(f.least < f.mean && f.mean < f.most);
        QVERIFY(!found(results, "time by stiffness", Kind::f).alike);
    }
    void means_are_those_of_the_named_cells() {
        const StudyReport report = drawn(
            folder("d"), "primitives", 1,
            [](const Experiment& experiment, const std::vector<std::size_t>& levels, TrialRecord& record) {
                const std::string shape = experiment.factors[0].levels[levels[0]];
                record.answer = shape == "hexagon" && levels[1] == 0 ? "circle" : shape;
                record.time_s = shape == "circle" ? 16.5 : 20.0;
            });
        const auto results = compared_results(std::span(&report, 1));
        QCOMPARE(found(results, "named rightly, hexagon, 20 mm", Kind::mean).mean, 0.0);
        QVERIFY(!found(results, "named rightly, hexagon, 20 mm", Kind::mean).alike);
        QCOMPARE(found(results, "named rightly, hexagon, 50 mm", Kind::mean).mean, 1.0);
        QVERIFY(found(results, "named rightly, hexagon, 50 mm", Kind::mean).alike);
        QVERIFY(!found(results, "named rightly, pentagon, 20 mm", Kind::mean)
                     .alike); // 100 % is not within ten points of 63
        QVERIFY(std::abs(found(results, "time, circle", Kind::mean).mean - 16.75) < 0.1);
        QVERIFY(!found(results, "time, circle", Kind::mean).alike); // more than twice 7.9 s
        QVERIFY(found(results, "time, hexagon", Kind::mean).alike);
        QVERIFY(found(results, "time", Kind::smallest).alike);
        QVERIFY(found(results, "named rightly", Kind::smallest).alike);
    }
    void the_comparison_is_a_table_a_plot_and_a_page() {
        const auto of = [](const Experiment& experiment, const std::vector<std::size_t>& levels,
                           TrialRecord& record) {
            record.answer = experiment.factors[0].levels[levels[0]];
            record.time_s = 10.0;
        };
        const std::vector<StudyReport> studies{drawn(folder("e"), "primitives", 1, of),
                                               drawn(folder("f"), "primitives", 2, of)};
        QCOMPARE(write_comparison(folder("out"), studies), std::string());
        QVERIFY(!QImage(QString::fromStdString((folder("out") / "published.png").string())).isNull());
        const std::string page = read_whole(folder("out") / "published.html", 1 << 20).value();
        QVERIFY(page.find("<td>time, circle</td><td>7.9 s</td>") != std::string::npos);
        QVERIFY(page.find("2 studies of 4 participants each") != std::string::npos);
        const auto results = compared_results(studies);
        QCOMPARE(published_table(results).row_count(), results.size());
        QCOMPARE(write_report(folder("report"), studies[0]), std::string());
        QVERIFY(fs::exists(folder("report") / "published.csv") &&
                fs::exists(folder("report") / "published.svg"));
        QVERIFY(read_whole(folder("report") / study_page_file, 1 << 20)
                    ->find("Beside the published experiment") != std::string::npos);
        StudyReport other = studies[0];
        other.experiment.name = "mine";
        QVERIFY(compared_results(std::span(&other, 1)).empty());
        QCOMPARE(write_comparison(folder("no"), std::span(&other, 1)),
                 std::string("Nothing was published of the experiment mine."));
    }
};

QTEST_MAIN(PublishedResultsTest)
#include "published_results_test.moc"
