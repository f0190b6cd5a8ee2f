// SPDX-License-Identifier: Apache-2.0
#include "app/pages/mend/mend_words.hpp"

#include "app/photo/scene/feature_words.hpp"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace tp {

namespace {

struct MendWords {
    Q_DECLARE_TR_FUNCTIONS(MendWords)
};

QString number(double value) {
    const double tenths = std::round(10.0 * value) / 10.0;
    return QLocale().toString(tenths, 'f', tenths == std::floor(tenths) ? 0 : 1);
}

} // namespace

QString feature_words(const std::string& name, int face) {
    // The words of app/pages/explore, translated where they are.
    const QString word = QCoreApplication::translate("tp::FeatureLabels", spoken_feature(name).c_str());
    return face < 0 ? word
                    : QCoreApplication::translate("tp::FeatureLabels", "%1 of face %2", "left eye of face 2")
                          .arg(word)
                          .arg(face + 1);
}

QString node_words(const MendContour& contour, std::size_t node) {
    const int number = static_cast<int>(node) + 1;
    const int count = static_cast<int>(contour.nodes.size());
    switch (contour.nodes[node].kind) {
    case MendNode::Kind::corner:
        return MendWords::tr("Corner %1 of %2").arg(number).arg(count);
    case MendNode::Kind::smooth:
        return MendWords::tr("Point %1 of %2").arg(number).arg(count);
    case MendNode::Kind::control:
        break;
    }
    return MendWords::tr("Bend %1 of %2", "a control point beside the line").arg(number).arg(count);
}

QString place_words(Vec2 place) {
    return MendWords::tr("%1 across, %2 down").arg(number(place.x), number(place.y));
}

QString change_words(const std::optional<FieldDifference>& difference) {
    if (!difference)
        return {};
    if (difference->max_n < 1e-6)
        return MendWords::tr("It feels as the program found it.");
    if (difference->felt_share <= 0.0)
        return MendWords::tr("A finger will not notice the difference from what the program found.");
    const QLocale locale;
    return MendWords::tr("A finger notices the difference from what the program found on %1 % of the "
                         "surface; there the force differs by up to %2 N.")
        .arg(locale.toString(100.0 * difference->felt_share, 'f', 1),
             locale.toString(difference->max_n, 'f', 2));
}

} // namespace tp
