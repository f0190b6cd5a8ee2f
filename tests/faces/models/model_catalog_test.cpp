// SPDX-License-Identifier: Apache-2.0
#include "faces/extract/face_extractor.hpp"
#include "faces/models/model_catalog.hpp"
#include "places.hpp"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace tp;
namespace fs = std::filesystem;
using Role = PluggableModel::Role;

namespace {

std::string error_of(const ExtractorChoice& choice) { return FaceExtractor::create(choice).error(); }

} // namespace

class ModelCatalogTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    fs::path touched(const char* name, const std::string& content = "not a net") const {
        const fs::path file = fs::path(folder_.path().toStdString()) / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file) << content;
        return file;
    }

private slots:
    void init() {
        qunsetenv("TOUCHPHOTO_MODELS");
        qputenv("XDG_DATA_HOME", (folder_.path() + "/data").toUtf8());
    }

    void embedded_needs_no_file() {
        const auto extractor = FaceExtractor::create();
        QVERIFY2(extractor.ok(), extractor.error().c_str());
    }
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
    void each_known_file_is_described() {
        for (const PluggableModel* model : pluggable_models) {
            if (model == &lbf_model) // unknown, and so it is not fetched from anywhere
                QVERIFY(!*model->sha256 && !*model->address);
            else
                QCOMPARE(std::string(model->sha256).size(), std::size_t(64));
            QVERIFY(model->bytes > 0 && *model->licence);
            QVERIFY(std::string(model->origin).ends_with('.'));
            const std::string address = model->address;
            QVERIFY(address.empty() || address.starts_with("https://"));
            QCOMPARE(installed_file(*model).has_value(), fs::exists(model->of_system));
        }
    }
    void names_are_looked_up_in_the_users_folders() {
        const fs::path shared = touched("data/touchphoto/models/yunet.onnx");
        QCOMPARE(find_model("yunet", Role::detector)->file, shared);
        const fs::path own = touched("mine/yunet.onnx");
        qputenv("TOUCHPHOTO_MODELS", (folder_.path() + "/mine").toUtf8());
        QCOMPARE(find_model("yunet", Role::detector)->file, own);
        fs::remove(own);
        QCOMPARE(find_model("yunet", Role::detector)->file, shared);
        fs::remove(shared);
        QVERIFY(find_model("yunet", Role::detector)->file.empty()); // the one inside the program
        const std::string error = find_model("lbf", Role::landmarks).error();
        QVERIFY2(error.find("not installed") != std::string::npos, error.c_str());
        QVERIFY2(error.find("mine") != std::string::npos, error.c_str());
    }
    void embedded_models_of_others_can_be_chosen_by_name() {
        QCOMPARE(error_of({"yunet", "mesh"}), std::string());
        QCOMPARE(find_model("mesh", Role::landmarks)->kind, &mesh_model);
        const fs::path folder = tp::test::in_source("resources/models");
        for (const PluggableModel* model : {&yunet_model, &mesh_model})
            QCOMPARE(static_cast<std::uintmax_t>(model->bytes),
                     fs::file_size(folder / (model->name + std::string(".onnx"))));
    }
    void paths_are_taken_as_they_are() {
        const fs::path file = touched("some.onnx");
        QCOMPARE(find_model(file.string(), Role::detector)->file, file);
    }
    void the_ending_of_a_path_says_of_which_kind_it_is() {
        const auto kind = [](const fs::path& file, Role role) {
            return find_model(file.string(), role)->kind;
        };
        QCOMPARE(kind(touched("some.onnx"), Role::landmarks), &mesh_model);
        QCOMPARE(kind(touched("some.yaml"), Role::landmarks), &lbf_model);
        QCOMPARE(kind(touched("some.model"), Role::landmarks), &mesh_model);
        QCOMPARE(kind(touched("some.yaml"), Role::detector), &yunet_model);
        QCOMPARE(kind(touched("some.xml"), Role::detector), &haar_model);
    }
    void wrong_choices_are_sentences_data() {
        QTest::addColumn<QString>("choice");
        QTest::addColumn<QString>("says");
        QTest::newRow("unknown name") << "magic"
                                      << "There is no model named \"magic\"";
        QTest::newRow("no name") << ""
                                 << "There is no model named \"\"";
        QTest::newRow("missing file") << "/nowhere/net.onnx"
                                      << "There is no model file";
        QTest::newRow("folder") << folder_.path() << "There is no model file";
        QTest::newRow("not ONNX") << QString::fromStdString(touched("text.onnx").string()) << "can be used";
        QTest::newRow("empty file") << QString::fromStdString(touched("empty.onnx", "").string())
                                    << "can be used";
        QTest::newRow("not XML") << QString::fromStdString(touched("text.xml").string()) << "can be used";
        QTest::newRow("not YAML") << QString::fromStdString(touched("text.yaml").string()) << "can be used";
        QTest::newRow("another net") << QString(tp::test::in_source("resources/models/eye.onnx"))
                                     << "can be used";
    }
    void wrong_choices_are_sentences() {
        QFETCH(QString, choice);
        QFETCH(QString, says);
        for (const std::string& error :
             {error_of({choice.toStdString(), "embedded"}), error_of({"embedded", choice.toStdString()})})
            QVERIFY2(QString::fromStdString(error).contains(says), error.c_str());
    }
};

QTEST_GUILESS_MAIN(ModelCatalogTest)
#include "model_catalog_test.moc"
