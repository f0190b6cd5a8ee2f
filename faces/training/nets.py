# SPDX-License-Identifier: Apache-2.0
"""The nets, of layers that OpenCV 4.6 runs from ONNX opset 11.

Input: B × 3 × size × size, (BGR − 127.5) / 255. A contour net answers B × 2n, each point as fractions of the window's
side from its middle. Nets of what lies before a face answer a number for each kind. The detector answers B × 8 × h/8 × w/8: score, centre (2), size, eyes (4); `detector_scenes.py`.
"""
import cv2
import torch
from torch import nn
from torch.nn import functional


def convolution(inputs, outputs, stride=1):
    return nn.Sequential(nn.Conv2d(inputs, outputs, 3, stride, 1, bias=False), nn.BatchNorm2d(outputs), nn.ReLU(True))


class Residual(nn.Module):
    """Two convolutions around which the input is added (He et al. 2016)."""

    def __init__(self, width):
        super().__init__()
        self.layers = nn.Sequential(convolution(width, width), nn.Conv2d(width, width, 3, 1, 1, bias=False),
                                    nn.BatchNorm2d(width))

    def forward(self, x):
        return functional.relu(x + self.layers(x))


class ContourNet(nn.Module):
    """Halves the window once per width, with a residual block at each width but the first, squeezes what is left to
    `squeeze` channels, then one linear layer gives the points. Plain convolutions, because on a processor their few
    large steps train faster than the many thin ones of depthwise nets."""

    def __init__(self, points, size, widths, squeeze):
        super().__init__()
        self.size = size
        layers, inputs = [], 3
        for i, width in enumerate(widths):
            layers.append(convolution(inputs, width, 2))
            if i > 0:
                layers.append(Residual(width))
            inputs = width
        cells = -(-size // 2 ** len(widths))
        self.features = nn.Sequential(*layers)
        self.squeeze = nn.Conv2d(inputs, squeeze, 1)
        self.points = nn.Linear(squeeze * cells * cells, 2 * points)
        nn.init.normal_(self.points.weight, 0.0, 0.01)

    def forward(self, x):
        return self.points(functional.relu(self.squeeze(self.features(x))).flatten(1))


class CoverNet(ContourNet):
    """The same layers, which answer some numbers, each above 0 where something of a kind lies before the face."""

    def __init__(self, kinds, size, widths, squeeze, forgets=0.0):
        """`forgets`: share of what the last layer is not shown while it learns."""
        super().__init__(1, size, widths, squeeze)
        self.forget = nn.Dropout(forgets)
        self.points = nn.Linear(self.points.in_features, kinds)
        nn.init.normal_(self.points.weight, 0.0, 0.01)

    def forward(self, x):
        return self.points(self.forget(functional.relu(self.squeeze(self.features(x)))).flatten(1))


class Detector(nn.Module):
    """Answers in cells of 8 px, which also see what lies around them at 1/32."""
    CHANNELS = 8

    def __init__(self):
        super().__init__()
        self.near = nn.Sequential(convolution(3, 16, 2), convolution(16, 24, 2), convolution(24, 40, 2), Residual(40))
        self.far = nn.Sequential(convolution(40, 64, 2), Residual(64), convolution(64, 64, 2), Residual(64))
        self.joint = nn.Conv2d(64, 40, 1)
        self.answer = nn.Sequential(convolution(40, 40), nn.Conv2d(40, self.CHANNELS, 1))
        nn.init.zeros_(self.answer[-1].bias)
        self.answer[-1].bias.data[0] = -4.0  # at first there is a face nowhere

    def forward(self, x):
        near = self.near(x)
        around = functional.interpolate(self.joint(self.far(near)), scale_factor=4.0, mode="nearest")
        return self.answer(near + around)


def layers_of(net):
    """The convolutions and linear layers in the order in which they are run, each with its batch normalisation or None."""
    modules = [m for m in net.modules() if isinstance(m, (nn.Conv2d, nn.Linear, nn.BatchNorm2d))]
    return [(m, after if isinstance(after, nn.BatchNorm2d) else None)
            for m, after in zip(modules, modules[1:] + [None]) if not isinstance(m, nn.BatchNorm2d)]


def started_from(net, file, pixels):
    """The net with the weights of an exported one of its kind, to be trained on. In an exported net the normalisations
    are part of the convolutions; here they get the means and variances that `pixels` (B, 3, s, s) have, and answer as before."""
    exported = cv2.dnn.readNetFromONNX(str(file))
    stored = [exported.getLayer(i) for i in range(1, len(exported.getLayerNames()) + 1)]
    stored = [layer.blobs for layer in stored if layer.type in ("Convolution", "InnerProduct")]
    layers = layers_of(net)
    if len(stored) == len(layers) + 1:  # `factorised`
        narrow, wide = stored[-2:]
        stored[-2:] = [(wide[0] @ narrow[0], wide[1])]
    if [blobs[0].size for blobs in stored] != [layer.weight.numel() for layer, _ in layers]:
        raise SystemExit(f"{file} has other layers than the net that is to be trained.")
    for (layer, norm), blobs in zip(layers, stored):
        layer.weight.data = torch.from_numpy(blobs[0].reshape(layer.weight.shape).copy())
        bias = torch.from_numpy(blobs[1].reshape(-1).copy())
        if norm is None:
            layer.bias.data = bias
        else:
            norm.bias.data = bias
            norm.register_forward_pre_hook(normalises_what_it_sees)
    with torch.no_grad():
        net.eval()(pixels)
    for _, norm in layers:
        if norm is not None:
            norm._forward_pre_hooks.clear()
    return net


def normalises_what_it_sees(norm, inputs):
    variance, mean = torch.var_mean(inputs[0], (0, 2, 3), unbiased=False)
    norm.running_mean.copy_(mean)
    norm.running_var.copy_(variance)
    norm.weight.data = (variance + norm.eps).sqrt()
    norm.bias.data = norm.bias.data + mean


def factorised(net, rank):
    """The same contour net with its last layer as a product of two thin ones: outlines vary in few ways, so most of
    what the layer stores is next to nothing (Denil et al. 2013). Smaller files; the answers hardly change."""
    full = net.points
    left, strength, right = torch.linalg.svd(full.weight.data, full_matrices=False)
    narrow = nn.Linear(full.in_features, rank, bias=False)
    wide = nn.Linear(rank, full.out_features)
    narrow.weight.data = strength[:rank, None] * right[:rank]
    wide.weight.data, wide.bias.data = left[:, :rank].contiguous(), full.bias.data
    net.points = nn.Sequential(narrow, wide)
    return net


def export(net, size, file):
    """ONNX that OpenCV 4.6 reads: opset 11, float32, fixed input size."""
    torch.onnx.export(net.eval(), torch.zeros(1, 3, size, size), str(file), opset_version=11,
                      input_names=["input"], output_names=["output"])
