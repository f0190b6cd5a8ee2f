// SPDX-License-Identifier: Apache-2.0
// A camera that lies of its frames: planes that are shorter than told, JPEGs larger than a camera may send. What is told is a
// picture or none, and nobody reads behind a plane's end.
#include "app/capture/camera/camera_format.hpp"
#include "app/capture/camera/frame_pixels.hpp"
#include "byte_mutants.hpp"
#include "frame_check.hpp"
#include "places.hpp"

#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace tp;
using namespace tp::test;
using Form = QVideoFrameFormat;

Q_DECLARE_METATYPE(QVideoFrameFormat::PixelFormat)

namespace {

constexpr QSize small(16, 8);

/// What is told and what is there; nothing is held back but what a test takes away.
struct Frame {
    Form::PixelFormat form;
    QSize size;
    std::vector<std::vector<unsigned char>> memory;
    std::vector<long long> steps;

    Frame(Form::PixelFormat told_form, QSize told_size) : form(told_form), size(told_size) {
        for (const PlaneNeeds& plane : needs_of(form, size)) {
            memory.emplace_back(static_cast<std::size_t>(plane.row_bytes * plane.rows), 128);
            steps.push_back(plane.row_bytes);
        }
    }
    /// A JPEG.
    Frame(std::vector<unsigned char> jpeg, QSize told_size)
        : form(Form::Format_Jpeg), size(told_size), memory{std::move(jpeg)}, steps{0} {}

    cv::Mat pixels() const {
        MappedPicture picture{form, size, {}};
        for (std::size_t i = 0; i < memory.size(); ++i)
            picture.planes.push_back({memory[i], steps[i]});
        return bgr_of(picture);
    }
    bool is_shown() const { return pixels().size() == cv::Size(size.width(), size.height()); }
    bool is_refused() const { return pixels().empty(); }
};

std::vector<unsigned char> jpeg_of(int width, int height) {
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", cv::Mat(height, width, CV_8UC3, cv::Scalar(40, 120, 200)), bytes);
    return bytes;
}

/// Remembers the largest matrix that is made.
class LargestMatrix final : public cv::MatAllocator {
public:
    LargestMatrix() { cv::Mat::setDefaultAllocator(this); }
    ~LargestMatrix() override { cv::Mat::setDefaultAllocator(cv::Mat::getStdAllocator()); }
    std::size_t bytes() const { return bytes_; }

    cv::UMatData* allocate(int dimensions, const int* sizes, int type, void* data, std::size_t* step,
                           cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
        cv::UMatData* const made =
            cv::Mat::getStdAllocator()->allocate(dimensions, sizes, type, data, step, flags, usage);
        bytes_ = std::max(bytes_, made->size);
        return made;
    }
    bool allocate(cv::UMatData* data, cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
        return cv::Mat::getStdAllocator()->allocate(data, flags, usage);
    }
    void deallocate(cv::UMatData* data) const override { cv::Mat::getStdAllocator()->deallocate(data); }

private:
    mutable std::size_t bytes_ = 0;
};

} // namespace

class HostileFramesTest : public QObject {
    Q_OBJECT

private slots:
    void planes_hold_what_is_told_data() {
        QTest::addColumn<Form::PixelFormat>("form");
        for (const Form::PixelFormat form : told_forms)
            if (!needs_of(form, small).empty())
                QTest::newRow(qPrintable(Form::pixelFormatToString(form))) << form;
    }
    void planes_hold_what_is_told() {
        QFETCH(Form::PixelFormat, form);
        const Frame whole(form, small);
        QVERIFY(whole.is_shown());
        for (std::size_t plane = 0; plane < whole.memory.size(); ++plane) {
            Frame frame = whole;
            frame.memory[plane].pop_back();
            QVERIFY2(frame.is_refused(), "a byte too short");
            frame = whole;
            frame.memory[plane].clear();
            QVERIFY2(frame.is_refused(), "nothing there");
            for (const long long step :
                 {whole.steps[plane] - 1, whole.steps[plane] + 1, 0LL, -whole.steps[plane],
                  static_cast<long long>(std::numeric_limits<int>::max()),
                  std::numeric_limits<long long>::max()}) {
                frame = whole;
                frame.steps[plane] = step;
                QVERIFY2(frame.is_refused(), std::to_string(step).c_str());
            }
            frame = whole;
            frame.steps[plane] += 3; // as much as all rows but the last one need
            const std::size_t rows = static_cast<std::size_t>(needs_of(form, small)[plane].rows);
            frame.memory[plane].resize(frame.memory[plane].size() + 3 * (rows - 1));
            QVERIFY2(frame.is_shown(), "rows with a gap between them");
        }
        Frame frame = whole;
        frame.memory.pop_back();
        QVERIFY2(frame.is_refused(), "a plane too few");
    }

    void sides_that_a_form_cannot_have() {
        for (const Form::PixelFormat form : {Form::Format_YUYV, Form::Format_UYVY, Form::Format_NV12,
                                             Form::Format_NV21, Form::Format_YUV420P, Form::Format_YV12})
            QVERIFY(Frame(form, {15, 8}).is_refused());
        for (const Form::PixelFormat form :
             {Form::Format_NV12, Form::Format_NV21, Form::Format_YUV420P, Form::Format_YV12})
            QVERIFY(Frame(form, {16, 7}).is_refused());
        QVERIFY(Frame(Form::Format_YUYV, {16, 7}).is_shown());
        QVERIFY(Frame(Form::Format_Y8, {15, 7}).is_shown());
        // Qt divides by half the height of such a frame.
        QVERIFY(upright_pixels(QVideoFrame(Form(QSize(16, 1), Form::Format_YUV420P))).empty());
        for (const QSize none : {QSize(0, 8), QSize(16, 0), QSize(-16, -8)})
            QVERIFY(!can_be_read(Form::Format_Y8, none));
    }

    void no_frame_is_larger_than_a_camera_s() {
        QVERIFY(can_be_read(Form::Format_Y8, {most_pixels, 1}));
        QVERIFY(!can_be_read(Form::Format_Y8, {most_pixels + 1, 1}));
        QVERIFY(!can_be_read(Form::Format_Y8, {1 << 30, 1 << 30}));
        const int side = 3600; // 12.96 megapixels
        QVERIFY(Frame(Form::Format_Y8, {side, side}).is_refused());
        QVERIFY(Frame(jpeg_of(side, side), {side, side}).is_refused());
        QVERIFY(upright_pixels(QVideoFrame(Form(QSize(side, side), Form::Format_Y8))).empty());
    }

    void a_jpeg_has_its_own_size_whatever_is_told() {
        QVERIFY(Frame(jpeg_of(64, 48), {64, 48}).is_shown());
        for (const QSize told : {QSize(64, 47), QSize(63, 48), QSize(48, 64), QSize(640, 480)})
            QCOMPARE(Frame(jpeg_of(64, 48), told).pixels().size(), cv::Size(64, 48));
    }

    void a_jpeg_that_is_larger_than_a_cameras_may_be_is_not_decoded() {
        const Frame frame(jpeg_of(4100, 3100), {64, 48});
        const LargestMatrix largest;
        QVERIFY(frame.is_refused());
        QVERIFY2(largest.bytes() <= 3 * 64 * 48, std::to_string(largest.bytes()).c_str());
    }

    void a_jpeg_that_lost_bytes_on_its_way_is_shown_as_far_as_it_goes() {
        std::vector<unsigned char> jpeg = jpeg_of(640, 480);
        jpeg.resize(jpeg.size() * 3 / 4);
        const cv::Mat pixels = Frame(jpeg, {640, 480}).pixels();
        QCOMPARE(pixels.size(), cv::Size(640, 480));
        QVERIFY(cv::norm(pixels.at<cv::Vec3b>(5, 5), cv::Vec3b(40, 120, 200)) < 12.0);
        jpeg.resize(100); // in its tables
        QVERIFY(Frame(jpeg, {640, 480}).is_refused());
        QVERIFY(Frame(std::vector<unsigned char>(), {640, 480}).is_refused());
    }

    void frames_of_a_corpus() {
        const std::vector<Seed> seeds = corpus(in_source("tests/app/capture/camera/frame_corpus"));
        QVERIFY(seeds.size() >= 15);
        for (const Seed& seed : seeds)
            QVERIFY2(complaint_about_frame(seed.text).empty(), seed.name.c_str());
        ByteMutator mutator(1);
        for (int i = 0; i < 3000; ++i) {
            const std::string complaint = complaint_about_frame(mutator.mutant(seeds));
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
    }

    /// What of the corpus is a picture is told by its names; a JPEG without tables is what many cameras send.
    void what_is_shown_of_the_corpus_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("shown");
        QTest::newRow("as it is told") << "jpeg" << true;
        QTest::newRow("without Huffman tables") << "jpeg_without_tables" << true;
        QTest::newRow("601 scans") << "jpeg_of_601_scans" << false;
        QTest::newRow("filled up to whole blocks") << "jpeg_of_whole_blocks" << true;
        QTest::newRow("of 48 megapixels") << "jpeg_of_48_megapixels" << false;
        QTest::newRow("two sizes in one") << "jpeg_of_two_sizes" << false;
        QTest::newRow("no picture") << "jpeg_that_is_a_png" << false;
    }
    void what_is_shown_of_the_corpus() {
        QFETCH(QString, name);
        QFETCH(bool, shown);
        for (const Seed& seed : corpus(in_source("tests/app/capture/camera/frame_corpus")))
            if (seed.name == name.toStdString()) {
                QCOMPARE(is_shown_by(seed.text), shown);
                return;
            }
        QFAIL("there is no such frame");
    }

private:
    static bool is_shown_by(const std::string& bytes) {
        constexpr std::size_t head = 13;
        const auto number = [&](std::size_t at) {
            return static_cast<unsigned char>(bytes[at]) + 256 * static_cast<unsigned char>(bytes[at + 1]);
        };
        return !Frame(std::vector<unsigned char>(bytes.begin() + head, bytes.end()), {number(1), number(3)})
                    .is_refused();
    }
};

QTEST_GUILESS_MAIN(HostileFramesTest)
#include "hostile_frames_test.moc"
