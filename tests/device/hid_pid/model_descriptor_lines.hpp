// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What the descriptors of the model sticks say (descriptor_lines.hpp): numbers and places as in the reports of JoystickWire.
namespace tp::testing {

inline constexpr const char* open_controller_lines = R"(10004 1 in -1
f0092 2 in 0
f0021 2 in 0
f0025 2 in 2
f0055 2 in 2
f0057 2 in 2
f0058 2 in 2
f0073 2 in 0
f0077 2 in 0
f0078 2 in 8
f0090 2 in 0
f0096 2 in 0
f007d 2 in 0
f00ab 2 in 0
f0025 2 in 13
f0089 2 in 0
f008b 2 in 15
i1 at 0: 64x1 [90001-90040] 0..1 0..0 0e0
i1 at 64: 2x16 [10030 10031] -32767..32767 0..0 0e0
i2 at 0: 4x1 [f009f f00a0 f00a4 f00a6] 0..1 0..0 0e0
i2 at 4: 4x1 -[] 0..1 0..0 0e0
o1 at 0: 1x8 [f0022] 1..40 0..0 0e0
o1 at 8: 1x8 a[f0026 f0027] 1..2 0..0 0e0
o1 at 16: 4x16 [f0050 f0054 f0051 f00a7] 0..32767 0..0 0e0
o1 at 80: 1x8 [f0052] 0..255 0..0 0e0
o1 at 88: 1x8 [f0053] 1..8 0..0 0e0
o1 at 96: 2x1 [10030 10031] 0..1 0..0 0e0
o1 at 98: 1x1 [f0056] 0..1 0..0 0e0
o1 at 99: 5x1 -[] 0..1 0..0 0e0
o1 at 104: 2x16 [a0001 a0002] 0..36000 0..0 0e0
o1 at 136: 2x16 [a0001 a0002] 0..32765 0..0 0e0
o5 at 0: 1x8 [f0022] 1..40 0..0 0e0
o5 at 8: 1x16 [f0070] -32767..32767 0..0 0e0
o10 at 0: 1x8 [f0022] 1..40 0..0 0e0
o10 at 8: 1x8 a[f0079 f007a f007b] 1..3 0..0 0e0
o10 at 16: 1x8 [f007c] 0..255 0..0 0e0
o11 at 0: 1x8 [f0022] 1..40 0..0 0e0
o12 at 0: 1x8 a[f0097 f0098 f0099 f009a f009b f009c] 1..6 0..0 0e0
o13 at 0: 1x8 [f007e] 0..255 0..0 0e0
f17 at 0: 1x8 a[f0026 f0027] 1..2 0..0 0e0
f17 at 8: 1x16 -[] 1..2 0..0 0e0
f18 at 0: 1x8 [f0022] 1..40 0..0 0e0
f18 at 8: 1x8 a[f008c f008d f008e] 1..3 0..0 0e0
f18 at 16: 1x16 [f00ac] 0..65535 0..0 0e0)";

inline constexpr const char* plain_controller_lines = R"(10004 1 in -1
f0021 2 in 0
f0025 2 in 1
f0055 2 in 1
f0057 2 in 1
f0073 2 in 0
f0077 2 in 0
f0078 2 in 6
f0090 2 in 0
f0095 2 in 0
f007d 2 in 0
f00ab 2 in 0
f0025 2 in 11
f0089 2 in 0
f008b 2 in 13
i1 at 0: 64x1 [90001-90040] 0..1 0..0 0e0
i1 at 64: 2x16 [10030 10031] -32767..32767 0..0 0e0
o1 at 0: 1x8 [f0022] 1..40 0..0 0e0
o1 at 8: 1x8 a[f0026 f0027] 1..2 0..0 0e0
o1 at 16: 3x16 [f0050 f0054 f0051] 0..32767 0..0 0e0
o1 at 64: 1x8 [f0052] 0..255 0..0 0e0
o1 at 72: 1x8 [f0053] 1..8 0..0 0e0
o1 at 80: 2x1 [10030 10031] 0..1 0..0 0e0
o1 at 82: 1x1 [f0056] 0..1 0..0 0e0
o1 at 83: 5x1 -[] 0..1 0..0 0e0
o1 at 88: 2x16 [a0001 a0002] 0..36000 0..0 0e0
o5 at 0: 1x8 [f0022] 1..40 0..0 0e0
o5 at 8: 1x16 [f0070] -32767..32767 0..0 0e0
o10 at 0: 1x8 [f0022] 1..40 0..0 0e0
o10 at 8: 1x8 a[f0079 f007a f007b] 1..3 0..0 0e0
o10 at 16: 1x8 [f007c] 0..255 0..0 0e0
o11 at 0: 1x8 [f0022] 1..40 0..0 0e0
o12 at 0: 6x1 [f0097 f0098 f0099 f009a f009b f009c] 0..1 0..0 0e0
o12 at 6: 2x1 -[] 0..1 0..0 0e0
o13 at 0: 1x8 [f007e] 0..255 0..0 0e0
f17 at 0: 1x8 a[f0026 f0027] 1..2 0..0 0e0
f17 at 8: 1x16 -[] 1..2 0..0 0e0
f18 at 0: 1x8 [f0022] 1..40 0..0 0e0
f18 at 8: 1x8 a[f008c f008d f008e] 1..3 0..0 0e0
f18 at 16: 1x16 [f00ac] 0..65535 0..0 0e0)";

} // namespace tp::testing
