// SPDX-License-Identifier: Apache-2.0
#include "faces/extract/face_extractor.hpp"
#include "faces/models/model_catalog.hpp"
#include "places.hpp"

#include <QTest>

#include <cstdint>
#include <filesystem>
#include <string>

using namespace tp;
namespace fs = std::filesystem;

namespace {

std::string error_of(const ExtractorChoice& choice) { return FaceExtractor::create(choice).error(); }

} // namespace

class ModelCatalogTest : public QObject {
    Q_OBJECT
private slots:
    void embedded_nets_are_listed_with_their_size() {
        std::size_t bytes = 0, files = 0;
        for (const auto& entry : fs::directory_iterator(tp::test::in_source("resources/models")))
            files += entry.path().extension() == ".onnx" || entry.path().extension() == ".packed";
        QCOMPARE(embedded_models().size(), files);
        for (const EmbeddedModelFacts& model : embedded_models()) {
            const bool describes = std::string(model.name) == "descriptor";
            const fs::path file = fs::path(tp::test::in_source("resources/models")) /
                                  (model.name + std::string(describes ? ".packed" : ".onnx"));
            QCOMPARE(static_cast<std::uintmax_t>(model.bytes), fs::file_size(file));
            QVERIFY(*model.purpose && *model.licence);
            if (describes)
                QVERIFY(model.bytes <= 6'500'000);
            else
                bytes += model.bytes; // of those that find contours
        }
        QVERIFY(bytes <= 14U << 20);
    }

    void each_choice_loads_and_gives_what_is_expected_data() {
        QTest::addColumn<QString>("detector");
        QTest::addColumn<QString>("model");
        QTest::newRow("ours") << "embedded"
                              << "embedded";
        QTest::newRow("YuNet") << "yunet"
                               << "embedded";
        QTest::newRow("the mesh") << "embedded"
                                  << "mesh";
        QTest::newRow("both") << "yunet"
                              << "mesh";
    }
    void each_choice_loads_and_gives_what_is_expected() {
        QFETCH(QString, detector);
        QFETCH(QString, model);
        auto extractor = FaceExtractor::create({detector.toStdString(), model.toStdString()});
        QVERIFY2(extractor.ok(), extractor.error().c_str());
        QCOMPARE(extractor->problem(), std::string());
    }

    void other_choices_are_sentences_data() {
        QTest::addColumn<QString>("choice");
        QTest::newRow("unknown name") << "magic";
        QTest::newRow("no name") << "";
        QTest::newRow("a file that is a net") << QString(tp::test::in_source("resources/models/mesh.onnx"));
        QTest::newRow("a missing file") << "/nowhere/net.onnx";
    }
    /// The names alone are told: no file is looked for.
    void other_choices_are_sentences() {
        QFETCH(QString, choice);
        const std::string name = choice.toStdString();
        QCOMPARE(error_of({name, "embedded"}),
                 "There is no detector named \"" + name + "\": choose \"embedded\" or \"yunet\".");
        QCOMPARE(error_of({"embedded", name}),
                 "There is no model named \"" + name + "\": choose \"embedded\" or \"mesh\".");
    }
    void a_detector_is_no_model() {
        QVERIFY(!error_of({"mesh", "embedded"}).empty());
        QVERIFY(!error_of({"embedded", "yunet"}).empty());
    }
};

QTEST_GUILESS_MAIN(ModelCatalogTest)
#include "model_catalog_test.moc"
