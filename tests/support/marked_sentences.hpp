// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QTranslator>

#include <cstring>

namespace tp::testing {

/// A language that puts each sentence of ours in brackets and leaves everything else.
class Brackets final : public QTranslator {
public:
    QString translate(const char* context, const char* source, const char*, int) const override {
        return std::strcmp(context, "Sentence") == 0 ? u'⟦' + QString::fromUtf8(source) + u'⟧' : QString();
    }
    bool isEmpty() const override { return false; }
};

inline QString without_brackets(QString text) { return text.remove(u'⟦').remove(u'⟧'); }

} // namespace tp::testing
