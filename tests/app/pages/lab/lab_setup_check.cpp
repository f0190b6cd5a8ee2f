// SPDX-License-Identifier: Apache-2.0
#include "lab_setup_check.hpp"

#include "app/pages/lab/lab_setup.hpp"

namespace tp::test {

std::string complaint_about_setup(std::string_view bytes) {
    const Result<LabSetup> setup = parse_setup(bytes);
    if (!setup)
        return setup.error().empty() ? "An error has no words." : "";
    for (const LabNumber& number : lab_numbers()) {
        const double value = setup->parameters.*number.member;
        if (!(value >= number.lowest && value <= number.highest))
            return std::string("Out of bounds: ") + number.key;
    }
    if (setup->scene.names.size() != setup->scene.lines.size())
        return "Lines without names.";
    const Result<LabSetup> again = parse_setup(setup_json(*setup));
    if (!again)
        return "What was written cannot be read: " + again.error();
    if (!(again->parameters == setup->parameters) || again->real_device != setup->real_device ||
        again->scene_name != setup->scene_name || again->scene.names != setup->scene.names)
        return "What was written reads differently.";
    for (std::size_t i = 0; i < setup->scene.lines.size(); ++i)
        if (again->scene.lines[i].points != setup->scene.lines[i].points ||
            again->scene.lines[i].closed != setup->scene.lines[i].closed)
            return "A line reads differently.";
    if (bytes.size() < 4000) // a law over many lines takes its time
        if (const auto felt = felt_scene(setup->scene, setup->parameters))
            if (!is_finite((*felt)->law->at({1.0, 2.0}).force))
                return "A force is not a number.";
    return {};
}

} // namespace tp::test
