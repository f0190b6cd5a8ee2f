// SPDX-License-Identifier: Apache-2.0
#include "corpus.hpp"
#include "device/touch_output/hid_haptics/haptics_reports.hpp"
#include "device/touch_output/hid_haptics/model_haptic_pad.hpp"
#include "layout_check.hpp"
#include "places.hpp"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

using namespace tp;
using namespace tp::haptics;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Empty where it can be used, or why not.
std::string found(std::span<const std::uint8_t> descriptor, Layout& layout) {
    hid::ReportDescriptor parsed;
    if (hid::parse_report_descriptor(descriptor, parsed) != hid::DescriptorFault::none)
        return "cannot be read";
    const char* const why_not = find_layout(parsed, layout);
    return why_not == nullptr ? std::string() : why_not;
}

Layout of_model() {
    Layout layout;
    found(ModelHapticPad::descriptor(), layout);
    return layout;
}

/// The model's descriptor with `from` as `to`.
Bytes with(const Bytes& from, const Bytes& to) {
    Bytes bytes(ModelHapticPad::descriptor().begin(), ModelHapticPad::descriptor().end());
    for (auto at = bytes.begin();
         (at = std::search(at, bytes.end(), from.begin(), from.end())) != bytes.end(); ++at)
        std::copy(to.begin(), to.end(), at);
    return bytes;
}

/// A pen as Microsoft's guide for haptic pens has it: the list is of constants, whose physical range is the waveform.
Bytes pen() {
    return {0x05, 0x0D, 0x09, 0x02, 0xA1, 0x01, 0x05, 0x0E, 0x09, 0x01, 0xA1, 0x02, 0x85, 0x40, 0x09,
            0x10, 0xA1, 0x02, 0x05, 0x0A, 0x09, 0x03, 0x95, 0x01, 0x75, 0x08, 0x15, 0x03, 0x25, 0x03,
            0x37, 0x03, 0x10, 0x0E, 0x00, 0x47, 0x03, 0x10, 0x0E, 0x00, 0xB1, 0x03, 0xC0, 0x05, 0x0E,
            0x35, 0x00, 0x45, 0x00, 0x15, 0x00, 0x25, 0x03, 0x09, 0x21, 0x91, 0x02, 0xC0, 0xC0};
}

} // namespace

class HapticsLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void a_pad_says_where_everything_is() {
        const Layout layout = of_model();
        QCOMPARE(int(layout.trigger.id), 3);
        QCOMPARE(layout.trigger.bytes, std::size_t(5));
        QVERIFY(layout.trigger.intensity.there());
        QCOMPARE(layout.waveforms.size(), std::size_t(4));
        QVERIFY(layout.pad && layout.pad->fingers.size() == 2 && layout.pad->button.there());
        QVERIFY(distance(layout.pad->size, Vec2(100.0, 60.0)) < 1e-9);
    }

    void a_finger_is_where_it_lies() {
        const Layout layout = of_model();
        ModelHapticPad model;
        model.touch(0, {-30.0, 20.0});
        model.touch(1, {45.0, -25.0}, true);
        Bytes report;
        while (!model.report(report))
            model.step();
        const auto fingers = fingers_in(layout, report);
        QVERIFY(fingers && fingers->pressed);
        QVERIFY(fingers->fingers[0].there && fingers->fingers[1].there && !fingers->fingers[2].there);
        QVERIFY(distance(fingers->fingers[0].place, Vec2(-30.0, 20.0)) < 0.04);
        QVERIFY(distance(fingers->fingers[1].place, Vec2(45.0, -25.0)) < 0.04);
        QVERIFY(fingers->fingers[0].contact != fingers->fingers[1].contact);
        report[0] = 2;
        QVERIFY(!fingers_in(layout, report)); // another report
        report[0] = 1;
        report.resize(9);
        QVERIFY(!fingers_in(layout, report)); // cut short
        QVERIFY(!fingers_in(layout, {}));
    }

    void the_waveform_is_the_nearest_to_the_sharpness_that_there_is() {
        const Ordinals all{5, 4, 3};
        QCOMPARE(int(all.of(1.0)), 5);
        QCOMPARE(int(all.of(0.5)), 4);
        QCOMPARE(int(all.of(0.0)), 3);
        const Ordinals click_only{5, 0, 0};
        QCOMPARE(int(click_only.of(0.0)), 5);
        QVERIFY(!Ordinals{}.any());
    }

    void the_list_is_read_from_the_device() {
        const Layout layout = of_model();
        ModelHapticPad model;
        const auto report_of = [&model](std::uint8_t id, std::size_t) { return model.feature(id); };
        Ordinals ordinals = read_ordinals(layout, report_of);
        QCOMPARE(int(ordinals.press), 3);
        QCOMPARE(int(ordinals.click), 4);
        QCOMPARE(int(ordinals.hover), 5);
        model.waveforms = {0x1004, 0x1005, 0x2001,
                           0x100B}; // all go on until they are stopped, or are the maker's own
        ordinals = read_ordinals(layout, report_of);
        QVERIFY(!ordinals.any());
        QVERIFY(!read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{}; }).any());
        QVERIFY(
            !read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{0x03}; }).any()); // cut short
    }

    void a_pen_whose_list_is_made_of_constants_can_be_used() {
        Layout layout;
        QCOMPARE(found(pen(), layout), std::string());
        QVERIFY(!layout.pad && !layout.trigger.intensity.there());
        const Ordinals ordinals = read_ordinals(layout, [](std::uint8_t, std::size_t) { return Bytes{3}; });
        QCOMPARE(int(ordinals.click), 3);
        const Output report = trigger(layout, ordinals.of(0.3), 0.5);
        QCOMPARE(report.size, std::size_t(2));
        QCOMPARE(int(report.bytes[0]), 0x40);
        QCOMPARE(int(report.bytes[1]), 3);
    }

    void what_cannot_be_used_says_why() {
        Layout layout;
        QVERIFY(found(ModelHapticPad::descriptor_without_trigger(), layout).find("takes no ticks") !=
                std::string::npos);
        QVERIFY(found(with({0x25, 0x07}, {0x25, 0x02}), layout).find("cannot be right") != std::string::npos);
        QVERIFY(found(with({0x09, 0x10, 0xA1}, {0x09, 0x11, 0xA1}), layout).find("which ticks it has") !=
                std::string::npos);
    }

    void a_pad_that_does_not_tell_its_size_ticks_without_telling_places() {
        Layout layout;
        QCOMPARE(found(with({0x65, 0x11}, {0x65, 0x00}), layout), std::string());
        QVERIFY(!layout.pad);
        QCOMPARE(found(with({0x55, 0x0E}, {0x55, 0x07}), layout), std::string()); // 100 000 km
        QVERIFY(!layout.pad);
    }

    void any_bytes_are_read() {
        std::mt19937 random(11);
        const auto model = ModelHapticPad::descriptor();
        for (int i = 0; i < 30000; ++i) {
            std::string bytes(1, static_cast<char>((model.size() + 3) / 4));
            bytes.append(reinterpret_cast<const char*>(model.data()), model.size());
            bytes.resize(1 + 4 * ((model.size() + 3) / 4), '\0');
            for (int k = 0; k < 24; ++k)
                bytes.push_back(static_cast<char>(random()));
            for (unsigned k = 0; k < random() % 6; ++k)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            const std::string complaint = test::complaint_about_haptics(bytes);
            QVERIFY2(complaint.empty(), complaint.c_str());
        }
        const auto seeds =
            tp::test::corpus(tp::test::in_source("tests/device/touch_output/hid_haptics/corpus"));
        QVERIFY(seeds.size() >= 4);
        for (const tp::test::Seed& seed : seeds)
            QCOMPARE(seed.name + ": " + test::complaint_about_haptics(seed.text), seed.name + ": ");
    }
};

QTEST_APPLESS_MAIN(HapticsLayoutTest)
#include "haptics_layout_test.moc"
