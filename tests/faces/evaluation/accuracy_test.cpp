// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/golden_set.hpp"
#include "faces/extract/face_extractor.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace accuracy_test {

using namespace tp;

namespace {

constexpr const char* golden_file = "tests/faces/golden_set.txt";

using Limits = std::array<double, feature_count>; ///< of felt_features, percent

/// What no mean error may pass, whatever the golden set says.
constexpr Limits own_limits{0.46, 0.47, 0.72, 0.29, 1.30}, mesh_limits{0.55, 0.55, 0.7, 0.37, 1.25};

} // namespace

/// Errors over all people held out of the training.
class AccuracyTest : public QObject {
    Q_OBJECT

    std::vector<PlacedPortrait> people_;
    std::map<std::string, std::vector<PortraitErrors>> measured_; ///< by detector, model and refinement

    /// Of those people; each choice is extracted once.
    const std::vector<PortraitErrors>& measured(const ExtractorChoice& choice) {
        const std::string key = choice.detector + '\n' + choice.model + '\n' +
                                std::to_string(static_cast<int>(choice.refinement));
        const auto found = measured_.find(key);
        return found != measured_.end()
                   ? found->second
                   : measured_.emplace(key, std::move(measured_errors(choice, people_)).value())
                         .first->second;
    }

private slots:
    void initTestCase() {
        if (portraits::present())
            people_ = held_out_portraits(tp::test::in_source("faces/training/holdout.txt"),
                                         portraits::folder() / "photos/london_truth.json",
                                         portraits::folder() / "photos")
                          .value();
    }

    void contours_are_as_exact_as_the_golden_set_data() {
        QTest::addColumn<QString>("row");
        for (const char* row : {"embedded", "yunet", "mesh"})
            QTest::newRow(row) << row;
    }
    void contours_are_as_exact_as_the_golden_set() {
        NEEDS_PORTRAITS();
        QFETCH(QString, row);
        const std::string name = row.toStdString();
        const auto golden = read_golden_set(tp::test::in_source(golden_file));
        QVERIFY2(golden.ok(), golden.error().c_str());
        QVERIFY(golden->contains(name));

        const auto& errors = measured(golden_choices().at(name));
        const auto median = [&](auto milliseconds) {
            std::vector<double> all;
            for (const PortraitErrors& person : errors)
                all.push_back(milliseconds(person.milliseconds));
            std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2),
                             all.end());
            return all[all.size() / 2];
        };
        qInfo("%zu people held out of all training: detect %.1f ms, landmarks and contours %.1f ms (medians)",
              errors.size(), median([](const ExtractionTimes& t) { return t.detect; }),
              median([](const ExtractionTimes& t) { return t.landmarks + t.contours; }));
        const GoldenRow now = golden_row(errors);
        for (std::size_t f = 0; f < feature_count; ++f)
            qInfo("  %-9s %.2f %% (worst %.2f)", felt_features[f], now.features[f].mean,
                  now.features[f].worst);

        QStringList all;
        for (const std::string& difference : differences(name, golden->at(name), errors))
            all << QString::fromStdString(difference);
        QVERIFY2(all.isEmpty(), qPrintable(all.join('\n')));
        QCOMPARE(errors.size(), std::size_t{34});
        QCOMPARE(now.failures, std::size_t{0});
        const Limits& most = name == "mesh" ? mesh_limits : own_limits;
        for (std::size_t f = 0; f < feature_count; ++f)
            QVERIFY2(now.features[f].mean <= most[f], felt_features[f]);
    }

    void edges_make_every_feature_better_data() {
        QTest::addColumn<QString>("model");
        QTest::newRow("embedded") << "embedded";
        QTest::newRow("mesh") << "mesh";
    }
    /// The looks of the edges (edge_look.hpp) were not learned from these people either.
    void edges_make_every_feature_better() {
        NEEDS_PORTRAITS();
        QFETCH(QString, model);
        const auto& without = measured({"embedded", model.toStdString(), RefinementStage::close_looks});
        const auto& with = measured({"embedded", model.toStdString()});
        const GoldenRow plain = golden_row(without), moved = golden_row(with);
        for (std::size_t f = 0; f < feature_count; ++f) {
            double most_worse = 0.0;
            int better = 0;
            for (std::size_t i = 0; i < with.size(); ++i) {
                const double before = without[i].percent.value()[f], after = with[i].percent.value()[f];
                most_worse = std::max(most_worse, after - before);
                better += after < before;
            }
            const auto& [mean_before, worst_before] = plain.features[f];
            const auto& [mean_after, worst_after] = moved.features[f];
            const char* name = felt_features[f];
            qInfo("%-9s mean %.3f -> %.3f %%, worst %.2f -> %.2f, better for %d of %zu, most worse by %.2f",
                  name, mean_before, mean_after, worst_before, worst_after, better, with.size(), most_worse);
            QVERIFY2(mean_after <= mean_before * 1.001, name);
            QVERIFY2(most_worse < 0.45, name);
        }
        const auto gain = [&](FeatureIndex f) { return moved.features[f].mean / plain.features[f].mean; };
        QVERIFY(gain(at_outer_lip) < 0.95);
        QVERIFY(gain(at_inner_lip) < 0.8);
    }

    /// Nobody placed the contours of smiling faces by hand. Two models that learned from different pictures,
    /// and are about as exact as each other on the same people's neutral faces, see them in the same places.
    void smiles_are_seen_where_the_mesh_sees_them() {
        NEEDS_PORTRAITS();
        constexpr Limits most{0.45, 0.45, 0.60, 0.50, 1.00};
        auto own = FaceExtractor::create();
        auto mesh = FaceExtractor::create({"embedded", "mesh"});
        QVERIFY(own.ok() && mesh.ok());
        Limits sum{};
        const auto people = portraits::held_out();
        for (const auto& person : people) {
            const std::string number = person.photo.stem().string().substr(0, 3);
            const auto smiling = read_picture(person.photo.parent_path() / (number + "_08.jpg"));
            QVERIFY2(smiling.ok(), number.c_str());
            const Extraction ours = own->extract(*smiling), theirs = mesh->extract(*smiling);
            QVERIFY2(ours.faces.size() == 1 && theirs.faces.size() == 1, number.c_str());
            for (std::size_t f = 0; f < feature_count; ++f) {
                const double apart =
                    contour_error_percent(theirs.faces[0].contours, ours.faces[0].contours, felt_features[f])
                        .value();
                QVERIFY2(apart < 5.0, number.c_str());
                sum[f] += apart;
            }
        }
        for (std::size_t f = 0; f < feature_count; ++f) {
            const double mean = sum[f] / static_cast<double>(people.size());
            qInfo("  %-9s %.2f %% apart", felt_features[f], mean);
            QVERIFY2(mean <= most[f], felt_features[f]);
        }
    }
};

} // namespace accuracy_test

TP_TEST(accuracy_test, AccuracyTest, event_loop)
#include "accuracy_test.moc"
