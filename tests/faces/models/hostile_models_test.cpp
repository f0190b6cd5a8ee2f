// SPDX-License-Identifier: Apache-2.0
#include "byte_mutants.hpp"
#include "model_file_check.hpp"
#include "places.hpp"

#include <QTest>

using namespace tp::test;

namespace {

using Complaint = std::string (*)(std::string_view);

struct Kind {
    const char* name; ///< of its corpus
    Complaint complaint;
    int mutants;
};
constexpr Kind kinds[] = {{"onnx", complaint_about_onnx_file, 200},
                          {"haar", complaint_about_haar_file, 200},
                          {"lbf", complaint_about_lbf_file, 20}};

std::vector<Seed> files_of(const Kind& kind) {
    return corpus(in_source((std::string("tests/faces/models/") + kind.name + "_corpus").c_str()));
}

} // namespace

/// Files of models that do not come from us: whatever they hold, they are refused in a sentence or safe to
/// use.
class HostileModelsTest : public QObject {
    Q_OBJECT
private slots:
    void known_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("bytes");
        for (int i = 0; i < int(std::size(kinds)); ++i)
            for (const Seed& file : files_of(kinds[i]))
                QTest::addRow("%s", file.name.c_str()) << i << QByteArray::fromStdString(file.text);
    }
    void known() {
        QFETCH(int, kind);
        QFETCH(QByteArray, bytes);
        QCOMPARE(kinds[kind].complaint(bytes.toStdString()), std::string());
    }

    /// Else the fuzzers would only search what is refused.
    void the_smallest_of_each_kind_are_taken_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("file");
        QTest::newRow("mesh") << 0 << "mesh.onnx";
        QTest::newRow("yunet") << 0 << "yunet.onnx";
        QTest::newRow("haar") << 1 << "squares.xml";
        QTest::newRow("lbf") << 2 << "facemark.yaml";
        QTest::newRow("lbf, packed") << 2 << "packed.yaml";
    }
    void the_smallest_of_each_kind_are_taken() {
        QFETCH(int, kind);
        QFETCH(QString, file);
        for (const Seed& seed : files_of(kinds[kind]))
            if (seed.name == file.toStdString()) {
                QCOMPARE(kinds[kind].complaint(seed.text), std::string());
                QVERIFY(last_was_taken());
                return;
            }
        QFAIL("It is not in the corpus.");
    }
    void nets_of_another_shape_are_refused() {
        for (const Seed& seed : files_of(kinds[0]))
            if (seed.name.find("_of_") != std::string::npos) {
                QCOMPARE(complaint_about_onnx_file(seed.text), std::string());
                QVERIFY2(!last_was_taken(), seed.name.c_str());
            }
    }

    void damaged_ones_data() {
        QTest::addColumn<int>("kind");
        for (int i = 0; i < int(std::size(kinds)); ++i)
            QTest::newRow(kinds[i].name) << i;
    }
    void damaged_ones() {
        QFETCH(int, kind);
        const std::vector<Seed> seeds = files_of(kinds[kind]);
        ByteMutator mutator(7);
        for (int i = 0; i < kinds[kind].mutants; ++i) {
            const std::string complaint = kinds[kind].complaint(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(HostileModelsTest)
#include "hostile_models_test.moc"
