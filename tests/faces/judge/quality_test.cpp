// SPDX-License-Identifier: Apache-2.0
#include "faces/evaluation/contour_error.hpp"
#include "faces/evaluation/degraded.hpp"
#include "faces/extract/face_extractor.hpp"
#include "faces/judge/face_problem.hpp"
#include "faces/judge/quality.hpp"
#include "portraits.hpp"
#include "test_program.hpp"

#include <QTest>

#include <algorithm>
#include <map>
#include <numeric>

namespace quality_test {

using namespace tp;

namespace {

/// Ranks, equal values sharing theirs.
std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> rank(values.size());
    for (std::size_t i = 0; i < order.size();) {
        std::size_t j = i;
        while (j < order.size() && values[order[j]] == values[order[i]])
            ++j;
        for (std::size_t k = i; k < j; ++k)
            rank[order[k]] = 0.5 * static_cast<double>(i + j - 1);
        i = j;
    }
    return rank;
}

/// Spearman's rank correlation.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double> x = ranks(a), y = ranks(b);
    const double mean = 0.5 * static_cast<double>(a.size() - 1);
    double xy = 0.0, xx = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (x[i] - mean) * (y[i] - mean);
        xx += (x[i] - mean) * (x[i] - mean);
        yy += (y[i] - mean) * (y[i] - mean);
    }
    return xy / std::sqrt(xx * yy);
}

struct Judged {
    std::vector<double> predicted, true_error;
};

/// A portrait made harder, and what was found in it.
struct Seen {
    std::string how;
    std::vector<Contour> truth;
    Extraction found;
};

/// Every second portrait of those held out, as it is and degraded: of people whom neither training nor
/// calibration saw.
std::vector<Seen> seen_by(FaceExtractor& faces) {
    std::vector<Seen> seen;
    const auto people = portraits::held_out();
    for (std::size_t i = 0; i < people.size(); i += 2)
        for (const Degraded& harder :
             degraded(*read_picture(people[i].photo), people[i].truth, static_cast<unsigned>(i)))
            seen.push_back({harder.how, harder.truth, faces.extract(harder.picture)});
    return seen;
}

const std::vector<Seen>& seen_by_the_embedded_model() {
    static const std::vector<Seen> seen = [] {
        FaceExtractor faces = std::move(FaceExtractor::create()).value();
        return seen_by(faces);
    }();
    return seen;
}

/// Signs of a sharp, frontal, large face that was placed twice in the same place.
QualitySigns good_signs() {
    QualitySigns signs;
    signs.unit_px = 200.0;
    signs.confidence = 0.99;
    signs.between_passes.fill(0.7);
    signs.between_nets.fill(1.0);
    for (EdgeReports::Pair* pair :
         {&signs.edges.right_eye, &signs.edges.left_eye, &signs.edges.outer_lip, &signs.edges.inner_lip})
        *pair = {{0.4, 0.6}, {0.4, 0.6}};
    return signs;
}

bool says(const ContourQuality& quality, const char* reason) {
    return std::find(quality.reasons.begin(), quality.reasons.end(), reason) != quality.reasons.end();
}

} // namespace

class QualityTest : public QObject {
    Q_OBJECT

private slots:
    void expected_error_follows_the_true_one_data() {
        QTest::addColumn<QString>("model");
        QTest::newRow("embedded") << "embedded";
        QTest::newRow("mesh") << "mesh";
    }
    void expected_error_follows_the_true_one() {
        NEEDS_PORTRAITS();
        QFETCH(QString, model);
        std::vector<Seen> by_another;
        if (model != "embedded") {
            FaceExtractor faces = std::move(FaceExtractor::create({"embedded", model.toStdString()})).value();
            by_another = seen_by(faces);
        }
        std::map<std::string, Judged> by_feature;
        Judged all;
        int lost = 0;
        for (const Seen& seen : model == "embedded" ? seen_by_the_embedded_model() : by_another) {
            if (seen.found.faces.empty()) {
                ++lost;
                continue;
            }
            const Face& face = seen.found.faces.front();
            QCOMPARE(face.quality.size(), face.contours.size());
            for (std::size_t c = 0; c < face.contours.size(); ++c) {
                const double error = *contour_error_percent(seen.truth, face.contours, face.contours[c].name);
                for (Judged* judged : {&by_feature[face.contours[c].name], &all}) {
                    judged->predicted.push_back(face.quality[c].expected_error_percent);
                    judged->true_error.push_back(error);
                }
            }
        }
        const auto tell = [](const char* name, const Judged& judged) {
            std::vector<std::size_t> order(judged.predicted.size());
            std::iota(order.begin(), order.end(), 0);
            std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
                return judged.predicted[a] < judged.predicted[b];
            });
            QString fifths;
            for (std::size_t f = 0; f < 5; ++f) {
                double predicted = 0.0, error = 0.0;
                const std::size_t begin = f * order.size() / 5, end = (f + 1) * order.size() / 5;
                for (std::size_t i = begin; i < end; ++i) {
                    predicted += judged.predicted[order[i]] / static_cast<double>(end - begin);
                    error += judged.true_error[order[i]] / static_cast<double>(end - begin);
                }
                fifths += QString(" %1/%2").arg(predicted, 0, 'f', 2).arg(error, 0, 'f', 2);
            }
            const double rho = rank_correlation(judged.predicted, judged.true_error);
            qInfo("%-9s rank correlation %.2f over %zu; expected/true %% by fifths:%s", name, rho,
                  judged.predicted.size(), qPrintable(fifths));
            return rho;
        };
        // Outlines are wrong by much the same in all portraits; of what a person's hair and jaw add, only a
        // strong step of colour beside the line tells something.
        const std::map<std::string, double> least{{feature::right_eye, 0.5},
                                                  {feature::left_eye, 0.5},
                                                  {feature::outer_lip, 0.55},
                                                  {feature::inner_lip, 0.6},
                                                  {feature::outline, 0.25}};
        std::map<std::string, double> correlation;
        for (const auto& [name, judged] : by_feature)
            correlation[name] = tell(name.c_str(), judged);
        QVERIFY(tell("all", all) >= 0.75);
        for (const auto& [name, bound] : least)
            QVERIFY2(correlation[name] >= bound, name.c_str());
        qInfo("%d degraded portraits in which no face was found", lost);
    }

    /// What the words say is what was done to the picture, and nothing is said about the portraits as they
    /// are.
    void reasons_are_told_by_what_is_seen() {
        NEEDS_PORTRAITS();
        std::map<std::string, std::map<std::string, int>> faces_with; // by degradation, by reason
        std::map<std::string, int> count;
        for (const Seen& seen : seen_by_the_embedded_model()) {
            if (seen.found.faces.empty())
                continue;
            ++count[seen.how];
            for (const char* reason : {"turned to the side", "too small", "blurred", "may be covered"})
                faces_with[seen.how][reason] +=
                    std::any_of(seen.found.faces[0].quality.begin(), seen.found.faces[0].quality.end(),
                                [&](const ContourQuality& q) { return says(q, reason); });
        }
        for (const auto& [how, faces_of] : count) {
            QString line;
            for (const auto& [reason, number] : faces_with[how])
                if (number > 0)
                    line += QString(" \"%1\" %2").arg(QString::fromStdString(reason)).arg(number);
            qInfo("%s: %d faces%s", how.c_str(), faces_of, qPrintable(line));
        }
        const auto part = [&](const char* how, const char* reason) {
            return static_cast<double>(faces_with[how][reason]) / std::max(count[how], 1);
        };
        for (const auto& [reason, number] : faces_with["as it is"])
            QVERIFY2(number == 0, reason.c_str());
        QVERIFY(part("turned 60 % rad", "turned to the side") >= 0.8);
        QVERIFY(part("eyes apart 18 px", "too small") == 1.0);
        QVERIFY(part("eyes apart 80 px", "too small") == 0.0);
        QVERIFY(part("blur 50 ‰", "blurred") >= 0.9);
        QVERIFY(part("eye covered like skin", "may be covered") >= 0.9);
        QVERIFY(part("mouth covered", "may be covered") >= 0.9);
    }

    void worse_signs_expect_larger_errors() {
        const QualitySigns good = good_signs();
        for (FeatureIndex f : {at_right_eye, at_left_eye, at_outer_lip, at_inner_lip}) {
            QualitySigns unclear = good;
            for (EdgeReports::Pair* pair : {&unclear.edges.right_eye, &unclear.edges.left_eye,
                                            &unclear.edges.outer_lip, &unclear.edges.inner_lip})
                *pair = {{1.0, 0.01}, {1.0, 0.01}};
            QVERIFY(quality_of(unclear, f).expected_error_percent >
                    quality_of(good, f).expected_error_percent);
        }
        QualitySigns unsteady = good;
        unsteady.between_passes.fill(5.0);
        unsteady.between_nets.fill(5.0);
        unsteady.confidence = 0.6;
        QVERIFY(quality_of(unsteady, at_outline).expected_error_percent >
                quality_of(good, at_outline).expected_error_percent);
    }
    void nothing_is_said_about_good_signs() {
        for (FeatureIndex f : {at_right_eye, at_left_eye, at_outer_lip, at_inner_lip, at_outline})
            QVERIFY(quality_of(good_signs(), f).reasons.empty());
    }
    void good_signs_are_sure_and_each_doubt_is_not() {
        QualitySigns good = good_signs();
        good.between_mirrors.fill(0.5);
        for (EdgeReports::Pair* pair : {&good.edges.inner_lip, &good.edges.right_eye, &good.edges.left_eye})
            *pair = {{0.4, 0.9}, {0.4, 0.9}};
        QVERIFY(is_sure(good));
        QualitySigns turned = good, unclear_eye = good, unclear_mouth = good, unconfirmed = good,
                     unsteady = good, small = good;
        turned.turn = 0.5;
        unclear_eye.edges.left_eye = {{0.4, 0.1}, {0.4, 0.1}};
        unclear_mouth.edges.inner_lip = {{0.4, 0.1}, {0.4, 0.1}};
        unconfirmed.confidence = 0.9;
        unsteady.between_passes.fill(5.0);
        unsteady.between_nets.fill(5.0);
        small.unit_px = 25.0;
        for (const QualitySigns& doubtful :
             {turned, unclear_eye, unclear_mouth, unconfirmed, unsteady, small})
            QVERIFY(!is_sure(doubtful));
        QVERIFY(!is_sure({}));
    }
    void strange_signs_are_safe() {
        QualitySigns signs;
        for (FeatureIndex f : {at_right_eye, at_outline})
            QVERIFY(quality_of(signs, f).expected_error_percent > 0.0);
        signs.turn = NAN;
        signs.between_passes.fill(INFINITY);
        for (FeatureIndex f : {at_right_eye, at_outline})
            QVERIFY(quality_of(signs, f).expected_error_percent <= 99.0);
        Landmarks one_place;
        for (auto* points : {&one_place.right_eye, &one_place.left_eye})
            points->assign(16, Vec2(3.0));
        for (auto* points : {&one_place.outer_lip, &one_place.inner_lip})
            points->assign(20, Vec2(3.0));
        one_place.outline.assign(33, Vec2(3.0));
        QCOMPARE(signs_of(one_place, {}, cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(9))).unit_px, 0.0);
    }
};

} // namespace quality_test

TP_TEST(quality_test, QualityTest, event_loop)
#include "quality_test.moc"
