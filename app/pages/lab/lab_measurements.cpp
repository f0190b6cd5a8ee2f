// SPDX-License-Identifier: Apache-2.0
#include "app/pages/lab/lab_measurements.hpp"

#include "app/pages/lab/lab_words.hpp"

namespace tp {

namespace {

constexpr int polls_a_plot = 5;     ///< 80 ms
constexpr int polls_a_reading = 31; ///< half a second

} // namespace

LabMeasurements::LabMeasurements(LabTeller& teller) : teller_(teller) { read_out(); }

void LabMeasurements::read_out() {
    readings_.clear();
    for (const Quantity quantity : {Position, Force, Energy, Lateness})
        readings_ << plot_words(trace_, static_cast<TraceQuantity>(quantity));
    emit readingsChanged();
}

void LabMeasurements::poll() {
    ++polls_;
    if (polls_ % polls_a_plot == 0)
        emit plotted();
    if (polls_ % polls_a_reading == 0)
        read_out();
}

void LabMeasurements::renew() {
    read_out();
    emit plotted();
}

void LabMeasurements::readPlots() {
    read_out();
    teller_.tell(readings_.join(' '));
}

} // namespace tp
