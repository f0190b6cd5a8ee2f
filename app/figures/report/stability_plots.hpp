// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/figures/report/delivered_force.hpp"
#include "app/figures/report/loop_work.hpp"
#include "app/figures/report/passivity.hpp"
#include "app/figures/report/released_handle.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <utility>
#include <vector>

namespace tp {

/// Work round loops and force error over vertex spacing, one line a law: loop_work.png and .svg in `folder`.
Result<std::filesystem::path> plot_loop_work(const std::filesystem::path& folder,
                                             const std::vector<LoopWork>& rows);

/// Which handles settle, over device damping and the bound K (T/2 + nT), without and with observer and
/// damping, the bound drawn in: released_handle.png and .svg in `folder`.
Result<std::filesystem::path>
plot_released_handle(const std::filesystem::path& folder,
                     const std::vector<std::pair<HandleCase, HandleResult>>& rows);

/// Work of the force in a cycle over frequency, a panel a delay, a line a part: passivity.png and .svg in `folder`.
Result<std::filesystem::path> plot_passivity(const std::filesystem::path& folder,
                                             const std::vector<PassivityRow>& rows);

/// Delivered error over speed, a line a device and the law's own: delivered.png and .svg in `folder`.
Result<std::filesystem::path> plot_delivered(const std::filesystem::path& folder,
                                             const std::vector<DeliveredRow>& rows);

} // namespace tp
