// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

namespace tp {

/// What a person has chosen. The defaults are those of somebody who has not been asked yet.
struct Choices {
    enum class Voice { program, screen_reader, off };
    enum class Rate { very_slow, slow, normal, fast, very_fast };
    enum class User { end_user, caregiver };
    enum class Theme { dark, light, yellow_on_black };
    /// What guides a finger where no force does; `both`: sonar and clock voice.
    enum class Guide { none, sonar, clock_voice, both, ticks, ticks_and_sonar };

    /// How much is said of what is seen on a photograph.
    enum class Descriptions { none, brief, full };

    bool asked = false; ///< the questions of the first start have been answered
    Voice voice = Voice::program;
    Rate rate = Rate::normal;
    User user = User::end_user;
    QString language; ///< "en", "de", "ko"; empty: the system's
    Theme theme = Theme::dark;
    double text_scale = 1.0; ///< 1–2
    bool motion = true;      ///< pictures may move and fade
    bool earcons = true;
    Descriptions descriptions = Descriptions::brief;
    bool place_first = false; ///< a description begins with time and place, not with people
    bool know_faces = true;   ///< faces of the album are compared, so that names can be offered
    Guide guide = Guide::both;
    double max_force_n = 1.0;                         ///< newtons, 0.1–1.5
    bool shutter_by_itself = true;                    ///< a photograph is taken when all is well
    bool keep_moment = false;                         ///< with it the sound round it, as a recording
    bool capture_told = false;                        ///< how photographs are taken was told once
    double playback_speed = 1.0;                      ///< of recordings, 0.5–2
    bool brows = false, nose = false, irises = false; ///< felt beside eyes, lips and outline
    QStringList folders;                              ///< of the album, absolute
    QString last_photo;                               ///< where one was, absolute; empty: nowhere
    QString touch;                ///< serial number, or name, of the output that ticks; empty: the first
    double touch_strength = 0.7;  ///< 0.1–1
    double touch_sharpness = 0.7; ///< 0–1
    /// Of each output by what `touch` would remember it by: 0–0.15, from a tick that is sent to one that is felt.
    QMap<QString, double> touch_latencies_s;
    double touch_latency_s = 0.0; ///< of outputs that are not in it; 0: what each says of itself
    QString device; ///< serial number, or name, of the force device; "simulated": none; empty: the first

    bool operator==(const Choices&) const = default;
};

/// How late ticks of the output that is remembered by `key` are felt, s; `own` is its estimate of itself.
double touch_latency_s(const Choices& choices, const QString& key, double own);

/// -1 … 1, as a Voice wants it.
double speech_rate(Choices::Rate rate);

/// As JSON, for people to read and mend.
QByteArray json_of(const Choices& choices);
/// What the text holds; what it does not hold, or holds outside of its bounds, is as in `otherwise`. `spoilt` becomes
/// true where the text is not JSON at all.
Choices choices_from(const QByteArray& json, const Choices& otherwise, bool* spoilt = nullptr);

} // namespace tp
