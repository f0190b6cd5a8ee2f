// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/browse/browse_module.hpp"
#include "browse_bench.hpp"
#include "page_window.hpp"

#include <QAccessible>
#include <QPoint>
#include <QPointingDevice>
#include <QQmlComponent>
#include <QQuickItem>
#include <QQuickView>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>
#include <QVariant>

#include <memory>

/// One for all tests: Qt keeps what it knows of a device for as long as the program runs.
inline QPointingDevice* touch_screen() {
    static QPointingDevice* const screen = QTest::createTouchDevice();
    return screen;
}

/// The page in a window, at the garden.
struct Page : tp::testing::BrowseBench {
    tp::testing::DrawnAlbum::Five five;
    QQuickView window;
    QPointingDevice* screen = touch_screen();

    explicit Page(QSize size = {1280, 800}, bool empty = false) {
        if (!empty)
            five = drawn.five();
        start();
        if (!empty)
            go_to(five.garden);
        tp::register_browse();
        window.setResizeMode(QQuickView::SizeRootObjectToView);
        window.resize(size);
        window.setInitialProperties({{"session", QVariant::fromValue(session.get())}});
        window.setSource(QUrl("qrc:/qt-project.org/imports/TouchPhoto/Browse/BrowsePage.qml"));
        window.show();
        window.requestActivate();
    }
    bool ready() {
        return window.status() == QQuickView::Ready && QTest::qWaitForWindowExposed(&window) &&
               window.rootObject() != nullptr;
    }
    QQuickItem* item(const char* name) const { return window.rootObject()->findChild<QQuickItem*>(name); }
    QPoint middle() const {
        QQuickItem* pane = item("pane");
        return pane->mapToScene({0.5 * pane->width(), 0.5 * pane->height()}).toPoint();
    }
    void key(Qt::Key key) { QTest::keyClick(&window, key); }
    void words(const char* text) {
        for (const char* letter = text; *letter != '\0'; ++letter)
            QTest::keyClick(&window, *letter);
    }

    /// Fingers side by side along a way, and up.
    void draw(const QList<QPoint>& way, int fingers = 1) {
        const auto at = [](const QPoint& place, int finger) { return place + QPoint(0, 90 * finger); };
        {
            auto event = QTest::touchEvent(&window, screen);
            for (int finger = 0; finger < fingers; ++finger)
                event.press(finger, at(way.front(), finger), &window);
        }
        for (int i = 1; i < way.size(); ++i) {
            for (int step = 1; step <= 5; ++step) {
                auto event = QTest::touchEvent(&window, screen);
                for (int finger = 0; finger < fingers; ++finger)
                    event.move(finger, at(way[i - 1] + (way[i] - way[i - 1]) * step / 5, finger), &window);
            }
            QSignalSpy drawn(&window, &QQuickWindow::afterAnimating); // movements come once a frame
            window.update();
            if (!drawn.wait())
                qFatal("no frame is drawn");
        }
        auto event = QTest::touchEvent(&window, screen);
        for (int finger = 0; finger < fingers; ++finger)
            event.release(finger, at(way.back(), finger), &window);
    }
    void swipe(int dx, int dy) { draw({middle(), middle() + QPoint(dx, dy)}); }
    void tap(int fingers = 1) { draw({middle()}, fingers); }
    void theme(const char* name, const QVariant& value) {
        QQmlComponent component(window.engine());
        component.setData(
            "import QtQml\nimport TouchPhoto.Controls\nQtObject { readonly property var theme: Theme }",
            QUrl());
        const std::unique_ptr<QObject> holder(component.create());
        QVERIFY2(holder != nullptr, qPrintable(component.errorString()));
        holder->property("theme").value<QObject*>()->setProperty(name, value);
        window.grabWindow(); // everything is laid out anew
    }
};

inline bool act(QQuickWindow& window, const QString& name,
                const QString& action = QAccessibleActionInterface::pressAction()) {
    return PageWindow::act(PageWindow::named(window, name), action);
}
