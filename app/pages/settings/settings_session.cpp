// SPDX-License-Identifier: Apache-2.0
#include "app/pages/settings/settings_session.hpp"

#include <utility>

namespace tp {

SettingsSession::SettingsSession(Narrator& narrator, Preferences& preferences, StorageSettings::Stored stored,
                                 DeviceSettings::Setup devices, TickSettings::Setup ticks)
    : narrator_(narrator), steps_(narrator, preferences), speech_(steps_), looks_(steps_),
      devices_(narrator, preferences, std::move(devices)), ticks_(steps_, narrator, std::move(ticks)),
      feeling_(steps_, devices_), storage_(steps_, narrator, std::move(stored), devices_.calibrations()) {}

void SettingsSession::enter() {
    steps_.tell(tr(
        "Settings. Go through them with Tab; every change is saved at once. Control+Z undoes the last one."));
    storage_.enter();
    devices_.enter();
    ticks_.enter();
}

void SettingsSession::leave() {
    devices_.leave();
    ticks_.leave();
    narrator_.stop();
    storage_.leave();
}

bool SettingsSession::back() { return devices_.stop() || ticks_.stop() || storage_.cancel(); }

} // namespace tp
