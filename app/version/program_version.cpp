// SPDX-License-Identifier: Apache-2.0
#include "app/version/program_version.hpp"

#include "core/version/version.hpp"

#include <QtGlobal>

#include <exiv2/exiv2.hpp>
#include <opencv2/core.hpp>

#include <archive.h>
#include <liblouis.h>
#include <libusb.h>
#include <sndfile.h>

namespace tp {

namespace {

std::string usb_library_version() {
    const libusb_version* const has = libusb_get_version();
    return std::to_string(has->major) + '.' + std::to_string(has->minor) + '.' + std::to_string(has->micro);
}

} // namespace

std::string program_version(const std::string& program) {
    return version_line(program) + "\nQt " + qVersion() + ", OpenCV " + cv::getVersionString() + ", Exiv2 " +
           Exiv2::versionString() + ",\n" + sf_version_string() + ", " + archive_version_string() +
           ", liblouis " + lou_version() + ", libusb " + usb_library_version() + "\n";
}

} // namespace tp
