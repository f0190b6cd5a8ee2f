// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_setup.hpp"

#include "core/guidance/published_law.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

namespace tp {

namespace {

constexpr const char* format = "TouchPhotoLab 1";
constexpr double farthest_mm = 1000.0;

QString text(const std::string& words) { return QString::fromStdString(words); }

QJsonObject json_of_parameters(const LabParameters& parameters) {
    QJsonObject object{{"law", parameters.law == LawKind::exact ? "exact" : "published"}};
    for (const LabNumber& number : lab_numbers())
        object[number.key] = parameters.*number.member;
    for (const LabSwitch& one : lab_switches())
        object[one.key] = parameters.*one.member;
    return object;
}

QJsonArray json_of_lines(const FlatScene& scene) {
    QJsonArray lines;
    for (std::size_t i = 0; i < scene.lines.size(); ++i) {
        QJsonArray points;
        for (const Vec2 p : scene.lines[i].points)
            points << QJsonArray{p.x, p.y};
        lines << QJsonObject{{"name", text(scene.names[i])}, {"closed", scene.lines[i].closed}, {"points_mm", points}};
    }
    return lines;
}

Result<LabParameters> parameters_from(const QJsonObject& object) {
    LabParameters parameters;
    const auto law = law_named(object["law"].toString("exact").toStdString());
    if (!law)
        return Error{"it names a law that is unknown."};
    parameters.law = *law;
    for (const LabNumber& number : lab_numbers()) {
        const QJsonValue value = object[number.key];
        if (value.isUndefined())
            continue;
        const double given = value.toDouble(std::nan(""));
        if (!(given >= number.lowest && given <= number.highest))
            return Error{std::string(number.key) + " is not between " +
                         QByteArray::number(number.lowest).toStdString() + " and " +
                         QByteArray::number(number.highest).toStdString() + "."};
        parameters.*number.member = given;
    }
    for (const LabSwitch& one : lab_switches())
        parameters.*one.member = object[one.key].toBool(parameters.*one.member);
    return parameters;
}

Result<Polyline> line_from(const QJsonObject& object) {
    Polyline line;
    line.closed = object["closed"].toBool();
    for (const QJsonValue& value : object["points_mm"].toArray()) {
        const QJsonArray pair = value.toArray();
        const Vec2 point(pair.at(0).toDouble(std::nan("")), pair.at(1).toDouble(std::nan("")));
        if (pair.size() != 2 || !(std::abs(point.x) <= farthest_mm && std::abs(point.y) <= farthest_mm))
            return Error{"a place of its scene is not two numbers in millimetres."};
        line.points.push_back(point);
    }
    return line;
}

} // namespace

const std::vector<LabNumber>& lab_numbers() {
    using P = LabParameters;
    static const std::vector<LabNumber> numbers{
        {"stiffness", &P::stiffness, 0.1, 0.5, 0.05, LabEffect::scene},
        {"range", &P::range, 2.0, 10.0, 0.5, LabEffect::scene},
        {"hold", &P::hold, 0.0, 2.0, 0.1, LabEffect::scene},
        {"blend", &P::blend, 0.0, 2.0, 0.1, LabEffect::scene},
        {"vertexSpacing", &P::vertex_spacing, 0.5, 10.0, 0.5, LabEffect::scene},
        {"maxForce", &P::max_force, 0.1, 1.5, 0.1, LabEffect::live},
        {"lineDamping", &P::line_damping, 0.0, 2.0, 0.1, LabEffect::loop},
        {"mass", &P::mass, 0.02, 0.5, 0.02, LabEffect::loop},
        {"damping", &P::damping, 0.0, 2.0, 0.1, LabEffect::loop},
        {"friction", &P::friction, 0.0, 0.5, 0.02, LabEffect::loop},
        {"quantum", &P::quantum, 0.0, 0.5, 0.01, LabEffect::loop},
        {"delay", &P::delay, 0.0, 16.0, 1.0, LabEffect::loop},
        {"handStiffness", &P::hand_stiffness, 0.0, 1.0, 0.02, LabEffect::loop},
        {"handDamping", &P::hand_damping, 0.0, 20.0, 0.5, LabEffect::loop},
        {"drop", &P::drop, 0.0, 1.0, 0.05, LabEffect::live},
    };
    return numbers;
}

const std::vector<LabSwitch>& lab_switches() {
    using P = LabParameters;
    static const std::vector<LabSwitch> switches{
        {"cornerCue", &P::corner_cue, LabEffect::scene},
        {"energyObserver", &P::energy_observer, LabEffect::loop},
        {"strictLimits", &P::strict_limits, LabEffect::loop},
        {"silent", &P::silent, LabEffect::live},
        {"refuses", &P::refuses, LabEffect::live},
        {"motorsOff", &P::motors_off, LabEffect::live},
        {"unplugged", &P::unplugged, LabEffect::live},
    };
    return switches;
}

const LabNumber* lab_number(std::string_view key) {
    for (const LabNumber& number : lab_numbers())
        if (number.key == key)
            return &number;
    return nullptr;
}

const LabSwitch* lab_switch(std::string_view key) {
    for (const LabSwitch& one : lab_switches())
        if (one.key == key)
            return &one;
    return nullptr;
}

Result<std::unique_ptr<HapticScene>> felt_scene(const FlatScene& flat, const LabParameters& parameters) {
    const bool exact = parameters.law == LawKind::exact;
    const TentProfile profile{parameters.stiffness, parameters.range};
    const Continuity continuity =
        exact ? Continuity{parameters.hold, parameters.blend, parameters.corner_cue} : Continuity{};
    if (!profile.valid())
        return Error{"Stiffness and range of the guidance must both be numbers above zero."};
    if (const std::string problem = continuity.problem(); !problem.empty())
        return Error{problem};
    if (std::all_of(flat.lines.begin(), flat.lines.end(), [](const Polyline& line) { return line.points.empty(); }))
        return Error{"The scene has no line that can be felt."};
    auto haptic = std::make_unique<HapticScene>();
    haptic->flat = exact ? flat : with_vertex_spacing(flat, parameters.vertex_spacing);
    haptic->profile = profile;
    haptic->law = make_law(haptic->flat, profile, parameters.law, continuity);
    haptic->stiffness = steepest(profile, continuity);
    haptic->hold_mm = continuity.hold_mm;
    return haptic;
}

SimulatedPlant plant_of(const LabParameters& parameters) {
    SimulatedPlant plant;
    plant.mass = parameters.mass;
    plant.damping = parameters.damping;
    plant.coulomb = parameters.friction;
    plant.quantum = parameters.quantum;
    plant.delay_ticks = static_cast<std::size_t>(std::lround(parameters.delay));
    plant.hand_stiffness = parameters.hand_stiffness;
    plant.hand_damping = parameters.hand_damping;
    return plant;
}

ServoSettings servo_settings(const LabParameters& parameters, double rate, bool real) {
    ServoSettings settings;
    settings.rate = rate;
    settings.line_damping_ratio = parameters.line_damping;
    settings.handle_mass = parameters.mass;
    settings.energy_observer = parameters.energy_observer;
    if (!real && !parameters.strict_limits) {
        settings.limits.late_periods = 60.0;
        settings.limits.stale_after = 0.100;
        settings.limits.stall = 1.0;
    }
    return settings;
}

std::string setup_json(const LabSetup& setup) {
    const QJsonObject object{{"format", format},
                             {"device", setup.real_device ? "real" : "simulated"},
                             {"parameters", json_of_parameters(setup.parameters)},
                             {"scene_name", text(setup.scene_name)},
                             {"scene", json_of_lines(setup.scene)}};
    return QJsonDocument(object).toJson().toStdString();
}

Result<LabSetup> parse_setup(std::string_view json) {
    const QJsonObject object =
        QJsonDocument::fromJson(QByteArray(json.data(), static_cast<qsizetype>(json.size()))).object();
    if (object["format"].toString() != format)
        return Error{"it is not a lab setup of version 1."};
    Result<LabParameters> parameters = parameters_from(object["parameters"].toObject());
    if (!parameters)
        return Error{parameters.error()};
    LabSetup setup{*parameters, object["scene_name"].toString().toStdString(), {}, object["device"].toString() == "real"};
    for (const QJsonValue& value : object["scene"].toArray()) {
        const QJsonObject one = value.toObject();
        Result<Polyline> line = line_from(one);
        if (!line)
            return Error{line.error()};
        setup.scene.names.push_back(one["name"].toString().toStdString());
        setup.scene.lines.push_back(std::move(line).value());
    }
    return setup;
}

} // namespace tp
