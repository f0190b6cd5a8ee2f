// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

class VerbLine;

/// `bench faces --identity`: how well portraits of the same person are told from others, with the options identity and
/// out of `line`. Returns an ExitCode, or a shell's word for the signal that ended it early.
int bench_identity(const VerbLine& line);

} // namespace tp
