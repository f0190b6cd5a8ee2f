// SPDX-License-Identifier: Apache-2.0
#include "app/pages/explore/sheet_place.hpp"
#include "test_program.hpp"

#include <QTest>

#include <limits>
#include <optional>

namespace sheet_place_test {

using namespace tp;

class SheetPlaceTest : public QObject {
    Q_OBJECT
private slots:
    void the_screens_millimetres_become_the_sheets() {
        SheetPlace sheet({200.0, 150.0});
        QVERIFY(sheet.lies(20.0, 10.0, 0.8));
        const std::optional<Affine> map = sheet.from_device({});
        QVERIFY(map.has_value());
        const Vec2 corner = (*map)(Vec2(20.0, -10.0)); // y up
        QVERIFY(length(corner - Vec2(-100.0, 75.0)) < 1e-9);
        const Vec2 middle = (*map)(Vec2(20.0, -10.0) + 0.8 * Vec2(100.0, -75.0));
        QVERIFY(length(middle) < 1e-9);
    }

    void it_tells_whether_it_lies_elsewhere() {
        SheetPlace sheet({200.0, 150.0});
        QVERIFY(sheet.lies(20.0, 10.0, 0.8));
        const SheetPlace before = sheet;
        QVERIFY(!sheet.lies(20.0, 10.0, 0.8));
        QVERIFY(sheet == before);
        for (const double nonsense : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
            QVERIFY(!sheet.lies(0.0, 0.0, nonsense));
        QVERIFY(sheet == before);
        QVERIFY(sheet.lies(25.0, 10.0, 0.8));
        QVERIFY(!(sheet == before));
    }

    void drawn_too_small_or_too_large_it_is_not_felt_where_it_is_seen() {
        SheetPlace sheet({200.0, 150.0});
        for (const double scale : {0.6, 2.1}) {
            sheet.lies(0.0, 0.0, scale);
            QVERIFY(!sheet.from_device({}));
        }
        for (const double scale : {0.7, 1.9}) {
            sheet.lies(0.0, 0.0, scale);
            QVERIFY(sheet.from_device({}).has_value());
        }
    }
};

} // namespace sheet_place_test

TP_TEST(sheet_place_test, SheetPlaceTest, nothing)
#include "sheet_place_test.moc"
