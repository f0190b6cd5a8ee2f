// SPDX-License-Identifier: Apache-2.0
#include "app/shell/focus_words.hpp"

#include <QAccessible>
#include <QCoreApplication>
#include <QStringList>

namespace tp {

namespace {

class FocusText {
    Q_DECLARE_TR_FUNCTIONS(tp::FocusText)
};

QString kind(QAccessible::Role role) {
    switch (role) {
    case QAccessible::Button: return FocusText::tr("button");
    case QAccessible::CheckBox: return FocusText::tr("switch");
    case QAccessible::RadioButton: return FocusText::tr("choice");
    case QAccessible::Slider: return FocusText::tr("slider");
    case QAccessible::EditableText: return FocusText::tr("text field");
    default: return {};
    }
}

QString state(QAccessibleInterface& focused) {
    switch (focused.role()) {
    case QAccessible::CheckBox: return focused.state().checked ? FocusText::tr("on") : FocusText::tr("off");
    case QAccessible::RadioButton:
        return focused.state().checked ? FocusText::tr("selected") : QString();
    case QAccessible::Slider: return focused.text(QAccessible::Description); // the value with its unit
    default: return {};
    }
}

} // namespace

QString focus_words(QAccessibleInterface& focused) {
    QStringList words{focused.text(QAccessible::Name), kind(focused.role()), state(focused)};
    words.removeAll(QString());
    return words.join(", ");
}

} // namespace tp
