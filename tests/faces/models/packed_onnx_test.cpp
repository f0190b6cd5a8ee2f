// SPDX-License-Identifier: Apache-2.0
#include "faces/models/model_catalog.hpp"
#include "faces/models/packed_onnx.hpp"
#include "places.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

using namespace tp;

namespace {

std::string number(std::uint32_t value) { return {std::bit_cast<std::array<char, 4>>(value).data(), 4}; }
std::string number(float value) { return number(std::bit_cast<std::uint32_t>(value)); }

/// Two rows of three bytes between plain ones.
std::string small() {
    return "TPONNX8\n" + number(32U) + number(5U) + "begin" + number(2U) + number(3U) + number(0.5F) +
           number(-1.0F) + number(2.0F) + number(10.0F) + std::string("\x00\x01\xff\x00\x02\x80", 6) +
           number(3U) + "end";
}

std::vector<float> floats_in(const std::vector<char>& bytes, std::size_t at, std::size_t count) {
    std::vector<float> values(count);
    std::memcpy(values.data(), bytes.data() + at, count * sizeof(float));
    return values;
}

} // namespace

class PackedOnnxTest : public QObject {
    Q_OBJECT

private slots:
    void bytes_become_the_floats_that_they_stand_for() {
        const auto model = unpacked_onnx(small());
        QVERIFY(model);
        QCOMPARE(model->size(), std::size_t{5 + 6 * 4 + 3});
        QCOMPARE(std::string(model->begin(), model->begin() + 5), std::string("begin"));
        QCOMPARE(floats_in(*model, 5, 6), (std::vector<float>{-1.0F, -0.5F, 126.5F, 10.0F, 14.0F, 266.0F}));
        QCOMPARE(std::string(model->end() - 3, model->end()), std::string("end"));
    }
    void a_model_of_plain_bytes_alone() {
        QCOMPARE(unpacked_onnx("TPONNX8\n" + number(2U) + number(2U) + "ok")->size(), std::size_t{2});
        QCOMPARE(unpacked_onnx("TPONNX8\n" + number(0U) + number(0U))->size(), std::size_t{0});
    }
    void rows_without_columns_are_no_numbers() {
        const std::string empty =
            "TPONNX8\n" + number(1U) + number(0U) + number(1U) + number(0U) + number(1.0F) + number(1.0F);
        QCOMPARE(unpacked_onnx(empty + number(1U) + "x")->size(), std::size_t{1});
    }
    void what_is_cut_short_is_nothing() {
        const std::string whole = small();
        for (std::size_t length = 0; length < whole.size(); ++length)
            QVERIFY2(!unpacked_onnx(whole.substr(0, length)), std::to_string(length).c_str());
    }
    void sizes_that_do_not_hold_are_nothing() {
        QVERIFY(!unpacked_onnx("TPONNX8\n" + number(4U) + number(0xffffffffU) + "x"));
        QVERIFY(!unpacked_onnx("TPONNX8\n" + number(4U) + number(0U) + number(0xffffffffU) +
                               number(0xffffffffU) + "x"));
        QVERIFY(!unpacked_onnx("TPONNX8\n" + number(1U) + number(2U) + "ok"));
        QVERIFY(!unpacked_onnx("\x08\x06 an ONNX file as it is"));
    }

    /// The same 128 numbers as the net with floats of which the packed one was made.
    void the_net_inside_answers_as_the_one_of_floats() {
        const std::filesystem::path floats(tp::test::in_shared("faces/descriptor/face_descriptor.onnx"));
        if (!std::filesystem::exists(floats))
            QSKIP("needs ../shared/faces/descriptor: the net of floats is not part of the repository");
        cv::dnn::Net ours = embedded_net(EmbeddedModel::descriptor),
                     theirs = cv::dnn::readNet(floats.string());
        cv::RNG random(7);
        for (int i = 0; i < 3; ++i) {
            cv::Mat blobs(4, std::array{1, 3, 150, 150}.data(), CV_32F);
            random.fill(blobs, cv::RNG::UNIFORM, 0.0, 255.0);
            ours.setInput(blobs);
            theirs.setInput(blobs);
            const cv::Mat mine = ours.forward(), other = theirs.forward();
            QCOMPARE(mine.total(), std::size_t{128});
            QVERIFY(cv::norm(mine, other, cv::NORM_INF) < 1e-4);
            QVERIFY(cv::norm(mine) > 0.5);
        }
    }
};

QTEST_GUILESS_MAIN(PackedOnnxTest)
#include "packed_onnx_test.moc"
