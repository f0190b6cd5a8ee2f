// SPDX-License-Identifier: Apache-2.0
#include "app/devices/device_words.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace tp {

namespace {

/// The sentences of core/servo/fault.cpp, device/open_problem.cpp, device/force_pad and
/// core/geometry/calibration.cpp, word for word: a test compares them.
constexpr std::array device_sources{
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force was switched off for a moment, because a measurement was not a number."),
    QT_TRANSLATE_NOOP("tp::Problems", "The force is off, because the finger is outside the area that the device reaches. "
                                      "Move it back."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force is off, because the finger moves too fast. Move slowly and it comes back."),
    QT_TRANSLATE_NOOP("tp::Problems", "The force is off, because the device has switched its motors off to be safe. It "
                                      "comes back when the device is ready."),
    QT_TRANSLATE_NOOP("tp::Problems", "The force is off, because the device does not say where the finger is."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force is off for a moment, because this computer was too busy to guide the finger."),
    QT_TRANSLATE_NOOP("tp::Problems", "The device was switched off, because this computer stood still. Start it again "
                                      "when you are ready."),
    QT_TRANSLATE_NOOP("tp::Problems", "The device was switched off, because it no longer answers. Check its cable and "
                                      "start it again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "You may not use the force pad yet. Copy resources/udev/70-touchphoto.rules to "
                      "/etc/udev/rules.d, then unplug the device and plug it in again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "Windows does not let this program use the force pad. Unplug it and plug it in again; if that does "
                      "not help, close other programs that use it."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "macOS does not let this program use the force pad. Allow it under System Settings, Privacy & "
                      "Security, Input Monitoring, and start it again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "Another driver of the system holds the force pad. Unplug the device and plug it in again; if that "
                      "does not help, its kernel must have the hidraw driver."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad has the wrong driver. In the Device Manager choose Update driver, then \"USB "
                      "Input Device\"."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "Another driver holds the force pad. Remove the driver that its maker installed and start this "
                      "computer again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "Another driver of the system holds the force pad and does not let go of it. Unplug the device, "
                      "unload that driver and plug the device in again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad has the wrong driver. In the Device Manager choose Update driver, then \"WinUsb "
                      "Device\"."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "Another program uses the force pad. Close that program and try again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad was unplugged. Plug it in again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad could not be opened. Unplug it, plug it in again and try once more."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad does not know where its knob is. Put the knob on its mark and home the pad."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad's encoders contradict each other: a cable is slack, or one has slipped. Put the "
                      "knob on its mark and home the pad."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad's motors are too hot. It goes on by itself when they have cooled."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "A motor of the force pad took too much current. See that nothing blocks the knob."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad heard nothing from this computer for a moment and switched its motors off."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad's motors are off."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The device with a force pad's ids does not answer like a force pad. Unplug it and plug it in "
                      "again; if it is no force pad, choose another device."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "The force pad did not say which places it reaches. Unplug it and plug it in again."),
    QT_TRANSLATE_NOOP("tp::Problems",
                      "force pad"),
    QT_TRANSLATE_NOOP("tp::Problems", "A calibration sample is no place; touch the marks again."),
    QT_TRANSLATE_NOOP("tp::Problems", "Calibration needs at least three marks that do not lie on one line; touch more "
                                      "marks."),
    QT_TRANSLATE_NOOP("tp::Problems", "Too many touches do not fit together. Touch the marks again with the finger in the "
                                      "device, and with no other."),
};

} // namespace

QString fault_words(Fault fault) { return device_words(sentence(fault)); }

QString device_words(const std::string& words) {
    return words.empty() ? QString() : QCoreApplication::translate("tp::Problems", words.c_str());
}

bool is_device_words(const std::string& words) {
    return std::ranges::any_of(device_sources, [&](const char* source) { return words == source; });
}

} // namespace tp
