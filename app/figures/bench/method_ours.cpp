// SPDX-License-Identifier: Apache-2.0
#include "app/figures/bench/nearest_method.hpp"

namespace tp {

namespace {

class AnyDistance final : public LoopingMethod<AnyDistance> {
public:
    explicit AnyDistance(const FlatScene& scene) : index_(scene) {}
    Nearest answer(Vec2 place) const { return index_.nearest(place); }
    std::size_t bytes() const override { return index_.bytes(); }

private:
    ContourIndex index_;
};

class WithinBand final : public LoopingMethod<WithinBand> {
public:
    explicit WithinBand(const FlatScene& scene) : index_(scene) {}
    Nearest answer(Vec2 place) const { return index_.nearest_within(place, index_.band_mm()); }
    std::size_t bytes() const override { return index_.bytes(); }
    double reach() const override { return index_.band_mm(); }

private:
    ContourIndex index_;
};

} // namespace

std::unique_ptr<NearestMethod> make_ours(const FlatScene& scene, bool within_band) {
    if (within_band)
        return std::make_unique<WithinBand>(scene);
    return std::make_unique<AnyDistance>(scene);
}

} // namespace tp
