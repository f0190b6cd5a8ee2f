// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_trace.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace tp {

namespace {

void append(std::string& to, double value, char end) {
    std::array<char, 32> digits{};
    to.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
    to += end;
}

} // namespace

double TracePoint::newtons() const { return std::hypot(fx, fy); }

void LabTrace::begin(double rate, std::size_t delay_ticks) {
    *this = {};
    period_ = 1.0 / rate;
    delay_ = delay_ticks;
}

void LabTrace::add(const TickSample& tick) {
    TracePoint point;
    if (forces_.empty()) {
        begun_ = tick.time;
    } else {
        point.lateness = std::max(0.0, tick.time - last_time_ - period_);
        if (forces_.size() > delay_) // the oldest acted since the tick before
            energy_ += 1e-3 * glm::dot(forces_.front(), tick.place - last_place_);
    }
    forces_.push_back(tick.force);
    if (forces_.size() > delay_ + 1)
        forces_.pop_front();
    last_time_ = tick.time;
    last_place_ = tick.place;
    point.time = tick.time - begun_;
    point.x = tick.place.x;
    point.y = tick.place.y;
    point.fx = tick.force.x;
    point.fy = tick.force.y;
    point.energy = energy_;
    points_.push_back(point);
    while (points_.front().time < point.time - longest)
        points_.pop_front();
}

std::string LabTrace::csv() const {
    std::string table = "time_s,x_mm,y_mm,fx_n,fy_n,energy_j,lateness_s\n";
    for (const TracePoint& point : points_) {
        for (const double value : {point.time, point.x, point.y, point.fx, point.fy, point.energy})
            append(table, value, ',');
        append(table, point.lateness, '\n');
    }
    return table;
}

} // namespace tp
