// SPDX-License-Identifier: Apache-2.0
#include "core/base/windows/overlapped_io.hpp"
#include "core/base/windows/wide_text.hpp"
#include "device/haply_2diy/found_boards.hpp"

#include <algorithm>
#include <array>
#include <cfgmgr32.h>
#include <setupapi.h>

namespace tp {

namespace {

/// Class of the serial and parallel ports (GUID_DEVCLASS_PORTS of devguid.h).
constexpr GUID ports_class{0x4d36e978, 0xe325, 0x11ce, {0xbf, 0xc1, 0x08, 0x00, 0x2b, 0xe1, 0x03, 0x18}};

std::string instance_of(DEVINST device) {
    std::array<wchar_t, MAX_DEVICE_ID_LEN + 1> name{};
    return CM_Get_Device_IDW(device, name.data(), MAX_DEVICE_ID_LEN, 0) == CR_SUCCESS
               ? windows::narrow(name.data())
               : std::string();
}

/// That of the port itself or, where it is one of several functions of a device, of that device.
std::string serial_number_of(const SP_DEVINFO_DATA& port, const std::string& instance) {
    const std::string own = serial_number_in(instance);
    DEVINST whole = 0;
    if (!own.empty() || CM_Get_Parent(&whole, port.DevInst, 0) != CR_SUCCESS)
        return own;
    const std::string above = instance_of(whole);
    return is_arduino_instance(above) ? serial_number_in(above) : std::string();
}

/// "COM7"; empty where it has none.
std::string port_name(HDEVINFO devices, SP_DEVINFO_DATA& port) {
    HKEY settings = SetupDiOpenDevRegKey(devices, &port, DICS_FLAG_GLOBAL, 0, DIREG_DEV, KEY_QUERY_VALUE);
    if (settings == INVALID_HANDLE_VALUE)
        return {};
    std::array<wchar_t, 32> name{};
    DWORD bytes = sizeof name;
    const LSTATUS problem =
        RegGetValueW(settings, nullptr, L"PortName", RRF_RT_REG_SZ, nullptr, name.data(), &bytes);
    RegCloseKey(settings);
    return problem == ERROR_SUCCESS ? windows::narrow(name.data()) : std::string();
}

} // namespace

std::vector<FoundBoard> find_boards() {
    std::vector<FoundBoard> boards;
    const HDEVINFO devices = SetupDiGetClassDevsW(&ports_class, nullptr, nullptr, DIGCF_PRESENT);
    if (devices == INVALID_HANDLE_VALUE)
        return boards;
    SP_DEVINFO_DATA port{};
    port.cbSize = sizeof port;
    for (DWORD i = 0; SetupDiEnumDeviceInfo(devices, i, &port) != 0; ++i) {
        std::array<wchar_t, MAX_DEVICE_ID_LEN + 1> name{};
        SetupDiGetDeviceInstanceIdW(devices, &port, name.data(), MAX_DEVICE_ID_LEN, nullptr);
        const std::string instance = windows::narrow(name.data());
        const std::string path = is_arduino_instance(instance) ? port_name(devices, port) : std::string();
        if (path.starts_with("COM"))
            boards.push_back({path, serial_number_of(port, instance)});
    }
    SetupDiDestroyDeviceInfoList(devices);
    std::sort(boards.begin(), boards.end(),
              [](const FoundBoard& a, const FoundBoard& b) { return a.path < b.path; });
    return boards;
}

} // namespace tp
