// SPDX-License-Identifier: Apache-2.0
#include "device/hid/hidraw_descriptor.hpp"

#include "device/hid/report_descriptor.hpp"

#include <cstdio>

namespace tp::hid {

std::vector<std::uint8_t> hidraw_descriptor(const std::string& path) {
    std::vector<std::uint8_t> bytes;
    const std::string node = path.substr(path.rfind('/') + 1);
    std::FILE* const file =
        std::fopen(("/sys/class/hidraw/" + node + "/device/report_descriptor").c_str(), "rb");
    if (file == nullptr)
        return bytes;
    bytes.resize(most_descriptor_bytes + 1); // one more shows that it is too long
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
    std::fclose(file);
    return bytes;
}

} // namespace tp::hid
