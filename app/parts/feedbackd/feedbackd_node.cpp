// SPDX-License-Identifier: Apache-2.0
#include "app/parts/feedbackd/feedbackd_node.hpp"

#include <QDBusMessage>
#include <QDBusMetaType>
#include <QVariant>

#include <cerrno>

namespace tp {

namespace feedbackd {

QDBusArgument& operator<<(QDBusArgument& argument, const Pulse& pulse) {
    argument.beginStructure();
    argument << pulse.strength << pulse.length_ms;
    argument.endStructure();
    return argument;
}

const QDBusArgument& operator>>(const QDBusArgument& argument, Pulse& pulse) {
    argument.beginStructure();
    argument >> pulse.strength >> pulse.length_ms;
    argument.endStructure();
    return argument;
}

} // namespace feedbackd

FeedbackdNode::FeedbackdNode(const QDBusConnection& bus, int answers_within_ms)
    : bus_(bus), answers_within_ms_(answers_within_ms) {
    qDBusRegisterMetaType<feedbackd::Pulse>();
    qDBusRegisterMetaType<feedbackd::Pattern>();
}

int FeedbackdNode::upload(const FeedbackEffect& effect) noexcept {
    effect_ = effect;
    return 0;
}

int FeedbackdNode::play(bool on) noexcept {
    feedbackd::Pattern pattern;
    if (on)
        pattern.append({effect_.strong / 65535.0, effect_.length_ms});
    QDBusMessage call = QDBusMessage::createMethodCall(feedbackd::service, feedbackd::path, feedbackd::haptic,
                                                       QStringLiteral("Vibrate"));
    call << QStringLiteral("touchphoto") << QVariant::fromValue(pattern);
    const QDBusMessage answer = bus_.call(call, QDBus::Block, answers_within_ms_);
    if (answer.type() == QDBusMessage::ReplyMessage)
        return !on || answer.arguments().value(0).toBool() ? 0 : EIO;
    const QString error = answer.errorName();
    for (const char* const absent : {"ServiceUnknown", "NameHasNoOwner", "UnknownObject", "UnknownInterface",
                                     "UnknownMethod", "Disconnected"})
        if (error.endsWith(QLatin1Char('.') + QLatin1String(absent)))
            gone_ = true;
    return gone_ ? ENODEV : EIO;
}

} // namespace tp
