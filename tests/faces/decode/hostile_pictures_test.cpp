// SPDX-License-Identifier: Apache-2.0
#include "faces/decode/picture.hpp"
#include "picture_check.hpp"
#include "places.hpp"
#include "svg_mutants.hpp"
#include "test_program.hpp"

#include <QTest>

namespace hostile_pictures_test {

using namespace tp::test;

namespace {

constexpr int mutated_inputs = 400;

std::vector<Seed> pictures() { return corpus(tp::test::in_source("tests/faces/decode/corpus")); }

/// A few bytes changed, lost, doubled, or the end cut off.
std::string damaged(std::string bytes, std::mt19937_64& random) {
    for (std::uint64_t i = 1 + random() % 4; i > 0 && !bytes.empty(); --i) {
        const std::size_t at = random() % bytes.size();
        switch (random() % 5) {
        case 0:
            bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes[at % std::min<std::size_t>(bytes.size(), 64)] = static_cast<char>(random());
            break;
        case 2:
            bytes.erase(at, 1 + random() % 8);
            break;
        case 3:
            bytes.insert(at, bytes.substr(at, random() % 16));
            break;
        default:
            if (random() % 8 == 0)
                bytes.resize(at);
        }
    }
    return bytes;
}

} // namespace

class HostilePicturesTest : public QObject {
    Q_OBJECT
private slots:
    void known_data() {
        QTest::addColumn<QByteArray>("bytes");
        for (const Seed& input : pictures())
            QTest::newRow(input.name.c_str()) << QByteArray::fromStdString(input.text);
    }
    void known() {
        QFETCH(QByteArray, bytes);
        QCOMPARE(complaint_about_picture(bytes.toStdString()), std::string());
    }

    void turned_ones_data() {
        QTest::addColumn<int>("degrees");
        for (const int degrees : {0, 90, 180, 270})
            QTest::addRow("%d", degrees) << degrees;
    }
    void turned_ones() {
        QFETCH(int, degrees);
        const cv::Mat upright = tp::read_picture(tp::test::in_source("resources/samples/anna_smiling.jpg")).value();
        QVERIFY(upright.cols != upright.rows);
        QCOMPARE(complaint_about_search_in(tp::turned(upright, degrees)), std::string());
    }

    void damaged_ones() {
        const std::vector<Seed> seeds = pictures();
        QVERIFY(seeds.size() >= 10);
        std::mt19937_64 random(3);
        int decoded = 0;
        for (int i = 0; i < mutated_inputs; ++i) {
            const Seed& seed = seeds[random() % seeds.size()];
            const std::string bytes = damaged(seed.text, random);
            const std::string complaint = complaint_about_picture(bytes);
            QVERIFY2(complaint.empty(), (complaint + " in " + seed.name).c_str());
            decoded += tp::decode_picture(tp::Bytes(bytes.begin(), bytes.end())).ok() ? 1 : 0;
        }
        QVERIFY2(decoded > mutated_inputs / 20, qPrintable(QString::number(decoded)));
    }
};

} // namespace hostile_pictures_test

TP_TEST(hostile_pictures_test, HostilePicturesTest, nothing)
#include "hostile_pictures_test.moc"
