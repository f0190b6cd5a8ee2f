// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/imgproc.hpp>

#include <string>

/// A small Haar cascade, for tests that need one: it takes bright squares on dark ground for faces.
namespace square_cascade {

/// In a window of 24 px, the mean of its middle is far above that of the whole.
inline const std::string xml = R"(<?xml version="1.0"?>
<!-- bright squares -->
<opencv_storage>
<cascade type_id="opencv-cascade-classifier"><stageType>BOOST</stageType>
  <featureType>HAAR</featureType>
  <height>24</height>
  <width>24</width>
  <stageParams>
    <maxWeakCount>1</maxWeakCount></stageParams>
  <featureParams>
    <maxCatCount>0</maxCatCount></featureParams>
  <stageNum>2</stageNum>
  <stages>
    <_>
      <maxWeakCount>1</maxWeakCount>
      <stageThreshold>5.0000000000000000e-01</stageThreshold>
      <weakClassifiers>
        <_>
          <internalNodes>
            0 -1 0 1.6000000238418579e+00</internalNodes>
          <leafValues>
            -1. 1.</leafValues></_></weakClassifiers></_>
    <_>
      <maxWeakCount>1</maxWeakCount>
      <stageThreshold>5.0000000000000000e-01</stageThreshold>
      <weakClassifiers>
        <_>
          <internalNodes>
            0 1 0 1. -1 -2 1 0.</internalNodes>
          <leafValues>
            -1. 1. 1.</leafValues></_></weakClassifiers></_></stages>
  <features>
    <_>
      <rects>
        <_>
          0 0 24 24 -1.</_>
        <_>
          6 6 12 12 4.</_></rects></_>
    <_>
      <rects>
        <_>
          12 2 10 10 1.</_></rects>
      <tilted>1</tilted></_></features></cascade>
</opencv_storage>
)";

/// A bright square of `side` px around a place.
inline cv::Mat picture(cv::Size size, cv::Point centre, int side) {
    cv::Mat drawn(size, CV_8UC3, cv::Scalar::all(20));
    cv::rectangle(drawn, {centre.x - side / 2, centre.y - side / 2, side, side}, cv::Scalar::all(230),
                  cv::FILLED);
    return drawn;
}

} // namespace square_cascade
