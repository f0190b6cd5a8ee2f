// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/explore/explore_session.hpp"
#include "audio/speech/recording_voice.hpp"
#include "fake_loudspeaker.hpp"

#include <memory>
#include <vector>

/// Everything that sounds below a session, where a test can listen.
struct ExploreSounds {
    tp::testing::FakeLoudspeaker earcon_output, guide_output;
    tp::EarconPlayer earcons{earcon_output};
    tp::SonifiedGuide guide{guide_output};
    tp::Preferences preferences;

    /// The loudest of the guide's next `seconds`.
    double guide_peak(double seconds = 0.3);
    /// Whether that earcon begins within the next 300 ms.
    bool hears(tp::Earcon earcon);
};

/// A photograph of 200 × 150 px with `faces` square faces side by side. With one face its outline is a
/// straight line 40 px below its eyes' centres; eyes and lips are squares. Nothing has to be found on it.
std::shared_ptr<const tp::LoadedPhoto> drawn_photo(int faces = 1, std::vector<QString> names = {});

/// Settings for which a busy test machine is never too late.
tp::ExploreSettings patient_settings();
/// The same with the time in a variable.
tp::ExploreSettings settings_at(const double& time);

/// Distance of a place in the sheet's frame to a contour of what is felt, mm.
double distance_to_feature(const tp::ExploreSession& session, int feature, QPointF place);
