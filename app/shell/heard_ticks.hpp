// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audio/guide/click_sound.hpp"
#include "device/touch_output/drawn/drawn_touch.hpp"

#include <memory>

namespace tp {

/// Lets the ticks of a drawn finger be heard.
class HeardTicks final : public TickListener {
public:
    /// `sound` must outlive every output that tells this.
    explicit HeardTicks(ClickSound& sound) : sound_(sound), list_(sound.list()) {}

    void begin() override;
    void end() override;
    void ticked(const Tick& tick, double time) noexcept override;
    void hush() noexcept override { list_->hush(); }

private:
    ClickSound& sound_;
    std::shared_ptr<ClickList> list_;
};

} // namespace tp
