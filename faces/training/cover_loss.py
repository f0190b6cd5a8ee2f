# SPDX-License-Identifier: Apache-2.0
"""What nets of what lies before a face are trained for."""
from torch.nn import functional


def cover_loss(answer, batch):
    """Logistic loss. The figure is the share of wrong answers."""
    _, there = batch
    wrong = ((answer.detach() > 0.0).float() != there).float().mean().item()
    return functional.binary_cross_entropy_with_logits(answer, there), wrong
