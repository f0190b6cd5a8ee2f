// SPDX-License-Identifier: Apache-2.0
#include "app/parts/preferences/choices.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QJsonValue>

#include <array>
#include <cstddef>

namespace tp {

namespace {

constexpr std::array voice_names{"program", "screen_reader", "off"};
constexpr std::array rate_names{"very_slow", "slow", "normal", "fast", "very_fast"};
constexpr std::array user_names{"end_user", "caregiver"};
constexpr std::array theme_names{"dark", "light", "yellow_on_black"};
constexpr std::array description_names{"none", "short", "full"};
constexpr std::array guide_names{"none", "sonar", "clock_voice", "both", "ticks", "ticks_and_sonar"};

/// Writes each choice under its name.
class ToJson {
public:
    void operator()(const char* name, const bool& value) { object_[name] = value; }
    void operator()(const char* name, const QString& value) { object_[name] = value; }
    void operator()(const char* name, const QStringList& value) {
        object_[name] = QJsonArray::fromStringList(value);
    }
    void operator()(const char* name, const double& value, double, double) { object_[name] = value; }
    void operator()(const char* name, const QMap<QString, double>& values, double, double) {
        QJsonObject each;
        for (auto one = values.begin(); one != values.end(); ++one)
            each[one.key()] = one.value();
        object_[name] = each;
    }
    template <typename Enum, std::size_t Count>
    void operator()(const char* name, const Enum& value, const std::array<const char*, Count>& names) {
        object_[name] = names[static_cast<std::size_t>(value)];
    }
    const QJsonObject& object() const { return object_; }

private:
    QJsonObject object_;
};

/// Reads each choice that is there and makes sense.
class FromJson {
public:
    explicit FromJson(QJsonObject object) : object_(std::move(object)) {}
    void operator()(const char* name, bool& value) const { value = object_[name].toBool(value); }
    void operator()(const char* name, QString& value) const { value = object_[name].toString(value); }
    void operator()(const char* name, QStringList& value) const {
        if (!object_[name].isArray())
            return;
        value.clear();
        for (const QJsonValue& one : object_[name].toArray())
            if (!one.toString().isEmpty())
                value << one.toString();
    }
    void operator()(const char* name, double& value, double least, double most) const {
        const double read = object_[name].toDouble(value);
        if (read >= least && read <= most)
            value = read;
    }
    void operator()(const char* name, QMap<QString, double>& values, double least, double most) const {
        if (!object_[name].isObject())
            return;
        values.clear();
        const QJsonObject each = object_[name].toObject();
        for (auto one = each.begin(); one != each.end(); ++one)
            if (one->isDouble() && one->toDouble() >= least && one->toDouble() <= most)
                values[one.key()] = one->toDouble();
    }
    template <typename Enum, std::size_t Count>
    void operator()(const char* name, Enum& value, const std::array<const char*, Count>& names) const {
        for (std::size_t i = 0; i < Count; ++i)
            if (object_[name].toString() == names[i])
                value = static_cast<Enum>(i);
    }

private:
    QJsonObject object_;
};

template <typename Of, typename Visitor>
void each_choice(Of& choices, Visitor& visit) {
    visit("asked", choices.asked);
    visit("voice", choices.voice, voice_names);
    visit("speech_rate", choices.rate, rate_names);
    visit("user", choices.user, user_names);
    visit("language", choices.language);
    visit("theme", choices.theme, theme_names);
    visit("text_scale", choices.text_scale, 1.0, 2.0);
    visit("motion", choices.motion);
    visit("earcons", choices.earcons);
    visit("descriptions", choices.descriptions, description_names);
    visit("place_first", choices.place_first);
    visit("know_faces", choices.know_faces);
    visit("guide", choices.guide, guide_names);
    visit("max_force_n", choices.max_force_n, 0.1, 1.5);
    visit("shutter_by_itself", choices.shutter_by_itself);
    visit("keep_moment", choices.keep_moment);
    visit("capture_told", choices.capture_told);
    visit("playback_speed", choices.playback_speed, 0.5, 2.0);
    visit("brows", choices.brows);
    visit("nose", choices.nose);
    visit("irises", choices.irises);
    visit("album_folders", choices.folders);
    visit("last_photo", choices.last_photo);
    visit("touch", choices.touch);
    visit("touch_strength", choices.touch_strength, 0.1, 1.0);
    visit("touch_sharpness", choices.touch_sharpness, 0.0, 1.0);
    visit("touch_latencies_s", choices.touch_latencies_s, 0.0, 0.15);
    visit("touch_latency_s", choices.touch_latency_s, 0.0, 0.15);
    visit("device", choices.device);
}

} // namespace

double touch_latency_s(const Choices& choices, const QString& key, double own) {
    return choices.touch_latencies_s.value(key,
                                           choices.touch_latency_s > 0.0 ? choices.touch_latency_s : own);
}

double speech_rate(Choices::Rate rate) {
    constexpr std::array rates{-0.6, -0.3, 0.0, 0.35, 0.7};
    return rates[static_cast<std::size_t>(rate)];
}

QByteArray json_of(const Choices& choices) {
    ToJson visit;
    each_choice(choices, visit);
    return QJsonDocument(visit.object()).toJson();
}

Choices choices_from(const QByteArray& json, const Choices& otherwise, bool* spoilt) {
    Choices choices = otherwise;
    const QJsonDocument document = QJsonDocument::fromJson(json);
    if (spoilt != nullptr)
        *spoilt = !document.isObject();
    const FromJson visit(document.object());
    each_choice(choices, visit);
    return choices;
}

} // namespace tp
