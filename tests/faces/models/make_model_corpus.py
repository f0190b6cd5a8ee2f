#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the corpora of fuzz_onnx_file, fuzz_haar_file and fuzz_lbf_file: the smallest files of each kind that are taken.

    tests/faces/models/make_model_corpus.py        writes tests/faces/models/{onnx,haar,lbf}_corpus
"""
import base64
import struct
from pathlib import Path

HERE = Path(__file__).resolve().parent
SQUARES = HERE.parents[1] / "support/square_cascade.hpp"
LANDMARKS = 68


# Messages of ONNX (onnx.proto3) in protobuf's wire format.
def varint(value: int) -> bytes:
    value &= (1 << 64) - 1
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes(out + bytes([value]))


def number(field: int, value: int) -> bytes:
    return varint(field << 3) + varint(value)


def text(field: int, value: bytes | str) -> bytes:
    value = value.encode() if isinstance(value, str) else value
    return varint(field << 3 | 2) + varint(len(value)) + value


def tensor(name: str, dims: list[int], values: list[int] | list[float]) -> bytes:
    whole = isinstance(values[0], int)
    raw = b"".join(struct.pack("<q" if whole else "<f", v) for v in values)
    return b"".join(number(1, d) for d in dims) + number(2, 7 if whole else 1) + text(8, name) + text(9, raw)


def attribute(name: str, value: int | list[int]) -> bytes:
    if isinstance(value, int):
        return text(1, name) + number(3, value) + number(20, 2)
    return text(1, name) + b"".join(number(8, v) for v in value) + number(20, 7)


def node(kind: str, inputs: list[str], output: str, **attributes: int | list[int]) -> bytes:
    parts = b"".join(text(1, i) for i in inputs) + text(2, output) + text(3, output) + text(4, kind)
    return parts + b"".join(text(5, attribute(n, v)) for n, v in attributes.items())


def value(name: str, dims: list[int]) -> bytes:
    shape = b"".join(text(1, number(1, d)) for d in dims)
    return text(1, name) + text(2, text(1, number(1, 1) + text(2, shape)))


def model(nodes: list[bytes], tensors: list[bytes], shape: list[int], outputs: dict[str, list[int]]) -> bytes:
    graph = b"".join(text(1, n) for n in nodes) + text(2, "net") + b"".join(text(5, t) for t in tensors)
    graph += text(11, value("in", shape)) + b"".join(text(12, value(n, d)) for n, d in outputs.items())
    return number(1, 4) + text(7, graph) + text(8, text(1, "") + number(2, 9))


def mesh(points: int = 478) -> bytes:
    """Its points are pixels of the input."""
    whole = 3 * 256 * 256
    nodes = [
        node("Reshape", ["in", "shape"], "flat"),
        node("Slice", ["flat"], "t473", axes=[1], starts=[0], ends=[3 * points]),
        node("Slice", ["flat"], "t472", axes=[1], starts=[whole - 1], ends=[whole]),
    ]
    return model(nodes, [tensor("shape", [2], [1, whole])], [1, 3, 256, 256], {"t473": [1, 3 * points], "t472": [1, 1]})


def yunet(classes: int = 2) -> bytes:
    """It sees a face wherever the picture is bright."""
    nodes, tensors, parts = [], [], {"loc": [], "conf": [], "iou": []}
    seen = "in"
    for level, anchors in enumerate((3, 2, 2, 3)):
        side = 8 if level == 0 else 2
        nodes.append(node("MaxPool", [seen], f"p{level}", kernel_shape=[side, side], strides=[side, side]))
        seen = f"p{level}"
        for name, numbers in {"loc": 14, "conf": classes, "iou": 1}.items():
            made, channels = f"{name}{level}", anchors * numbers
            tensors.append(tensor(f"{made}w", [channels, 3, 1, 1], [0.0, 0.004, 0.0] * channels))
            nodes += [
                node("Conv", [seen, f"{made}w"], f"{made}c", kernel_shape=[1, 1]),
                node("Transpose", [f"{made}c"], f"{made}t", perm=[0, 2, 3, 1]),
                node("Reshape", [f"{made}t", f"{name}s"], made),
            ]
            parts[name].append(made)
    for name, numbers in {"loc": 14, "conf": classes, "iou": 1}.items():
        tensors.append(tensor(f"{name}s", [3], [1, -1, numbers]))
        nodes.append(node("Concat", parts[name], name, axis=1))
    return model(nodes, tensors, [1, 3, 320, 320], {"loc": [1, 1, 14], "conf": [1, 1, classes], "iou": [1, 1, 1]})


def packed(kind: str, values: list[str], indentation: int) -> str:
    """As cv::FileStorage packs numbers: a head of 24 letters and the bytes, each in base64, 48 bytes a line."""
    content = b"".join(struct.pack("<d", float(value)) if kind == "d" else struct.pack("<i", int(value)) for value in values)
    letters = base64.b64encode(f"1{kind}".ljust(24).encode() + content).decode()
    return "!!binary |\n" + "".join(f"{' ' * indentation}{letters[at : at + 64]}\n" for at in range(0, len(letters), 64))


def facemark_begin(in_base64: bool = False) -> str:
    """The first lines of one stage of one tree for each point; the check adds the others' tables."""

    def listed(kind: str, values: list[str], indentation: int) -> str:
        return packed(kind, values, indentation) if in_base64 else f"[ {', '.join(values)} ]\n"

    def table(name: str, rows: int, columns: int, values: list[str]) -> str:
        data = listed("d", values, 6)
        return f"{name}: !!opencv-matrix\n   rows: {rows}\n   cols: {columns}\n   dt: d\n   data: {data}"

    shape = [f"{x:.3f}" for i in range(LANDMARKS) for x in (-0.8 + 1.6 * (i % 9) / 8.0, -0.8 + 1.6 * (i // 9) / 7.0)]
    shape[2 * 36 : 2 * 36 + 2] = ["-0.500", "-0.300"]
    shape[2 * 45 : 2 * 45 + 2] = ["0.500", "-0.300"]
    head = f"%YAML:1.0\n---\nstages_n: 1\ntree_n: 1\ntree_depth: 2\nn_landmarks: {LANDMARKS}\n"
    tree = table("tree_0_0_0", 4, 4, ["0."] * 4 + ["0.1", "0.2", "-0.1", "0.3"] + ["0."] * 8)
    return head + table("regressor_meanshape", LANDMARKS, 2, shape) + tree + "thresholds_0_0_0: " + listed("i", ["0", "3", "0", "0"], 3)


def main() -> None:
    squares = SQUARES.read_text().split('R"(', 1)[1].split(')"', 1)[0]
    begin, begin_packed = facemark_begin(), facemark_begin(in_base64=True)
    files = {
        "onnx_corpus/mesh.onnx": mesh(),
        "onnx_corpus/mesh_of_68_points.onnx": mesh(68),
        "onnx_corpus/yunet.onnx": yunet(),
        "onnx_corpus/yunet_of_one_class.onnx": yunet(1),
        "onnx_corpus/not_a_net.onnx": b"not a net",
        "haar_corpus/squares.xml": squares.encode(),
        "haar_corpus/other_features.xml": squares.replace("HAAR", "LBP").encode(),
        "lbf_corpus/facemark.yaml": begin.encode(),
        "lbf_corpus/packed.yaml": begin_packed.encode(),
        "lbf_corpus/indented_less.yaml": b"%YAML:1.0\n   s: 1\n ata-: d\n",  # OpenCV's reader never comes to its end
        "lbf_corpus/packed_of_no_kind.yaml": begin_packed.replace("MWkg", "MTkg").encode(),  # of "19": nor here
        "lbf_corpus/two_stages.yaml": begin.replace("stages_n: 1", "stages_n: 2").encode(),
    }
    for name, content in files.items():
        (HERE / name).parent.mkdir(exist_ok=True)
        (HERE / name).write_bytes(content)


if __name__ == "__main__":
    main()
