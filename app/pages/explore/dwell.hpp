// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tp {

/// Lets a finger pass over a feature in silence: it is told once the finger has stayed, and once a stay.
class Dwell {
public:
    static constexpr double usual_s = 0.150;

    /// `seconds` ≥ 0: how long a finger must stay.
    explicit Dwell(double seconds = usual_s) : seconds_(seconds) {}

    /// The finger is on `feature` at `now` seconds, or on none (-1). The feature to tell now; -1 for none.
    int follow(int feature, double now) {
        if (feature != feature_) {
            feature_ = feature;
            since_ = now;
            told_ = false;
        }
        if (feature_ < 0 || told_ || now - since_ < seconds_)
            return -1;
        told_ = true;
        return feature_;
    }
    /// The finger is on `feature`, and that was told already.
    void settle(int feature) {
        feature_ = feature;
        told_ = true;
    }

private:
    double seconds_;
    int feature_ = -1;
    double since_ = 0.0;
    bool told_ = true;
};

} // namespace tp
