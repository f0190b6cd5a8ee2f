// SPDX-License-Identifier: Apache-2.0
#include "app/album/metadata/heif_boxes.hpp"
#include "app/album/metadata/read_record.hpp"
#include "audio/recordings/byte_source.hpp"
#include "faces/decode/picture.hpp"
#include "made_pictures.hpp"
#include "test_program.hpp"

#include <QTest>

#include <opencv2/core.hpp>

#include <string>

namespace heif_boxes_test {

using namespace tp;
using tp::test::gradient;

namespace {

/// What EXIF would have to say (EXIF 2.32, tag 0x0112) for `stored` to be shown as `shown`; 0: nothing.
int orientation_between(const cv::Mat& stored, const cv::Mat& shown) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
        cv::Mat turned = stored.clone();
        if (orientation >= 5)
            cv::transpose(stored, turned);
        constexpr int none = -2;
        const int flips[] = {none, 1, -1, 0, none, 1, -1, 0};
        if (const int flip = flips[orientation - 1]; flip != none)
            cv::flip(turned, turned, flip);
        if (turned.size() == shown.size() && cv::norm(turned, shown, cv::NORM_INF) == 0.0)
            return orientation;
    }
    return 0;
}

} // namespace

class HeifBoxesTest : public QObject {
    Q_OBJECT

    test::MadePictures made_;

private slots:
    void the_turn_is_that_of_the_picture_that_is_shown_data() {
        QTest::addColumn<int>("turn");
        QTest::addColumn<int>("mirror");
        for (const int turn : {0, 90, 180, 270})
            for (const int mirror : {-1, 0, 1})
                QTest::addRow("%d %d", turn, mirror) << turn << mirror;
    }
    void the_turn_is_that_of_the_picture_that_is_shown() {
        QFETCH(int, turn);
        QFETCH(int, mirror);
        static const auto coded = made_.coded("a.heic", gradient(96, 64));
        QStringList arguments{test::MadePictures::text(coded), "--exif-orientation", "7", "--turn",
                              QString::number(turn)};
        if (mirror >= 0)
            arguments << "--mirror" << QString::number(mirror);
        const auto photo = made_.by_script("make_heif.py", "IMG_1.HEIC", arguments);
        const int expected = orientation_between(*read_picture(coded), *read_picture(photo));
        QVERIFY(expected > 0);
        const auto record = read_record(photo);
        QVERIFY(record.ok());
        QCOMPARE(record->orientation, expected);
        QCOMPARE(record->width, 96LL);
        QCOMPARE(record->taken, std::string("2024-05-01T10:11:12"));
    }

    void what_is_no_such_file_says_nothing() {
        for (const char* text : {"", "ftyp", "a letter to Anna", "\xFF\xD8\xFF\xE0 and so on"})
            QVERIFY(!heif_orientation(MemoryBytes(text)));
        QVERIFY(!heif_orientation(MemoryBytes(std::string_view("\0\0\0\x0C"
                                                               "ftypheic\0\0\0\x0C"
                                                               "meta\0\0\0\0",
                                                               24))));
    }
};

} // namespace heif_boxes_test

TP_TEST(heif_boxes_test, HeifBoxesTest, event_loop)
#include "heif_boxes_test.moc"
