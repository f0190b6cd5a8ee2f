// SPDX-License-Identifier: Apache-2.0
#include "app/shell/heard_ticks.hpp"

#include <QMetaObject>

namespace tp {

void HeardTicks::begin() { QMetaObject::invokeMethod(&sound_, &ClickSound::begin, Qt::QueuedConnection); }

void HeardTicks::end() { QMetaObject::invokeMethod(&sound_, &ClickSound::end, Qt::QueuedConnection); }

void HeardTicks::ticked(const Tick& tick, double time) noexcept {
    list_->push({time, tick.amplitude(), tick.sharpness(), tick.seconds()});
}

} // namespace tp
