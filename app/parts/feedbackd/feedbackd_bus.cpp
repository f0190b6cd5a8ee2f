// SPDX-License-Identifier: Apache-2.0
#include "app/parts/feedbackd/feedbackd_bus.hpp"

#include "app/parts/feedbackd/feedbackd_node.hpp"
#include "device/touch_output/force_feedback/feedback_output.hpp"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QFile>

#include <memory>
#include <string>

namespace tp {

namespace {

const std::string name_for_person = "vibration of this phone";

/// Qt would start a bus where there is none.
bool session_has_bus() {
    return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
           (qEnvironmentVariableIsSet("XDG_RUNTIME_DIR") &&
            QFile::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus")));
}

bool has_motor(const QDBusConnection& bus) {
    const QDBusMessage call = QDBusMessage::createMethodCall(
        feedbackd::service, feedbackd::path, QStringLiteral("org.freedesktop.DBus.Introspectable"),
        QStringLiteral("Introspect"));
    const QDBusMessage answer = bus.call(call, QDBus::Block, feedbackd::answers_within_ms);
    return answer.type() == QDBusMessage::ReplyMessage &&
           answer.arguments().value(0).toString().contains(QLatin1Char('"') + feedbackd::haptic +
                                                           QLatin1Char('"'));
}

} // namespace

std::vector<PluggedTouchOutput> plugged_feedbackd() {
    if (!session_has_bus() || !has_motor(QDBusConnection::sessionBus()))
        return {};
    PluggedTouchOutput output;
    output.name = "feedbackd:motor";
    output.about = name_for_person;
    output.means = TouchMeans::rumble;
    output.delay = feedback_delay_s(FeedbackKind::motor);
    output.make = []() -> std::unique_ptr<TouchOutput> {
        return std::make_unique<FeedbackOutput>(
            FeedbackOutput::Identity{name_for_person, {}}, []() -> Result<std::unique_ptr<FeedbackNode>> {
                return std::unique_ptr<FeedbackNode>(
                    std::make_unique<FeedbackdNode>(QDBusConnection::sessionBus()));
            });
    };
    return {std::move(output)};
}

} // namespace tp
