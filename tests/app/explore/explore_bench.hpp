// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/explore/explore_session.hpp"
#include "audio/speech/recording_voice.hpp"

#include <memory>

/// A photograph of 200 × 150 px with `faces` square faces side by side. With one face its outline is a
/// straight line 40 px below its eyes' centres; eyes and lips are squares. Nothing has to be found on it.
std::shared_ptr<const tp::LoadedPhoto> drawn_photo(int faces = 1);

/// Settings for which a busy test machine is never too late.
tp::ExploreSettings patient_settings();

/// Distance of a place in the sheet's frame to a contour of what is felt, mm.
double distance_to_feature(const tp::ExploreSession& session, int feature, QPointF place);
