# SPDX-License-Identifier: Apache-2.0
"""The training loop that all nets share: AdamW, cosine schedule, averaged weights, checkpoints, a log.

What is kept is the moving average of the weights, which generalises better than the last ones. A run that was stopped
goes on from its last checkpoint and ends with the same weights as one that was not.
"""
import copy
import math
import time
from concurrent.futures import ThreadPoolExecutor

import torch
from torch import nn

WARM_UP, CHECKPOINT_EVERY, LOG_EVERY = 100, 500, 200
AVERAGE_OVER = 0.998  # share of the average that a step keeps
LARGEST_GRADIENT = 5.0


def rate_at(step, rounds):
    """Learning rate: in each round of (steps, highest rate) it rises for `WARM_UP` steps and falls as a cosine
    (Loshchilov and Hutter 2017)."""
    for steps, highest in rounds:
        if step < steps:
            break
        step -= steps
    return highest * min(1.0, (step + 1) / WARM_UP) * 0.5 * (1.0 + math.cos(math.pi * step / steps)) + 1e-5


def update_average(average, net, step):
    keep = min(AVERAGE_OVER, (step + 1) / (step + 20))
    with torch.no_grad():
        for old, new in zip(average.state_dict().values(), net.state_dict().values()):
            if old.dtype.is_floating_point:
                old.mul_(keep).add_(new, alpha=1.0 - keep)
            else:
                old.copy_(new)


def train(net, batches, loss_of, rounds, checkpoint, log):
    """Trains for some rounds of (steps, highest rate); `loss_of(answer, batch)` gives the loss and a figure for the
    log. Returns the averaged net, in evaluation mode."""
    steps = sum(count for count, _ in rounds)
    net = net.to(memory_format=torch.channels_last)
    average = copy.deepcopy(net)
    optimiser = torch.optim.AdamW(net.parameters(), rounds[0][1], weight_decay=1e-3)
    first = 0
    if checkpoint.exists():
        kept = torch.load(checkpoint)
        net.load_state_dict(kept["net"])
        average.load_state_dict(kept["average"])
        optimiser.load_state_dict(kept["optimiser"])
        first = kept["step"]
        log(f"goes on at step {first} of {steps}")
    net.train()
    started, shown = time.monotonic(), 0.0
    with ThreadPoolExecutor(1) as ahead:
        coming = ahead.submit(batches, first)
        for step in range(first, steps):
            batch = [torch.from_numpy(part) for part in coming.result()]
            coming = ahead.submit(batches, step + 1)
            for group in optimiser.param_groups:
                group["lr"] = rate_at(step, rounds)
            loss, figure = loss_of(net(batch[0].contiguous(memory_format=torch.channels_last)), batch)
            optimiser.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(net.parameters(), LARGEST_GRADIENT)
            optimiser.step()
            update_average(average, net, step)
            shown += figure
            done = step + 1
            if done % LOG_EVERY == 0:
                rate = (done - first) * len(batch[0]) / (time.monotonic() - started)
                log(f"step {done} of {steps}: {shown / LOG_EVERY:.3f}, {rate:.0f} pictures/s")
                shown = 0.0
            if done % CHECKPOINT_EVERY == 0 or done == steps:
                save(checkpoint, net, average, optimiser, done)
    return average.eval()


def save(checkpoint, net, average, optimiser, step):
    partial = checkpoint.with_suffix(".partial")
    torch.save({"net": net.state_dict(), "average": average.state_dict(), "optimiser": optimiser.state_dict(),
                "step": step}, partial)
    partial.replace(checkpoint)


ALONG = 0.3  # weight of an error along the line: it moves the point, not the contour
BEND, KNEE = 0.5, 2.0  # px


def contour_loss(size):
    """Errors across the line count fully, along it little. Wing-like (Feng et al. 2018): steep below `BEND` px, so
    that the last half pixel still matters; linear above `KNEE`. The figure is the mean distance in px."""
    def wing(px):
        steep = 2.0 * KNEE * torch.log1p(px / BEND)
        return torch.where(px < KNEE, steep, px - KNEE + 2.0 * KNEE * math.log1p(KNEE / BEND))

    def loss_of(answer, batch):
        _, points, along = batch
        error = (answer.view_as(points) - points) * size
        has_line = (along.abs().sum(2) > 0).float()
        tangential = (error * along).sum(2)
        across = (error - tangential.unsqueeze(2) * along).pow(2).sum(2).add(1e-6).sqrt()
        loss = wing(across) + ALONG * has_line * wing(tangential.abs())
        return loss.mean(), across.detach().mean().item()
    return loss_of


def detector_loss(answer, batch):
    """Focal loss of the score, gentle on the cells beside a centre (Law and Deng 2018), and mean errors of the other
    answers where there is a face. The figure is the sum."""
    _, score, values, counts = batch
    chance = torch.sigmoid(answer[:, 0]).clamp(1e-4, 1.0 - 1e-4)
    centre = (score == 1.0).float()
    found = centre * (1.0 - chance) ** 2 * torch.log(chance)
    missed = (1.0 - centre) * (1.0 - score) ** 4 * chance ** 2 * torch.log(1.0 - chance)
    loss = -(found + missed).sum() / centre.sum().clamp(min=1.0)
    loss = loss + ((answer[:, 1:] - values).abs().sum(1) * counts).sum() / counts.sum().clamp(min=1.0)
    return loss, loss.item()
