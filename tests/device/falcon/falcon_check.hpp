// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tp::test {

/// What does not hold for these bytes from a line; empty where all is well. They go through the stream as
/// packets of a Falcon, with their frame made right too, and through the kinematics; they are what comes back
/// while it is started; and a model Falcon hears them.
std::string complaint_about_falcon_bytes(std::string_view bytes);

} // namespace tp::test
