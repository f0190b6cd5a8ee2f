// SPDX-License-Identifier: Apache-2.0
#include "app/figures/report/csv_table.hpp"

#include "core/files/durable_file.hpp"

#include <QByteArray>
#include <QString>

namespace tp {

namespace {

QByteArray field(const std::string& text) {
    QByteArray bytes = QByteArray::fromStdString(text);
    if (bytes.contains(',') || bytes.contains('"') || bytes.contains('\n'))
        bytes = '"' + bytes.replace('"', "\"\"") + '"';
    return bytes;
}

} // namespace

std::string cell(double value, int digits) { return QString::number(value, 'g', digits).toStdString(); }

Result<std::filesystem::path> CsvTable::write(const std::filesystem::path& file) const {
    QByteArray text;
    for (const auto& row : rows_) {
        QByteArray line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += (i == 0 ? QByteArray() : QByteArray(",")) + field(row[i]);
        text += line + '\n';
    }
    if (const std::string reason = replace_file(file, text.toStdString()); !reason.empty())
        return Error{"The table " + file.string() + " cannot be written: " + reason};
    return file;
}

} // namespace tp
