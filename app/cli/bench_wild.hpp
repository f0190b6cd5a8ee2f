// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

class VerbLine;

/// `bench faces --wild`: measures photographs without truth, with the options wild, only, labels and out of
/// `line`. Returns an ExitCode, or a shell's word for the signal that ended it early.
int bench_wild(const VerbLine& line);

} // namespace tp
