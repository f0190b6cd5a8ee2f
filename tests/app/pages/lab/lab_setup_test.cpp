// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_setup.hpp"
#include "app/pages/lab/sample_scenes.hpp"
#include "corpus.hpp"
#include "lab_setup_check.hpp"
#include "places.hpp"
#include "test_program.hpp"

#include <QTest>

#include <random>
#include <set>

namespace lab_setup_test {

using namespace tp;

class LabSetupTest : public QObject {
    Q_OBJECT
private slots:
    void every_parameter_is_written_and_read_to_the_last_bit() {
        std::mt19937 random(1);
        for (int i = 0; i < 50; ++i) {
            LabSetup setup;
            setup.parameters.law = i % 2 == 0 ? LawKind::exact : LawKind::published;
            for (const LabNumber& number : lab_numbers())
                setup.parameters.*number.member =
                    std::uniform_real_distribution<double>(number.lowest, number.highest)(random);
            for (const LabSwitch& one : lab_switches())
                setup.parameters.*one.member = random() % 2 == 0;
            setup.real_device = i % 3 == 0;
            setup.scene_name = "Ömas \"Bild\"";
            setup.scene = flatten(sample_scene(static_cast<LabShape>(i % 3), 220.0, 160.0));
            const Result<LabSetup> read = parse_setup(setup_json(setup));
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().c_str());
            QVERIFY(read->parameters == setup.parameters);
            QCOMPARE(read->real_device, setup.real_device);
            QCOMPARE(read->scene_name, setup.scene_name);
            QVERIFY(read->scene.names == setup.scene.names);
            QVERIFY(read->scene.lines.front().points == setup.scene.lines.front().points);
            QCOMPARE(read->scene.lines.front().closed, setup.scene.lines.front().closed);
        }
    }

    void every_key_is_there_once_and_its_default_lies_within_its_bounds() {
        std::set<std::string> keys;
        const LabParameters fresh;
        for (const LabNumber& number : lab_numbers()) {
            QVERIFY2(keys.insert(number.key).second, number.key);
            QVERIFY2(fresh.*number.member >= number.lowest && fresh.*number.member <= number.highest, number.key);
            QVERIFY(lab_number(number.key) == &number);
        }
        for (const LabSwitch& one : lab_switches())
            QVERIFY2(keys.insert(one.key).second, one.key);
        QVERIFY(lab_number("cornerCue") == nullptr && lab_switch("stiffness") == nullptr);
    }

    void what_is_out_of_bounds_or_no_setup_is_refused_with_a_reason() {
        const auto error = [](const char* parameters) {
            const auto read = parse_setup(std::string(R"({"format":"TouchPhotoLab 1","parameters":{)") + parameters + "}}");
            return read.ok() ? std::string() : read.error();
        };
        QCOMPARE(error(""), std::string());
        QCOMPARE(error(R"("stiffness":0.6)"), std::string("stiffness is not between 0.1 and 0.5."));
        QCOMPARE(error(R"("mass":"heavy")"), std::string("mass is not between 0.02 and 0.5."));
        QCOMPARE(error(R"("law":"cubic")"), std::string("it names a law that is unknown."));
        QVERIFY(!parse_setup("").ok());
        QVERIFY(!parse_setup("{}").ok());
        QVERIFY(!parse_setup(R"({"format":"TouchPhotoLab 1","scene":[{"points_mm":[[0]]}]})").ok());
        QVERIFY(!parse_setup(R"({"format":"TouchPhotoLab 1","scene":[{"points_mm":[[0,1e9]]}]})").ok());
    }

    void the_corpus_and_its_broken_copies_hold_what_the_fuzzer_asks() {
        const auto seeds = tp::test::corpus(tp::test::in_source("tests/app/pages/lab/corpus"));
        QVERIFY(seeds.size() >= 4);
        std::mt19937 random(7);
        for (const test::Seed& seed : seeds) {
            QCOMPARE(test::complaint_about_setup(seed.text), std::string());
            for (int i = 0; i < 300; ++i) {
                std::string broken = seed.text;
                for (unsigned k = 0; k < 1 + random() % 3; ++k)
                    broken[random() % broken.size()] = static_cast<char>(32 + random() % 95);
                QCOMPARE(test::complaint_about_setup(broken), std::string());
            }
        }
    }

    void the_published_law_has_its_vertices_and_no_softened_switches() {
        LabParameters parameters;
        parameters.law = LawKind::published;
        parameters.hold = 0.5;
        parameters.corner_cue = true;
        const FlatScene flat = flatten(sample_scene(LabShape::triangle, 220.0, 160.0));
        parameters.vertex_spacing = 10.0;
        const auto coarse = felt_scene(flat, parameters);
        parameters.vertex_spacing = 0.5;
        const auto fine = felt_scene(flat, parameters);
        QVERIFY(coarse.ok() && fine.ok());
        QVERIFY((*fine)->flat.lines[0].points.size() > 10 * (*coarse)->flat.lines[0].points.size());
        QCOMPARE((*fine)->hold_mm, 0.0);
    }

    void hysteresis_and_blending_together_or_no_line_at_all_are_refused() {
        LabParameters parameters;
        parameters.hold = parameters.blend = 0.5;
        QVERIFY(!felt_scene(flatten(sample_scene(LabShape::circle, 220.0, 160.0)), parameters).ok());
        QVERIFY(!felt_scene({}, {}).ok());
    }

    void the_shapes_are_those_of_the_study() {
        const FlatScene circle = flatten(sample_scene(LabShape::circle, 220.0, 160.0));
        QVERIFY(circle.lines[0].points.size() > 30);
        for (const Vec2 p : circle.lines[0].points)
            QVERIFY(std::abs(length(p) - 40.0) < 0.02);
        const std::vector<Vec2> triangle = flatten(sample_scene(LabShape::triangle, 220.0, 160.0)).lines[0].points;
        const double side = 50.0 * 2.0 / std::sqrt(3.0);
        QCOMPARE(triangle.size(), std::size_t{3});
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::abs(length(triangle[i] - triangle[(i + 1) % 3]) - side) < 1e-9);
        const Rect curve = bounds_of(flatten(sample_scene(LabShape::curve, 220.0, 160.0)).lines[0].points);
        QVERIFY(std::abs(curve.width() - 200.0) < 1e-9);
        QVERIFY(curve.height() > 40.0 && curve.height() < 140.0);
    }

    void a_real_device_keeps_the_limits_of_a_real_device() {
        const SafetyLimits product;
        QCOMPARE(servo_settings({}, 1000.0, true).limits.stall, product.stall);
        QCOMPARE(servo_settings({}, 1000.0, true).limits.late_periods, product.late_periods);
        QVERIFY(servo_settings({}, 1000.0, false).limits.stall > product.stall);
        LabParameters strict;
        strict.strict_limits = true;
        QCOMPARE(servo_settings(strict, 1000.0, false).limits.stale_after, product.stale_after);
    }
};

} // namespace lab_setup_test

TP_TEST(lab_setup_test, LabSetupTest, event_loop)
#include "lab_setup_test.moc"
