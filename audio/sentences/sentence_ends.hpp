// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringView>

namespace tp {

/// Where, from `from` on, the first space behind the end of a sentence is; -1: nowhere.
inline qsizetype next_sentence(QStringView text, qsizetype from) {
    for (qsizetype space = text.indexOf(u' ', from + 1); space >= 0; space = text.indexOf(u' ', space + 1))
        if (const QChar before = text[space - 1]; before == u'.' || before == u'!' || before == u'?')
            return space;
    return -1;
}

} // namespace tp
