// SPDX-License-Identifier: Apache-2.0
#include "virtual_pad.hpp"

#include "device/force_pad/protocol/usb.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace tp::vm {

namespace {

constexpr std::size_t most_unsaid = 64; ///< frames; of what nobody takes the oldest is dropped
constexpr double walking_speed = 120.0; ///< mm/s, as one sweeps over a picture

const std::string product = "force pad";

/// Soft enough for the pad to draw it.
PadPlant held_knob() {
    PadPlant plant;
    plant.hand_stiffness = 0.15;
    plant.hand_damping = 5.0;
    return plant;
}

std::uint8_t low(unsigned value) { return static_cast<std::uint8_t>(value & 0xFFu); }
std::uint8_t high(unsigned value) { return static_cast<std::uint8_t>(value >> 8); }

} // namespace

VirtualPad::VirtualPad(Polyline way)
    : model_(pad::cable_pad(), held_knob()), hand_(std::move(way), model_.knob(), walking_speed) {}

DeviceSample VirtualPad::step() {
    if (motors_)
        model_.move_hand(hand_.step(0.001));
    model_.step();
    pad::Frame frame;
    while (model_.report(frame)) {
        pad::StateFrame state;
        if (pad::decode(frame, state))
            motors_ = (state.status & pad::status::armed) != 0;
        if (silent_)
            continue;
        unsaid_.push_back(frame);
        if (unsaid_.size() > most_unsaid)
            unsaid_.pop_front();
    }
    DeviceSample sample;
    sample.force = model_.force();
    sample.handle = model_.knob();
    sample.motors = motors_;
    return sample;
}

void VirtualPad::hear(std::span<const std::uint8_t> bytes) {
    if (bytes.size() != pad::frame_size)
        return;
    pad::Frame frame;
    std::copy(bytes.begin(), bytes.end(), frame.bytes);
    model_.receive(frame);
}

std::optional<pad::Frame> VirtualPad::say() {
    if (unsaid_.empty())
        return std::nullopt;
    const pad::Frame frame = unsaid_.front();
    unsaid_.pop_front();
    return frame;
}

HidModel::Identity PadOverHid::identity() const {
    return {pad::usb_vendor, pad::usb_product, product, pad::cable_pad().serial, pad::report_descriptor};
}

void PadOverHid::output(std::span<const std::uint8_t> report) {
    if (!report.empty())
        pad_.hear(report.subspan(1));
}

bool PadOverHid::input(Bytes& report) {
    const auto frame = pad_.say();
    if (frame)
        report.assign(frame->bytes, frame->bytes + pad::frame_size);
    return frame.has_value();
}

UsbModel::Descriptors PadOverBulk::descriptors() const {
    Descriptors all;
    all.device = {18,
                  1,
                  0x00,
                  0x02,
                  0,
                  0,
                  0,
                  64,
                  low(pad::usb_vendor),
                  high(pad::usb_vendor),
                  low(pad::usb_product),
                  high(pad::usb_product),
                  0x00,
                  0x01,
                  1,
                  2,
                  3,
                  1};
    all.configuration = {9,
                         2,
                         32,
                         0,
                         1,
                         1,
                         0,
                         0x80,
                         45, //
                         9,
                         4,
                         0,
                         0,
                         2,
                         pad::bulk_class,
                         pad::bulk_subclass,
                         pad::bulk_protocol,
                         0, //
                         7,
                         5,
                         pad::bulk_in,
                         2,
                         64,
                         0,
                         0, //
                         7,
                         5,
                         pad::bulk_out,
                         2,
                         64,
                         0,
                         0};
    all.strings = {"touchphoto", product, pad::cable_pad().serial};
    return all;
}

void PadOverBulk::output(unsigned endpoint, std::span<const std::uint8_t> bytes) {
    if (endpoint == pad::bulk_out)
        pad_.hear(bytes);
}

bool PadOverBulk::input(unsigned endpoint, std::size_t most, Bytes& bytes) {
    if (endpoint != (pad::bulk_in & 0x0Fu) || most < pad::frame_size)
        return false;
    const auto frame = pad_.say();
    if (frame)
        bytes.assign(frame->bytes, frame->bytes + pad::frame_size);
    return frame.has_value();
}

} // namespace tp::vm
