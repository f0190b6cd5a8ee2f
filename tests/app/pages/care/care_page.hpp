// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/care/care_module.hpp"
#include "care_bench.hpp"
#include "page_window.hpp"

#include <QAccessible>
#include <QList>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QQuickItem>
#include <QQuickView>
#include <QRectF>
#include <QSet>
#include <QString>
#include <QStringList>

#include <memory>
#include <string>
#include <vector>

struct Page {
    CareBench bench;
    QQuickView window;

    explicit Page(const std::vector<std::string>& names = {"a.png", "b.png", "c.png"},
                  QSize size = {1280, 800}, bool with_folder = true)
        : bench(names, with_folder, true) {
        tp::register_care();
        window.setResizeMode(QQuickView::SizeRootObjectToView);
        window.resize(size);
        window.setInitialProperties({{"session", QVariant::fromValue(bench.session.get())}});
        window.setSource(QUrl("qrc:/qt-project.org/imports/TouchPhoto/Care/CarePage.qml"));
        window.show();
        window.requestActivate();
        CARE_TRY_VERIFY(window.isExposed() && window.isActive());
        window.rootObject()->forceActiveFocus();
    }
    tp::CareSession& session() const { return *bench.session; }
    QQuickItem* item(const char* name) const { return window.rootObject()->findChild<QQuickItem*>(name); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(&window, key, modifiers);
    }
    QString focused() const {
        QAccessibleInterface* const one = QAccessible::queryAccessibleInterface(window.activeFocusItem());
        return one == nullptr ? QString() : one->text(QAccessible::Name);
    }
    /// Goes on by Tab until the control of that name has the keyboard.
    bool tab_to(const QString& name) {
        for (int i = 0; i < 80; ++i) {
            if (focused() == name)
                return true;
            key(Qt::Key_Tab);
        }
        return false;
    }
    void set_text_scale(double scale) const {
        QQmlComponent setter(window.engine());
        setter.setData("import QtQml; import TouchPhoto.Controls; QtObject { property real scale; "
                       "onScaleChanged: Theme.textScale = scale }",
                       QUrl());
        const std::unique_ptr<QObject> made(setter.createWithInitialProperties({{"scale", scale}}));
        QVERIFY2(made != nullptr, qPrintable(setter.errorString()));
    }
};

inline QList<QAccessibleInterface*> everything(Page& page) { return PageWindow::everything(page.window); }

inline QAccessibleInterface* named(Page& page, const QString& name) {
    return PageWindow::named(page.window, name);
}

inline QAccessibleInterface* beginning(Page& page, const QString& name) {
    for (QAccessibleInterface* one : everything(page))
        if (one->text(QAccessible::Name).startsWith(name))
            return one;
    return nullptr;
}

inline bool press(QAccessibleInterface* one) { return PageWindow::press(one); }

inline bool is_operable(QAccessibleInterface* one) {
    const QStringList actions =
        one->actionInterface() ? one->actionInterface()->actionNames() : QStringList();
    const bool counts = one->state().focusable || actions.contains(QAccessibleActionInterface::pressAction());
    static const QSet<QAccessible::Role> words{QAccessible::Window, QAccessible::Client,
                                               QAccessible::StaticText, QAccessible::Heading};
    return counts && !words.contains(one->role());
}

/// Everything that can be operated has a name, a role of its own and at least 48 px each way; none lies outside of the
/// window's width.
inline void check_operable(Page& page, int least = 5) {
    page.window.grabWindow(); // everything has its place
    int operable = 0;
    for (QAccessibleInterface* one : everything(page)) {
        auto* const item = qobject_cast<QQuickItem*>(one->object());
        if (!is_operable(one) || item == nullptr)
            continue;
        ++operable;
        const QString words = QString("%1 (role %2)").arg(one->text(QAccessible::Name)).arg(one->role());
        QVERIFY2(!one->text(QAccessible::Name).isEmpty(), qPrintable(words));
        QVERIFY2(one->role() != QAccessible::NoRole && one->role() != QAccessible::Client, qPrintable(words));
        const QRectF place = item->mapRectToScene(item->boundingRect());
        QVERIFY2(item->width() >= 48.0 && item->height() >= 48.0,
                 qPrintable(words + QString(" %1x%2").arg(item->width()).arg(item->height())));
        QVERIFY2(place.left() >= -1.0 && place.right() <= page.window.width() + 1.0,
                 qPrintable(words + QString(" %1 … %2").arg(place.left()).arg(place.right())));
    }
    QVERIFY(operable >= least);
}
