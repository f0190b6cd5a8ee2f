// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAccessibleInterface>
#include <QString>

namespace tp {

/// What has the keyboard, in words: its name, what it is, and how it stands ("Voice, switch, on"). For a person without
/// a screen reader, whom the program's own voice must tell.
QString focus_words(QAccessibleInterface& focused);

} // namespace tp
