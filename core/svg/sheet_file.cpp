// SPDX-License-Identifier: Apache-2.0
#include "core/files/durable_file.hpp"
#include "core/files/file_words.hpp"
#include "core/files/whole_file.hpp"
#include "core/svg/contour_sheet.hpp"
#include "core/svg/sheet_limits.hpp"

#include <cmath>
#include <exception>
#include <string>

namespace tp {

namespace fs = std::filesystem;

Result<ContourSheet> read_sheet(const fs::path& file, ContourSheet::Unit unit) {
    try {
        const Result<std::string> text = read_whole(file, svg::most_bytes);
        return text ? sheet_from_svg(*text, unit) : Error{text.error()};
    } catch (const std::exception&) {
        return Error{"The drawing could not be read: there is not enough memory for it."};
    }
}

Result<fs::path> write_sheet(const fs::path& file, const ContourSheet& sheet) {
    try {
        if (!(sheet.width > 0.0) || !(sheet.height > 0.0) || !std::isfinite(sheet.width) ||
            !std::isfinite(sheet.height))
            return Error{"The drawing cannot be saved: it needs a width and a height larger than zero."};
        const std::string reason = replace_file(file, sheet_to_svg(sheet));
        return reason.empty() ? Result<fs::path>(file)
                              : Error{"The drawing cannot be saved as " + quoted(file) + ": " + reason};
    } catch (const std::exception&) {
        return Error{"The drawing cannot be saved: there is not enough memory for it."};
    }
}

} // namespace tp
