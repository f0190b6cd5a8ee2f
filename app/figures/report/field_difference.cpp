// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/field_difference.hpp"

#include <algorithm>
#include <vector>

namespace tp {

namespace {

class DifferenceLaw final : public GuidanceLaw {
public:
    DifferenceLaw(const GuidanceLaw& before, const GuidanceLaw& after) : before_(before), after_(after) {}
    Guidance at(Vec2 finger) const noexcept override {
        Guidance guidance = after_.at(finger);
        guidance.force -= before_.force_at(finger);
        return guidance;
    }
    Vec2 force_at(Vec2 finger) const noexcept override {
        return after_.force_at(finger) - before_.force_at(finger);
    }

private:
    const GuidanceLaw& before_;
    const GuidanceLaw& after_;
};

} // namespace

FieldDifference difference_between(const GuidanceLaw& before, const GuidanceLaw& after,
                                   const Rect& surface_mm) {
    constexpr double step_mm = 0.5;
    FieldDifference difference;
    std::vector<double> sizes;
    std::size_t places = 0;
    std::size_t felt = 0;
    double sum = 0.0;
    for (double y = surface_mm.min.y; y <= surface_mm.max.y; y += step_mm)
        for (double x = surface_mm.min.x; x <= surface_mm.max.x; x += step_mm) {
            ++places;
            const Vec2 one = before.force_at({x, y});
            const Vec2 other = after.force_at({x, y});
            if (one == Vec2(0.0) && other == Vec2(0.0))
                continue;
            sizes.push_back(length(other - one));
            sum += sizes.back();
            felt += sizes.back() > FieldDifference::noticed_n ? 1 : 0;
        }
    if (sizes.empty())
        return difference;
    difference.mean_n = sum / static_cast<double>(sizes.size());
    difference.felt_share = static_cast<double>(felt) / static_cast<double>(places);
    difference.max_n = *std::max_element(sizes.begin(), sizes.end());
    const auto p99 =
        sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), p99, sizes.end());
    difference.p99_n = *p99;
    return difference;
}

std::unique_ptr<const GuidanceLaw> difference_law(const GuidanceLaw& before, const GuidanceLaw& after) {
    return std::make_unique<DifferenceLaw>(before, after);
}

} // namespace tp
