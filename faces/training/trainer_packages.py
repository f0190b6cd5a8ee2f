# SPDX-License-Identifier: Apache-2.0
"""Says what to install when packages of the trainer are missing: those of packaging/packages/train.txt."""
import importlib.util
import sys

DEBIAN = {"torch": "python3-torch", "cv2": "python3-opencv", "numpy": "python3-numpy",
          "onnx": "python3-onnx"}


def require(*modules):
    missing = [DEBIAN[module] for module in modules if importlib.util.find_spec(module) is None]
    if missing:
        sys.exit(f"This needs {' and '.join(missing)}; on Debian: apt-get install {' '.join(missing)}")
