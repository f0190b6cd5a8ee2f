// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <QQuickItem>
#include <QQuickPaintedItem>
#include <QQuickWindow>
#include <QRect>
#include <QSize>
#include <QVariant>

#include <algorithm>
#include <cstdlib>

namespace tp::testing {

/// A painted item alone in a window, as it is seen: what it does not paint is `ground`. It is painted anew only where it
/// has asked for that itself.
template <typename Item>
class DrawnItem {
public:
    static inline const QColor ground{10, 60, 20};

    explicit DrawnItem(QSize size) {
        window_.setColor(ground);
        window_.resize(size);
        item.setParentItem(window_.contentItem());
        item.setSize(size);
        window_.show();
    }
    template <typename Value>
    void set(const char* property, const Value& value) {
        item.setProperty(property, QVariant::fromValue(value));
    }
    QImage picture() { return window_.grabWindow().convertToFormat(QImage::Format_RGB32); }

private:
    QQuickWindow window_;

public:
    Item item; ///< ends before its window
};

/// So nearly the same that a person sees no difference.
inline bool is_near(const QColor& one, const QColor& other) {
    return std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
               std::abs(one.blue() - other.blue()) <
           24;
}

/// The smallest rectangle with all pixels of a colour; empty where there is none.
inline QRect extent_of(const QImage& picture, const QColor& colour) {
    QRect all;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (is_near(picture.pixelColor(x, y), colour))
                all |= QRect(x, y, 1, 1);
    return all;
}

/// How many pixels of a column, or of a part of it, have that colour.
inline int rows_of(const QImage& picture, int x, const QColor& colour, int top = 0, int bottom = 1 << 16) {
    int rows = 0;
    for (int y = top; y < std::min(bottom, picture.height()); ++y)
        rows += is_near(picture.pixelColor(x, y), colour) ? 1 : 0;
    return rows;
}

} // namespace tp::testing
