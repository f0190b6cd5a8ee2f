// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "device/touch_output/force_feedback/feedback_node.hpp"

#include <QDBusArgument>
#include <QDBusConnection>
#include <QList>
#include <QMetaType>
#include <QString>

#include <atomic>

namespace tp {

/// feedbackd on the session's D-Bus (its README, "Haptic API").
namespace feedbackd {

inline const QString service = QStringLiteral("org.sigxcpu.Feedback");
inline const QString path = QStringLiteral("/org/sigxcpu/Feedback");
inline const QString haptic = QStringLiteral("org.sigxcpu.Feedback.Haptic");
inline constexpr int answers_within_ms = 500;

/// A piece of a vibration, (du).
struct Pulse {
    double strength = 0.0; ///< 0 … 1
    uint length_ms = 0;
};
using Pattern = QList<Pulse>; ///< an empty one ends what is under way

QDBusArgument& operator<<(QDBusArgument& argument, const Pulse& pulse);
const QDBusArgument& operator>>(const QDBusArgument& argument, Pulse& pulse);

} // namespace feedbackd

/// The motor that feedbackd has, as one that plays an effect.
class FeedbackdNode final : public FeedbackNode {
public:
    /// A call waits for its answer so long at most.
    explicit FeedbackdNode(const QDBusConnection& bus, int answers_within_ms = feedbackd::answers_within_ms);

    FeedbackKind kind() const override { return FeedbackKind::motor; }
    int upload(const FeedbackEffect& effect) noexcept override;
    /// ENODEV where the service or its motor is gone, EIO where it refuses or does not answer.
    int play(bool on) noexcept override;
    bool there() const noexcept override { return !gone_; }

private:
    QDBusConnection bus_;
    int answers_within_ms_;
    FeedbackEffect effect_;
    std::atomic<bool> gone_{false};
};

} // namespace tp

Q_DECLARE_METATYPE(tp::feedbackd::Pulse)
