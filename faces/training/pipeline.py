# SPDX-License-Identifier: Apache-2.0
"""The nets one after the other, as `faces/contours/contour_nets.cpp` runs them, from ONNX files through OpenCV."""
import cv2

from contours import MOUTH, SLICES
from crops import (EYE_PX, FACE_PX, MOUTH_PX, OUTLINE_PX, box_frame, eye_frame, face_frame, mapped, mouth_frame,
                   outline_frame, take_crop)


class Pipeline:
    def __init__(self, models):
        """Without `outline.onnx` the outline of the face net stands, as it does for the mouth and the eyes."""
        self.nets = {}
        for name in ("contours", "eye", "mouth", "outline"):
            if (models / f"{name}.onnx").exists():
                self.nets[name] = cv2.dnn.readNetFromONNX(str(models / f"{name}.onnx"))

    def look(self, name, picture, frame, size):
        crop, to_picture = take_crop(picture, frame, size)
        self.nets[name].setInput(cv2.dnn.blobFromImage(crop, 1.0 / 255.0, mean=(127.5, 127.5, 127.5)))
        answer = self.nets[name].forward().reshape(-1, 2).astype(float)
        return mapped(to_picture, (answer + 0.5) * size)

    def locate(self, picture, row, passes=1):
        """(140, 2) points from a detector's row: box and marks of the right and left eye."""
        points = self.look("contours", picture, box_frame(row[:4], row[4:6], row[6:8]), FACE_PX)
        points = self.look("contours", picture, face_frame(points), FACE_PX)
        return self.refined(picture, points, passes)

    def refined(self, picture, points, passes=1):
        points = points.copy()
        if "outline" in self.nets:
            points[SLICES["outline"]] = self.look("outline", picture, outline_frame(points), OUTLINE_PX)
        for _ in range(passes):
            if "eye" in self.nets:
                for name in ("right_eye", "left_eye"):
                    frame = eye_frame(points[SLICES[name]], name == "left_eye")
                    points[SLICES[name]] = self.look("eye", picture, frame, EYE_PX)
            if "mouth" in self.nets:
                points[MOUTH] = self.look("mouth", picture, mouth_frame(points[MOUTH]), MOUTH_PX)
        return points
