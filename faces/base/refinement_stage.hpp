// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// How far contours are refined after the first look at a face, each with what stands before it. Only the
/// embedded model looks more than once.
enum class RefinementStage {
    first_look,
    second_look, ///< at the face, from the window that the first one gives
    close_looks, ///< at each eye, the mouth and the outline
    onto_edges   ///< lids and lips, in the picture at full resolution
};

} // namespace tp
