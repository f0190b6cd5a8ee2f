// SPDX-License-Identifier: Apache-2.0
#include "core/servo/fault.hpp"

namespace tp {

const char* sentence(Fault fault) {
    switch (fault) {
    case Fault::none:
        return "";
    case Fault::not_a_number:
        return "The force was switched off for a moment, because a measurement was not a number.";
    case Fault::outside_workspace:
        return "The force is off, because the finger is outside the area that the device reaches. Move it "
               "back.";
    case Fault::over_speed:
        return "The force is off, because the finger moves too fast. Move slowly and it comes back.";
    case Fault::motors_off:
        return "The force is off, because the device has switched its motors off to be safe. It comes back when "
               "the device is ready.";
    case Fault::stale_input:
        return "The force is off, because the device does not say where the finger is.";
    case Fault::late_ticks:
        return "The force is off for a moment, because this computer was too busy to guide the finger.";
    case Fault::stalled:
        return "The device was switched off, because this computer stopped responding for a while. Start it "
               "again when you are ready.";
    case Fault::device_lost:
        return "The device was switched off, because it no longer answers. Check its cable and start it "
               "again.";
    }
    return "";
}

} // namespace tp
