// SPDX-License-Identifier: Apache-2.0
// What touchphoto-decoder decodes, against the same files decoded in this process.
#include "core/processes/foreign_decoder.hpp"
#include "core/processes/shared_memory.hpp"
#include "faces/decode/foreign_picture.hpp"
#include "faces/decode/picture.hpp"
#include "faces/decode/picture_messages.hpp"
#include "made_pictures.hpp"
#include "places.hpp"

#include <QTest>
#include <QVector>

#include <opencv2/imgcodecs.hpp>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

using namespace tp;
using tp::test::gradient;
using tp::test::largest_difference;
namespace fs = std::filesystem;

namespace {

std::string decoder_program() { return qEnvironmentVariable("TP_DECODER").toStdString(); }

/// While one lives, this program decodes in helpers.
class InHelpers {
public:
    explicit InHelpers(ForeignDecoders& decoders) { decode_in_helpers(&decoders); }
    ~InHelpers() { decode_in_helpers(nullptr); }
    InHelpers(const InHelpers&) = delete;
    InHelpers& operator=(const InHelpers&) = delete;
};

/// Larger than what is handed over in a message.
cv::Mat large() { return gradient(800, 600); }

} // namespace

class ForeignPictureTest : public QObject {
    Q_OBJECT

    test::MadePictures made_;
    ForeignDecoders decoders_{decoder_program()};

    fs::path written(const std::string& name, const cv::Mat& picture) const {
        cv::imwrite(made_.path(name).string(), picture);
        return made_.path(name);
    }
    fs::path written(const std::string& name, const std::string& bytes) const {
        std::ofstream(made_.path(name), std::ios::binary) << bytes;
        return made_.path(name);
    }
    fs::path raw() const {
        return made_.by_script("make_raw.py", "a.cr2",
                               {"cr2", test::MadePictures::text(written("preview.jpg", gradient(480, 320)))});
    }

private slots:
    void its_pixels_are_the_same_data() {
        QTest::addColumn<QString>("file");
        const auto row = [](const char* name, const fs::path& file) {
            QTest::newRow(name) << test::MadePictures::text(file);
        };
        row("HEIC", made_.coded("a.heic", gradient(96, 64)));
        row("large HEIC", made_.coded("large.heic", large()));
        row("AVIF", made_.coded("a.avif", gradient(93, 61)));
        row("PNG", written("a.png", gradient(300, 200)));
        row("large PNG", written("large.png", large()));
        row("WebP", written("a.webp", gradient(300, 200)));
        row("TIFF", written("a.tiff", gradient(301, 200)));
        row("BMP", written("a.bmp", gradient(300, 200)));
        row("JPEG 2000", written("a.jp2", gradient(300, 200)));
        row("raw", raw());
        row("JPEG", written("a.jpg", gradient(300, 200)));
        row("large JPEG of an odd size",
            written("odd.jpg", large()(cv::Rect(0, 0, large().cols - 3, large().rows - 5))));
        row("one pixel", written("one.png", gradient(1, 1)));
    }
    void its_pixels_are_the_same() {
        QFETCH(QString, file);
        const fs::path path = file.toStdString();
        const auto whole = read_picture(path);
        QVERIFY2(whole.ok(), whole.error().c_str());
        const InHelpers in_helpers(decoders_);
        const auto foreign = read_picture(path);
        QVERIFY2(foreign.ok(), foreign.error().c_str());
        QCOMPARE(largest_difference(*foreign, *whole), 0.0);
        for (const cv::Size box : {cv::Size(50, 50), cv::Size(1, 400), cv::Size(10'000, 10'000)}) {
            const auto fitted = read_picture_to_fit(path, box);
            decode_in_helpers(nullptr);
            const auto here = read_picture_to_fit(path, box);
            decode_in_helpers(&decoders_);
            QVERIFY2(fitted.ok(), fitted.error().c_str());
            QCOMPARE(largest_difference(*fitted, *here), 0.0);
        }
        const auto shrunk = read_picture_shrunk(path, 20);
        decode_in_helpers(nullptr);
        const auto here = read_picture_shrunk(path, 20);
        decode_in_helpers(&decoders_);
        QVERIFY2(shrunk.ok(), shrunk.error().c_str());
        QCOMPARE(shrunk->shrink, here->shrink);
        QVERIFY(shrunk->size == here->size);
        QCOMPARE(largest_difference(shrunk->pixels, here->pixels), 0.0);
        for (int i = 0; i < 2; ++i) {
            const auto again = shrunk->whole();
            QVERIFY2(again.ok(), again.error().c_str());
            QCOMPARE(largest_difference(*again, *whole), 0.0);
        }
    }

    void its_sentences_are_the_same_data() {
        QTest::addColumn<QString>("file");
        const auto row = [](const char* name, const fs::path& file) {
            QTest::newRow(name) << test::MadePictures::text(file);
        };
        const std::string png("\x89PNG\r\n\x1A\n", 8);
        row("nothing", made_.path("nowhere.png"));
        row("no picture", written("text.png", std::string("text")));
        row("empty", written("empty.png", std::string()));
        row("a folder", made_.path("."));
        row("damaged PNG", written("damaged.png", png + "what is no PNG"));
        row("cut HEIC", written("cut.heic", std::string("\0\0\0\x18"
                                                        "ftypheic",
                                                        12)));
        row("raw of nothing", written("cut.cr2", std::string("II*\0\x10\0\0\0CR\2\0", 12)));
    }
    void its_sentences_are_the_same() {
        QFETCH(QString, file);
        const auto here = read_picture(file.toStdString());
        QVERIFY(!here.ok());
        const InHelpers in_helpers(decoders_);
        QCOMPARE(read_picture(file.toStdString()).error(), here.error());
        QCOMPARE(read_picture_shrunk(file.toStdString(), 100).error(), here.error());
    }

    void one_after_the_other_small_and_large() {
        const fs::path small = written("small.png", gradient(90, 70)), large_one = made_.path("beyond.png");
        cv::imwrite(large_one.string(), gradient(4'000, 2'100)); // beyond what is kept
        const InHelpers in_helpers(decoders_);
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(largest_difference(read_picture(small).value(), gradient(90, 70)), 0.0);
            QCOMPARE(largest_difference(read_picture(large_one).value(), gradient(4'000, 2'100)), 0.0);
        }
    }

    void pixels_are_the_readers_own() {
        const fs::path file = written("own.png", gradient(900, 700));
        const InHelpers in_helpers(decoders_);
        const auto first = read_picture(file);
        QVERIFY(first.ok());
        const cv::Mat kept = first->clone();
        cv::Mat changed = *first;
        changed.setTo(cv::Scalar(1, 2, 3));
        const auto second = read_picture(file);
        QVERIFY(second.ok());
        QCOMPARE(largest_difference(*second, kept), 0.0);
        QCOMPARE(largest_difference(changed, cv::Mat(700, 900, CV_8UC3, cv::Scalar(1, 2, 3))), 0.0);
    }

    void a_picture_outlives_what_decoded_it() {
        const fs::path file = written("outlives.png", gradient(900, 700));
        cv::Mat picture;
        {
            ForeignDecoders decoders(decoder_program());
            const InHelpers in_helpers(decoders);
            picture = read_picture(file).value();
        }
        QCOMPARE(largest_difference(picture, gradient(900, 700)), 0.0);
    }

    void threads_do_not_wait_for_each_other() {
        const fs::path heic = made_.coded("thread.heic", gradient(640, 480)),
                       png = written("thread.png", gradient(640, 480));
        const cv::Mat of_heic = read_picture(heic).value(), of_png = read_picture(png).value();
        const InHelpers in_helpers(decoders_);
        const auto kept = read_picture_shrunk(heic, 100); // has its helper for as long as it lives
        QVERIFY(kept.ok());
        std::atomic<int> right = 0;
        std::vector<std::thread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                for (int i = 0; i < 5; ++i) {
                    const auto picture = read_picture(t % 2 == 0 ? heic : png);
                    right +=
                        picture && largest_difference(*picture, t % 2 == 0 ? of_heic : of_png) == 0.0 ? 1 : 0;
                }
            });
        for (std::thread& thread : threads)
            thread.join();
        QCOMPARE(right.load(), 20);
        QCOMPARE(largest_difference(kept->whole().value(), of_heic), 0.0);
    }

    void a_decoder_that_ends_is_one_sentence() {
        const fs::path file = written("a.png", gradient(30, 20));
        ForeignDecoders ending(test::in_build("tests/faces/decode/ending_decoder"));
        const InHelpers in_helpers(ending);
        const QString sentence =
            "The picture cannot be decoded: decoding it broke off. The file may be damaged.";
        for (int i = 0; i < 3; ++i)
            QCOMPARE(QString::fromStdString(read_picture(file).error()), sentence);
        QCOMPARE(QString::fromStdString(read_picture_shrunk(file, 10).error()), sentence);
    }

    void a_decoder_that_is_missing_is_one_sentence() {
        const fs::path png = written("a.png", gradient(30, 20)), jpeg = written("a.jpg", gradient(30, 20));
        ForeignDecoders none(made_.path("no decoder"));
        const InHelpers in_helpers(none);
        QVERIFY(QString::fromStdString(read_picture(png).error()).contains("no decoder"));
        QVERIFY(read_picture(jpeg).ok());
    }

    void answers_that_cannot_be_are_refused_data() {
        QTest::addColumn<QVector<qint64>>(
            "numbers"); // width, height, whole width, whole height, shrink, kept
        QTest::addColumn<int>("bytes");
        QTest::addColumn<bool>("good");
        const auto row = [](const char* name, QVector<qint64> numbers, int bytes, bool good) {
            QTest::newRow(name) << numbers << bytes << good;
        };
        row("as it should be", {4, 2, 4, 2, 1, 0}, 24, true);
        row("shrunk as it should be", {4, 2, 9, 5, 2, 1}, 24, true);
        row("shrunk and rounded up", {5, 3, 9, 5, 2, 1}, 45, true);
        row("rounded up where there is nothing to round", {5, 3, 8, 4, 2, 1}, 45, false);
        row("no memory", {4, 2, 4, 2, 1, 0}, 0, false);
        row("too little memory", {4, 2, 4, 2, 1, 0}, 23, false);
        row("no width", {0, 2, 0, 2, 1, 0}, 24, false);
        row("less than nothing", {-4, -2, -4, -2, 1, 0}, 24, false);
        row("more than any picture", {200'000, 200'000, 200'000, 200'000, 1, 0}, 24, false);
        row("more than a number", {qint64{4} << 32, 2, qint64{4} << 32, 2, 1, 0}, 24, false);
        row("not shrunk by what it says", {4, 2, 40, 20, 2, 0}, 24, false);
        row("shrunk by nothing", {4, 2, 4, 2, 0, 0}, 24, false);
        row("shrunk by much", {4, 2, 400, 200, 100, 0}, 24, false);
        row("too few numbers", {4, 2, 4, 2, 1}, 24, false);
        row("too many numbers", {4, 2, 4, 2, 1, 0, 0}, 24, false);
    }
    void answers_that_cannot_be_are_refused() {
        QFETCH(QVector<qint64>, numbers);
        QFETCH(int, bytes);
        QFETCH(bool, good);
        MessageWriter message;
        message.add(std::string_view());
        for (const qint64 number : numbers)
            message.add(std::int64_t{number});
        if (const auto memory = SharedMemory::make(static_cast<std::size_t>(bytes)))
            message.hand_over(memory->another());
        Message made = message.take();
        std::optional<Mapping> tray;
        const auto answer = picture_answer(made, tray);
        QCOMPARE(answer.ok(), good);
        if (good)
            QVERIFY(answer->pixels.size() ==
                        cv::Size(static_cast<int>(numbers[0]), static_cast<int>(numbers[1])) &&
                    answer->pixels.type() == CV_8UC3);
    }

    void an_answers_sentence_is_made_readable() {
        Message message = MessageWriter().add("bad\x1B[31m\nnews" + std::string(5'000, 'x')).take();
        std::optional<Mapping> tray;
        const std::string sentence = picture_answer(message, tray).error();
        QVERIFY(sentence.size() <= 1'000);
        QVERIFY(sentence.find('\x1B') == std::string::npos && sentence.find('\n') == std::string::npos);
    }
};

QTEST_GUILESS_MAIN(ForeignPictureTest)
#include "foreign_picture_test.moc"
