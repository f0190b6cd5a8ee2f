// SPDX-License-Identifier: Apache-2.0
#include "photo_check.hpp"

#include "app/album/metadata/read_record.hpp"
#include "memory_folder.hpp"
#include "sidecar_check.hpp"

namespace tp::test {

std::string complaint_about_photo(std::string_view bytes) {
    static const MemoryFolder folder;
    const auto record = read_record(folder.file("IMG_1.jpg", bytes));
    if (!record)
        return record.error().ends_with('.') ? "" : "refused without a sentence: " + record.error();
    if (record->orientation < 1 || record->orientation > 8 || record->width < 0 || record->height < 0)
        return "a shape that no picture has";
    return complaint_about_record(*record);
}

} // namespace tp::test
