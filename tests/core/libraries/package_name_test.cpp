// SPDX-License-Identifier: Apache-2.0
#include "core/libraries/package_name.hpp"

#include <QTest>

class PackageNameTest : public QObject {
    Q_OBJECT

private slots:
    void each_is_called_as_debian_calls_it_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("package");
        QTest::newRow("Debian 12's") << "libavformat.so.59"
                                     << "libavformat59";
        QTest::newRow("underscores") << "libopencv_imgcodecs.so.410"
                                     << "libopencv-imgcodecs410";
        QTest::newRow("a number in its name") << "libusb-1.0.so.0"
                                              << "libusb-1.0-0";
        QTest::newRow("of no version") << "libplugin.so"
                                       << "libplugin";
        QTest::newRow("of another system") << "libheif.dylib"
                                           << "libheif.dylib";
    }
    void each_is_called_as_debian_calls_it() {
        QFETCH(QString, file);
        QFETCH(QString, package);
        QCOMPARE(QString::fromStdString(tp::debian_package(file.toStdString())), package);
    }
};

QTEST_GUILESS_MAIN(PackageNameTest)
#include "package_name_test.moc"
