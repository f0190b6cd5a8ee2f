// SPDX-License-Identifier: Apache-2.0
#include "device/force_pad/firmware/five_bar.hpp"

namespace tp::pad {

template <typename Real>
FiveBarPose<Real> locate(const FiveBar<Real>& bars, const Real (&angles)[arm_count]) {
    FiveBarPose<Real> pose;
    Vec<Real> elbow[arm_count];
    for (int i = 0; i < arm_count; ++i) {
        const SineCosine<Real> turn = sine_cosine(angles[i]);
        elbow[i] = {bars.proximal * turn.cosine + (i == 1 ? bars.base : Real(0)), bars.proximal * turn.sine};
        pose.swing[i] = {-bars.proximal * turn.sine, bars.proximal * turn.cosine};
    }
    const Vec<Real> between = elbow[1] - elbow[0];
    const Real apart = length(between);
    const Real square = bars.distal * bars.distal - Real(0.25) * apart * apart;
    pose.reachable = apart > Real(1e-3) * bars.distal && square >= 0;
    if (!pose.reachable) {
        pose.place = Real(0.5) * (elbow[0] + elbow[1]);
        return pose;
    }
    const Real rise = square_root(square) / apart;
    pose.place = Real(0.5) * (elbow[0] + elbow[1]) + rise * Vec<Real>{-between.y, between.x};
    for (int i = 0; i < arm_count; ++i)
        pose.link[i] = pose.place - elbow[i];
    pose.spread = absolute(cross(pose.link[0], pose.link[1])) / (bars.distal * bars.distal);
    return pose;
}

template <typename Real>
Torques<Real> torques(const FiveBarPose<Real>& pose, Vec<Real> wanted, Real greatest_torque,
                      Real least_spread) {
    Torques<Real> found;
    if (!pose.reachable || !(pose.spread >= least_spread) || !(pose.spread > 0)) {
        found.limited = dot(wanted, wanted) > 0;
        return found;
    }
    // The force is carried by the two distal links: F = c₀·link₀ + c₁·link₁. Virtual work turns each into a
    // torque.
    const Real area = cross(pose.link[0], pose.link[1]);
    const Real carried[arm_count] = {cross(wanted, pose.link[1]) / area, cross(pose.link[0], wanted) / area};
    Real greatest = 0;
    for (int i = 0; i < arm_count; ++i) {
        found.newton_mm[i] = carried[i] * dot(pose.link[i], pose.swing[i]);
        greatest = larger(greatest, absolute(found.newton_mm[i]));
    }
    Real share = 1;
    if (greatest > greatest_torque) {
        share = greatest_torque / greatest;
        found.limited = true;
        for (Real& torque : found.newton_mm)
            torque = clamped(share * torque, -greatest_torque, greatest_torque);
    }
    found.force = share * wanted;
    return found;
}

template FiveBarPose<float> locate(const FiveBar<float>&, const float (&)[arm_count]);
template Torques<float> torques(const FiveBarPose<float>&, Vec<float>, float, float);
#if __STDC_HOSTED__
template FiveBarPose<double> locate(const FiveBar<double>&, const double (&)[arm_count]);
template Torques<double> torques(const FiveBarPose<double>&, Vec<double>, double, double);
#endif

} // namespace tp::pad
