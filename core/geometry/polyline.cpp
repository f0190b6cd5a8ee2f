// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/polyline.hpp"

#include <algorithm>
#include <limits>

namespace tp {

Vec2 nearest_on_segment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double reach = glm::dot(p - a, along);
    if (!(squared > 0.0) || !(reach > 0.0))
        return a;
    return reach >= squared ? b : a + (reach / squared) * along;
}

double distance_to(const Polyline& line, Vec2 p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < line.segment_count(); ++i)
        best = std::min(best, length(p - nearest_on_segment(line.segment_start(i), line.segment_end(i), p)));
    return best;
}

double length_of(const Polyline& line) {
    double sum = 0.0;
    for (std::size_t i = 0; i < line.segment_count(); ++i)
        sum += length(line.segment_end(i) - line.segment_start(i));
    return sum;
}

Vec2 point_along(const Polyline& line, double arc) {
    const double total = length_of(line);
    if (!(total > 0.0))
        return line.points.front();
    if (line.closed)
        arc -= std::floor(arc / total) * total;
    double left = std::clamp(arc, 0.0, total);
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const Vec2 a = line.segment_start(i);
        const Vec2 b = line.segment_end(i);
        const double step = length(b - a);
        if (left <= step && step > 0.0)
            return a + (left / step) * (b - a);
        left -= step;
    }
    return line.closed ? line.points.front() : line.points.back();
}

double nearest_arc(const Polyline& line, Vec2 p) {
    double best = std::numeric_limits<double>::infinity();
    double arc = 0.0;
    double walked = 0.0;
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const Vec2 a = line.segment_start(i);
        const Vec2 b = line.segment_end(i);
        const Vec2 q = nearest_on_segment(a, b, p);
        const double distance = length(p - q);
        if (distance < best) {
            best = distance;
            arc = walked + length(q - a);
        }
        walked += length(b - a);
    }
    return arc;
}

Polyline resampled(const Polyline& line, std::size_t count) {
    Polyline result{{}, line.closed};
    result.points.reserve(count);
    const double total = length_of(line);
    const std::size_t gaps = line.closed ? count : count - 1;
    std::size_t segment = 0;
    double walked = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        const double arc = total * static_cast<double>(k) / static_cast<double>(gaps);
        if (!line.closed && k + 1 == count) {
            result.points.push_back(line.points.back());
            break;
        }
        while (segment + 1 < line.segment_count()) {
            const double step = length(line.segment_end(segment) - line.segment_start(segment));
            if (walked + step >= arc)
                break;
            walked += step;
            ++segment;
        }
        const Vec2 a = line.segment_start(segment);
        const Vec2 b = line.segment_end(segment);
        const double step = length(b - a);
        const double share = step > 0.0 ? std::clamp((arc - walked) / step, 0.0, 1.0) : 0.0;
        result.points.push_back(a + share * (b - a));
    }
    return result;
}

Rect bounds_of(const std::vector<Vec2>& points) {
    if (points.empty())
        return {};
    Rect box{points.front(), points.front()};
    for (const Vec2 p : points) {
        box.min = glm::min(box.min, p);
        box.max = glm::max(box.max, p);
    }
    return box;
}

} // namespace tp
